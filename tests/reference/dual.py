"""Numbers with exact derivatives: a value of 40 digits, real or complex, and its gradient, a sparse map from input to derivative.

Rules of differentiation are written out, so nothing is shared with the program that is held against this.
"""
import functools

import mpmath as mp

mp.mp.dps = 40  # of all modules


@functools.total_ordering
class Dual:
    __slots__ = ("v", "g")

    def __init__(self, value, gradient=None):
        self.v, self.g = value if isinstance(value, mp.mpc) else mp.mpf(value), gradient or {}

    @staticmethod
    def of(x):
        return x if isinstance(x, Dual) else Dual(x)

    def chain(self, value, slope):
        return Dual(value, {k: slope * d for k, d in self.g.items()})

    def joined(self, other, value, slope, slope_of_other):
        """A function of two numbers, from its value and its two partial derivatives."""
        g = {k: slope * d for k, d in self.g.items()}
        for k, d in other.g.items():
            g[k] = g.get(k, 0) + slope_of_other * d
        return Dual(value, g)

    def __add__(self, o):
        o = Dual.of(o)
        g = dict(self.g)
        for k, d in o.g.items():
            g[k] = g[k] + d if k in g else d
        return Dual(self.v + o.v, g)

    def __neg__(self):
        return self.chain(-self.v, -1)

    def __sub__(self, o):
        return self + (-Dual.of(o))

    def __mul__(self, o):
        o = Dual.of(o)
        return self.joined(o, self.v * o.v, o.v, self.v)

    def __truediv__(self, o):
        o = Dual.of(o)
        return self * o.chain(1 / o.v, -1 / o.v ** 2)

    def __pow__(self, o):
        o = Dual.of(o)
        if not o.g:
            n = o.v
            return self.chain(self.v ** n, n * self.v ** (n - 1) if n != 0 else mp.mpf(0))
        return exp(o * log(self))

    __radd__ = __add__
    __rmul__ = __mul__

    def __rsub__(self, o):
        return Dual.of(o) - self

    def __rtruediv__(self, o):
        return Dual.of(o) / self

    def __eq__(self, o):
        return self.v == Dual.of(o).v

    def __lt__(self, o):
        return self.v < Dual.of(o).v


def elementary(function, slope):
    """A function of one number, from the function of its value and the derivative."""
    def of(x):
        x = Dual.of(x)
        return x.chain(function(x.v), slope(x.v))
    return of


exp = elementary(mp.exp, mp.exp)
log = elementary(mp.log, lambda v: 1 / v)
sin = elementary(mp.sin, mp.cos)
cos = elementary(mp.cos, lambda v: -mp.sin(v))
tan = elementary(mp.tan, lambda v: 1 / mp.cos(v) ** 2)
asin = elementary(mp.asin, lambda v: 1 / mp.sqrt(1 - v ** 2))
acos = elementary(mp.acos, lambda v: -1 / mp.sqrt(1 - v ** 2))
atan = elementary(mp.atan, lambda v: 1 / (1 + v ** 2))
sinh = elementary(mp.sinh, mp.cosh)
cosh = elementary(mp.cosh, mp.sinh)
tanh = elementary(mp.tanh, lambda v: 1 / mp.cosh(v) ** 2)


def sqrt(x):
    x = Dual.of(x)
    return x ** mp.mpf("0.5") if x.v else Dual(0)


def atan2(y, x):
    y, x = Dual.of(y), Dual.of(x)
    r2 = x.v ** 2 + y.v ** 2
    return y.joined(x, mp.atan2(y.v, x.v), x.v / r2, -y.v / r2)


def hypot(*parts):
    return sqrt(sum((Dual.of(p) * Dual.of(p) for p in parts), Dual(0)))


def part(x, of):
    """Real or imaginary part: linear, so the parts of derivatives."""
    x = Dual.of(x)
    return Dual(of(mp.mpc(x.v)), {k: of(mp.mpc(d)) for k, d in x.g.items()})


def re(x):
    return part(x, lambda z: z.real)


def im(x):
    return part(x, lambda z: z.imag)


def complex_(a, b):
    return Dual.of(a) + Dual.of(b) * Dual(mp.mpc(0, 1))


def magnitude(x):
    x = Dual.of(x)
    return hypot(re(x), im(x)) if isinstance(x.v, mp.mpc) else x if x.v >= 0 else -x


COMPLEX = {"re": re, "im": im, "complex": complex_, "polar": lambda r, phi: complex_(r * cos(phi), r * sin(phi)),
           "conj": lambda z: complex_(re(z), -im(z)), "arg": lambda z: atan2(im(z), re(z)), "abs": magnitude}
