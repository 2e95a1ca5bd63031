"""The model "pose from points" with typed uncertainties: 3-2-1 (Porath et al., Eqs 9 to 23) and least squares."""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from tables import table
from units import quantity
from vectors import IDENTITY, ZERO, angles_zyx, cross, dot, inside, mean, minus, outside, plus, product, rotation_zyx, times, transposed, unit


def small_rotation(w):
    """Rotation by a small vector about zero, to second order: what one step of Newton's method needs."""
    k = transposed([cross(w, e) for e in IDENTITY])
    square = product(k, k)
    return [[IDENTITY[i][j] + k[i][j] + square[i][j] / 2 for j in range(3)] for i in range(3)]


def three_two_one(points, side, shift):
    x = unit(minus(points[1], points[0]))
    third = minus(points[2], points[0])
    z = unit(cross(third, x) if side == "negative-y" else cross(x, third))
    r = transposed([x, cross(z, x), z])
    return r, outside((r, points[0]), shift)


def least_squares(nominal, points, r):
    """R maximises sum q_i . R l_i about the centres. From the rotation r without deviations, Newton's method on sum R l_i x q_i = 0, in
    dual numbers: values and derivatives of the solution converge together."""
    mean_l, mean_q = mean(nominal), mean(points)
    apart = [minus(q, mean_q) for q in points]
    for _ in range(4):
        turned = [times(r, minus(l, mean_l)) for l in nominal]
        torque = plus(*map(cross, turned, apart))
        slopes = mp.matrix(3)
        for a, q in zip(turned, apart):
            for i in range(3):
                for j in range(3):
                    slopes[i, j] += (dot(a, q).v if i == j else 0) - a[i].v * q[j].v / 2 - a[j].v * q[i].v / 2
        inverse = slopes ** -1
        r = product(small_rotation([dot(inverse[i, :], torque) for i in range(3)]), r)
        for _ in range(2):  # orthogonal again, to all digits
            x, y, _ = transposed(r)
            x, z = unit(x), unit(cross(x, y))
            r = transposed([x, cross(z, x), z])
    return r, minus(mean_q, times(r, mean_l))


class Points:
    """Points of one frame: where they are and the components of their deviations, along the axes of the frame."""

    def __init__(self, setup, frame, folder, inputs):
        if setup.get(f"{frame}_uncertainty", "typed") != "typed":
            raise NotImplementedError("points of an artefact or instrument")
        self.frame, self.inputs = frame, inputs
        self.rows = table(setup[f"{frame}_points"], folder)
        self.u = {axis: quantity(setup, f"{frame}_u_{axis}") for axis in "xyz"}
        self.common = {axis for axis in "xyz" if setup.get(f"{frame}_common_{axis}")}
        self.side = setup.get(f"{frame}_third_point", "negative-y" if frame == "base" else "positive-y")
        self.shift = [Dual(quantity(setup, f"{frame}_shift_{axis}")) for axis in "xyz"]
        self.fit = setup.get(f"{frame}_fit", "three-two-one")
        self.nominal = [[Dual(row[axis]) for axis in "xyz"] for row in self.rows]
        if self.fit != "least-squares":  # laid into the frame that they define
            laid = three_two_one(self.nominal, self.side, self.shift)
            self.nominal = [inside(laid, p) for p in self.nominal]

    def frame_of(self, name, r, o):
        """The frame that the points show when they are measured where their frame has this pose."""
        measured = []
        for i, (p, row) in enumerate(zip(self.nominal, self.rows)):
            deviations = [self.inputs.deviation((self.frame, axis) if axis in self.common else (self.frame, name, i, axis), row.get("u_" + axis, self.u[axis]))
                          for axis in "xyz"]
            measured.append(outside((r, o), plus(p, deviations)))
        if self.fit == "least-squares":
            return least_squares(self.nominal, measured, r)
        return three_two_one(measured, self.side, self.shift)


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    if setup.get("evaluation", "a-priori") != "a-priori" or setup.get("orientation", "zyx") != "zyx" or "base_pose" in setup:
        raise NotImplementedError("measured points, other angles, a base that stands somewhere")
    base, moving = Points(setup, "base", project.folder, inputs), Points(setup, "moving", project.folder, inputs)
    r_b, o_b = base.frame_of("base", IDENTITY, ZERO)
    for row in table(setup["poses"], project.folder):
        r = rotation_zyx(*(row[angle] for angle in ("alpha", "beta", "gamma")))
        r_p, o_p = moving.frame_of(row["name"], r, [Dual(row[axis]) for axis in "xyz"])
        pose = dict(zip("xyz", inside((r_b, o_b), o_p))) | angles_zyx(product(transposed(r_b), r_p))
        results |= {(symbol, row["name"]): value for symbol, value in pose.items()}
    return results, inputs
