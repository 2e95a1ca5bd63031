"""The model "pose from points" with typed uncertainties: 3-2-1 (Porath et al., Eqs 9 to 23) and least squares."""
import mpmath as mp

from dual import Dual, atan2, cos, sin, sqrt
from equations import Inputs, rows
from units import factor


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Dual(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def plus(a, b):
    return [x + y for x, y in zip(a, b)]


def unit(a):
    length = sqrt(dot(a, a))
    return [x / length for x in a]


def times(m, v):
    return [dot(row, v) for row in m]


def transposed(m):
    return [list(column) for column in zip(*m)]


def product(a, b):
    columns = transposed(b)
    return [[dot(row, column) for column in columns] for row in a]


def rotation_zyx(alpha, beta, gamma):
    ca, sa, cb, sb, cg, sg = cos(alpha), sin(alpha), cos(beta), sin(beta), cos(gamma), sin(gamma)
    return [[cg * cb, cg * sb * sa - sg * ca, cg * sb * ca + sg * sa],
            [sg * cb, sg * sb * sa + cg * ca, sg * sb * ca - cg * sa], [-sb, cb * sa, cb * ca]]


def angles_zyx(r):
    return {"alpha": atan2(r[2][1], r[2][2]), "beta": atan2(-r[2][0], sqrt(r[0][0] ** 2 + r[1][0] ** 2)), "gamma": atan2(r[1][0], r[0][0])}


def of_vector(w):
    """Rotation by a small vector about zero, to second order: what one step of Newton's method needs."""
    one, none = Dual(1), Dual(0)
    k = [[none, -w[2], w[1]], [w[2], none, -w[0]], [-w[1], w[0], none]]
    square = product(k, k)
    return [[(one if i == j else none) + k[i][j] + square[i][j] / 2 for j in range(3)] for i in range(3)]


def three_two_one(points, side, shift):
    x = unit(minus(points[1], points[0]))
    third = minus(points[2], points[0])
    z = unit(cross(third, x) if side == "negative-y" else cross(x, third))
    r = transposed([x, cross(z, x), z])
    return r, plus(points[0], times(r, shift))


def least_squares(nominal, points, start):
    """R maximises sum q_i . R l_i about the centres. From the rotation without deviations, Newton's method on sum R l_i x q_i = 0, in
    dual numbers: values and derivatives of the solution converge together."""
    n = len(points)
    centre = lambda all_: [sum((p[i] for p in all_), Dual(0)) / n for i in range(3)]
    mean_l, mean_q = centre(nominal), centre(points)
    r = start
    for _ in range(4):
        turned = [times(r, minus(l, mean_l)) for l in nominal]
        apart = [minus(q, mean_q) for q in points]
        torque, matrix = [Dual(0)] * 3, [[mp.mpf(0)] * 3 for _ in range(3)]
        for a, q in zip(turned, apart):
            torque = plus(torque, cross(a, q))
            for i in range(3):
                for j in range(3):
                    matrix[i][j] += (dot(a, q).v if i == j else 0) - a[i].v * q[j].v / 2 - a[j].v * q[i].v / 2
        inverse = mp.matrix(matrix) ** -1
        step = [sum((torque[j] * Dual(inverse[i, j]) for j in range(3)), Dual(0)) for i in range(3)]
        turn = of_vector(step)
        r = product(turn, r)
        for _ in range(2):  # orthogonal again, to all digits
            x = unit(transposed(r)[0])
            z = unit(cross(x, transposed(r)[1]))
            r = transposed([x, cross(z, x), z])
    return r, minus(mean_q, times(r, mean_l))


class Points:
    """Points of one frame: where they are and the components of their deviations, along the axes of the frame."""

    def __init__(self, setup, frame, inputs):
        if setup.get(f"{frame}_uncertainty", "typed") != "typed":
            raise NotImplementedError("points of an artefact or instrument")
        self.setup, self.frame, self.inputs = setup, frame, inputs
        self.table = rows(setup[f"{frame}_points"])
        self.nominal = [[Dual(mp.mpf(repr(row[axis])) / 1000) for axis in "xyz"] for row in self.table]
        self.fit = setup.get(f"{frame}_fit", "three-two-one")
        self.side = setup.get(f"{frame}_third_point", "negative-y" if frame == "base" else "positive-y")
        self.shift = [Dual(self.length(f"{frame}_shift_{axis}")) for axis in "xyz"]

    def length(self, key):
        given = self.setup.get(key)
        return mp.mpf(0) if given is None else mp.mpf(repr(given["value"])) * factor(given["unit"])

    def measured(self, of_set, r, o):
        """The points in frame 0 with this pose of their frame."""
        found = []
        for i, row in enumerate(self.table):
            deviation = []
            for axis in "xyz":
                own = row.get(f"u_{axis}")
                u = self.length(f"{self.frame}_u_{axis}") if own is None else mp.mpf(repr(own)) / 1000
                common = self.setup.get(f"{self.frame}_common_{axis}", False)
                name = f"{self.frame} {axis}" if common else f"{self.frame} {of_set} {i} {axis}"
                if name not in self.inputs.estimate:
                    self.inputs.estimate[name] = mp.mpf(0)
                    self.inputs.add(name, u)
                deviation.append(Dual(0, {name: mp.mpf(1)}))
            found.append(plus(o, times(r, plus(self.nominal[i] if self.fit == "least-squares" else self.laid[i], deviation))))
        return found

    def frame_of(self, points, start):
        if self.fit == "least-squares":
            return least_squares(self.nominal, points, start)
        return three_two_one(points, self.side, self.shift)

    def lay(self):
        """Lays the nominal points into the frame that they define by 3-2-1."""
        r, o = three_two_one(self.nominal, self.side, self.shift)
        self.laid = [times(transposed(r), minus(p, o)) for p in self.nominal]


def evaluate(entry):
    setup, inputs = entry["setup"], Inputs()
    if setup.get("evaluation", "a-priori") != "a-priori" or setup.get("orientation", "zyx") != "zyx" or "base_pose" in setup:
        raise NotImplementedError("measured points, other angles, a base that stands somewhere")
    base, moving = Points(setup, "base", inputs), Points(setup, "moving", inputs)
    base.lay()
    moving.lay()
    identity = [[Dual(int(i == j)) for j in range(3)] for i in range(3)]
    r_b, o_b = base.frame_of(base.measured("base", identity, [Dual(0)] * 3), identity)
    results = {}
    for row in rows(setup["poses"]):
        r = rotation_zyx(*(mp.mpf(repr(row[a])) * mp.pi / 180 for a in ("alpha", "beta", "gamma")))
        o = [Dual(mp.mpf(repr(row[a])) / 1000) for a in "xyz"]
        r_p, o_p = moving.frame_of(moving.measured(row["name"], r, o), r)
        for axis, value in zip("xyz", times(transposed(r_b), minus(o_p, o_b))):
            results[axis, row["name"]] = value
        for name, value in angles_zyx(product(transposed(r_b), r_p)).items():
            results[name, row["name"]] = value
    return results, inputs
