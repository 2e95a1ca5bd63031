"""Orthogonal least squares of forms to points. The sum of squares is least where its derivatives G are zero: Newton's method on G in 40 digits, then the
derivatives of the solution, -(dG/dp)^-1 dG/dx, both by central differences (error about 1e-26). The results of the program are where it begins."""
import mpmath as mp

from dual import Dual, cos, sin
from poses import cross, dot, minus, plus, unit

STEP = mp.mpf("1e-13")


def across(n):
    """Two directions that complete n to a frame."""
    e = [Dual(int(i == min(range(3), key=lambda j: abs(n[j].v)))) for i in range(3)]
    a = unit(cross(n, e))
    return a, cross(n, a)


def scaled(a, factor):
    return [x * factor for x in a]


class Form:
    """Parameters: the mean of the points, tilts a, b of the direction, shifts u, v of the axis from the mean, radius, half the angle of a cone."""
    PARAMETERS = {"point": "", "plane": "ab", "line": "ab", "circle": "abuvr", "sphere": "wuvr", "cylinder": "abuvr", "cone": "abuvrt"}
    FREE = {"point": 3, "plane": 3, "line": 4, "circle": 3, "sphere": 4, "cylinder": 5, "cone": 6}

    def __init__(self, kind, start):
        self.kind, self.names = kind, self.PARAMETERS[kind]
        self.n_0 = unit([Dual(start.get("n_" + axis, int(axis == "z"))) for axis in "xyz"])
        self.e = across(self.n_0)

    def placed(self, p):
        """(direction, point of the axis or centre, radius, half angle) of parameters p, a list of mean and names."""
        mean, q = p[:3], dict(zip(self.names, p[3:]))
        n = unit(plus(plus(self.n_0, scaled(self.e[0], q["a"])), scaled(self.e[1], q["b"]))) if "a" in q else self.n_0
        if self.kind == "circle":
            f = unit(minus(self.e[0], scaled(n, dot(n, self.e[0]))))
            f = f, cross(n, f)
        else:
            f = self.e
        c = plus(plus(mean, scaled(f[0], q["u"])), scaled(f[1], q["v"])) if "u" in q else mean
        if "w" in q:
            c = plus(c, scaled(self.n_0, q["w"]))
        return n, c, q.get("r"), q.get("t")

    def residuals(self, p, x):
        """[(parameters that they decide, deviations)]"""
        n, c, r, t = self.placed(p)
        d = minus(x, c)
        if self.kind == "point":
            return [("", d)]
        if self.kind in ("plane", "circle"):
            found = [("ab", [dot(n, d)])]
        if self.kind == "plane":
            return found
        radial = d if self.kind == "sphere" else minus(d, scaled(n, dot(n, d)))
        if self.kind == "line":
            return [("ab", radial)]
        rho = dot(radial, radial) ** mp.mpf("0.5")
        if self.kind == "circle":
            return found + [("uvr", [rho - r])]
        if self.kind == "cone":
            return [(self.names, [(rho - r) * cos(t) - dot(n, d) * sin(t)])]
        return [(self.names, [rho - r])]

    def gradient(self, p, x, count):
        """This point's part of G: of the mean x - m, of the others the derivative of half the sum of squares."""
        seeded = [Dual(value, {i: mp.mpf(1)}) for i, value in enumerate(p)]
        g = [x[i] - p[i] for i in range(3)] + [mp.mpf(0)] * len(self.names)
        for names, deviations in self.residuals(seeded, [Dual(value) for value in x]):
            for name in names:
                k = 3 + self.names.index(name)
                g[k] += mp.fsum(d.v * d.g.get(k, 0) for d in deviations)
        return mp.matrix(g)


def central(function, values, i):
    higher, lower = list(values), list(values)
    higher[i], lower[i] = values[i] + STEP, values[i] - STEP
    return (function(higher) - function(lower)) / (2 * STEP)


def fitted(kind, start, points):
    """(form, parameters as duals) of points that are duals."""
    form, x, count = Form(kind, start), [[c.v for c in point] for point in points], len(points)
    p = [mp.fsum(point[i] for point in x) / count for i in range(3)]
    centre = [Dual(start[axis]) for axis in "xyz"]
    shift = minus(centre, [Dual(value) for value in p])
    begin = {"a": 0, "b": 0, "u": dot(form.e[0], shift).v, "v": dot(form.e[1], shift).v, "w": dot(form.n_0, shift).v, "r": start.get("d", 0) / 2,
             "t": start.get("alpha", 0) / 2}
    p += [mp.mpf(begin[name]) for name in form.names]
    total = lambda q: sum((form.gradient(q, point, count) for point in x), mp.zeros(len(p), 1))
    jacobian = lambda: mp.matrix([[column[k] for column in columns] for k in range(len(p))]) if (
        columns := [central(total, p, i) for i in range(len(p))]) else None
    inverse = jacobian() ** -1
    for _ in range(3):
        p = [value - step for value, step in zip(p, inverse * total(p))]
    inverse = jacobian() ** -1
    found = [Dual(value) for value in p]
    for point, at in zip(points, x):
        for i in range(3):
            slopes = -inverse * central(lambda q: form.gradient(p, q, count), at, i)
            deviation = Dual(0, point[i].g)
            found = [value + deviation * slope for value, slope in zip(found, slopes)]
    return form, found
