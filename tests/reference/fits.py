"""Orthogonal least squares of forms to points. The sum of squares is least where its derivatives G are zero: Newton's method on G in 40 digits, then the
derivatives of the solution, -(dG/dp)^-1 dG/dx, both by central differences (error about 1e-26). The results of the program are where it begins."""
import mpmath as mp

from dual import Dual, cos, hypot, sin
from vectors import NORMAL, across, cross, dot, minus, plus, scaled, unit, values, without

STEP = mp.mpf("1e-13")


class Form:
    """Parameters: the mean of the points, tilts a, b of the direction, shifts u, v of the axis from the mean, radius, half the angle of a cone."""
    PARAMETERS = {"point": "", "plane": "ab", "line": "ab", "circle": "abuvr", "sphere": "wuvr", "cylinder": "abuvr", "cone": "abuvrt"}
    FREE = {"point": 3, "plane": 3, "line": 4, "circle": 3, "sphere": 4, "cylinder": 5, "cone": 6}

    def __init__(self, kind, start):
        self.kind, self.names = kind, self.PARAMETERS[kind]
        self.n_0 = unit([Dual(start.get(n, int(n == "n_z"))) for n in NORMAL])
        self.e = across(self.n_0)

    def placed(self, p):
        """(direction, point of the axis or centre, radius, half angle) of parameters p, a list of mean and names."""
        q = dict.fromkeys("abuvw", 0) | dict(zip(self.names, p[3:]))
        n, f = unit(plus(self.n_0, scaled(self.e[0], q["a"]), scaled(self.e[1], q["b"]))), self.e
        if self.kind == "circle":
            x = unit(without(self.e[0], n))
            f = x, cross(n, x)
        return n, plus(p[:3], scaled(f[0], q["u"]), scaled(f[1], q["v"]), scaled(self.n_0, q["w"])), q.get("r"), q.get("t")

    def residuals(self, p, x):
        """[(parameters that they decide, deviations)]"""
        n, c, r, t = self.placed(p)
        d = minus(x, c)
        if self.kind == "point":
            return [("", d)]
        along, radial = dot(n, d), d if self.kind == "sphere" else without(d, n)
        if self.kind == "plane":
            return [("ab", [along])]
        if self.kind == "line":
            return [("ab", radial)]
        gap = hypot(*radial) - r
        if self.kind == "circle":
            return [("ab", [along]), ("uvr", [gap])]
        return [(self.names, [gap * cos(t) - along * sin(t) if self.kind == "cone" else gap])]

    def gradient(self, p, x):
        """This point's part of G: of the mean x - m, of the others the derivative of half the sum of squares."""
        seeded = [Dual(value, {i: mp.mpf(1)}) for i, value in enumerate(p)]
        g = minus(x, p[:3]) + [mp.mpf(0)] * len(self.names)
        for names, deviations in self.residuals(seeded, [Dual(value) for value in x]):
            for name in names:
                k = 3 + self.names.index(name)
                g[k] += mp.fsum(d.v * d.g.get(k, 0) for d in deviations)
        return mp.matrix(g)


def central(function, at, i):
    higher, lower = list(at), list(at)
    higher[i], lower[i] = at[i] + STEP, at[i] - STEP
    return (function(higher) - function(lower)) / (2 * STEP)


def fitted(kind, start, points):
    """(form, parameters as duals) of points that are duals."""
    form, x = Form(kind, start), [values(point) for point in points]
    centre = [mp.fsum(c) / len(x) for c in zip(*x)]
    shift = minus([start[axis] for axis in "xyz"], centre)
    begin = {"a": 0, "b": 0, "r": start.get("d", 0) / 2, "t": start.get("alpha", 0) / 2}
    begin |= {name: dot(e, shift).v for name, e in zip("uvw", (*form.e, form.n_0))}
    p = centre + [mp.mpf(begin[name]) for name in form.names]
    total = lambda q: sum((form.gradient(q, point) for point in x), mp.zeros(len(p), 1))
    inverse_slopes = lambda: mp.matrix([list(central(total, p, i)) for i in range(len(p))]).T ** -1
    for _ in range(4):  # the slopes of where it begins, then those of where it came to
        inverse = inverse_slopes()
        for _ in range(6):
            step = inverse * total(p)
            p = minus(p, step)
            if mp.norm(step) < mp.mpf(10) ** -36:
                break
        else:
            continue
        break
    inverse = inverse_slopes()
    found = p
    for point, at in zip(points, x):
        for i in range(3):
            slopes = inverse * central(lambda q: form.gradient(p, q), at, i)
            found = minus(found, scaled(slopes, Dual(0, point[i].g)))
    return form, found
