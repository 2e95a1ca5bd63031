"""Numbers with exact derivatives: a value of 40 digits, real or complex, and its gradient, a sparse map from input to derivative.

Rules of differentiation are written out, so nothing is shared with the program that is held against this.
"""
import mpmath as mp

mp.mp.dps = 40


class Dual:
    __slots__ = ("v", "g")

    def __init__(self, value, gradient=None):
        self.v, self.g = value if isinstance(value, mp.mpc) else mp.mpf(value), gradient or {}

    @staticmethod
    def of(x):
        return x if isinstance(x, Dual) else Dual(x)

    def chain(self, value, slope):
        return Dual(value, {k: slope * d for k, d in self.g.items()})

    def __add__(self, o):
        o = Dual.of(o)
        g = dict(self.g)
        for k, d in o.g.items():
            g[k] = g.get(k, 0) + d
        return Dual(self.v + o.v, g)

    def __neg__(self):
        return self.chain(-self.v, -1)

    def __sub__(self, o):
        return self + (-Dual.of(o))

    def __mul__(self, o):
        o = Dual.of(o)
        g = {k: o.v * d for k, d in self.g.items()}
        for k, d in o.g.items():
            g[k] = g.get(k, 0) + self.v * d
        return Dual(self.v * o.v, g)

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

    def __lt__(self, o):
        return self.v < Dual.of(o).v

    def __le__(self, o):
        return self.v <= Dual.of(o).v

    def __gt__(self, o):
        return self.v > Dual.of(o).v

    def __ge__(self, o):
        return self.v >= Dual.of(o).v


def exp(x):
    x = Dual.of(x)
    return x.chain(mp.exp(x.v), mp.exp(x.v))


def log(x):
    x = Dual.of(x)
    return x.chain(mp.log(x.v), 1 / x.v)


def sqrt(x):
    x = Dual.of(x)
    root = mp.sqrt(x.v)
    return x.chain(root, 1 / (2 * root)) if root else Dual(0, {})


def sin(x):
    x = Dual.of(x)
    return x.chain(mp.sin(x.v), mp.cos(x.v))


def cos(x):
    x = Dual.of(x)
    return x.chain(mp.cos(x.v), -mp.sin(x.v))


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


def tan(x):
    return sin(x) / cos(x)


def atan2(y, x):
    y, x = Dual.of(y), Dual.of(x)
    r2 = x.v ** 2 + y.v ** 2
    g = {k: x.v / r2 * d for k, d in y.g.items()}
    for k, d in x.g.items():
        g[k] = g.get(k, 0) - y.v / r2 * d
    return Dual(mp.atan2(y.v, x.v), g)


def atan(x):
    x = Dual.of(x)
    return x.chain(mp.atan(x.v), 1 / (1 + x.v ** 2))


def asin(x):
    x = Dual.of(x)
    return x.chain(mp.asin(x.v), 1 / mp.sqrt(1 - x.v ** 2))


def acos(x):
    x = Dual.of(x)
    return x.chain(mp.acos(x.v), -1 / mp.sqrt(1 - x.v ** 2))


def hypot(*parts):
    return sqrt(sum((Dual.of(p) * Dual.of(p) for p in parts), Dual(0)))


def sinh(x):
    return (exp(x) - exp(-Dual.of(x))) / 2


def cosh(x):
    return (exp(x) + exp(-Dual.of(x))) / 2


def tanh(x):
    return sinh(x) / cosh(x)
