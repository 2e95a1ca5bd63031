"""The model "TCP from ballbars", the plan of rotations with three bars (Brosed et al., Eqs 1 to 8): trilateration, planes and sphere by least squares."""
import mpmath as mp

from dual import Dual, atan2, hypot
from equations import Inputs
from fits import fitted
from geometry import length
from instruments import MEANING
from networks import table
from poses import cross, dot, minus, plus, product, times, transposed, unit
from robots import chained, placement, turn


def supports_of(l_12, l_13, l_23):
    x = (l_13 * l_13 + l_12 * l_12 - l_23 * l_23) / (2 * l_12)
    zero = Dual(0)
    return [[zero, zero, zero], [l_12, zero, zero], [x, (l_13 * l_13 - x * x) ** mp.mpf("0.5"), zero]]


def met(supports, bars):
    """Where three lengths meet above the plane of the supports."""
    (a, _, _), (b, c, _) = supports[1], supports[2]
    x = (bars[0] ** 2 - bars[1] ** 2 + a * a) / (2 * a)
    y = (bars[0] ** 2 - bars[2] ** 2 + b * b + c * c - 2 * b * x) / (2 * c)
    return [x, y, (bars[0] ** 2 - x * x - y * y) ** mp.mpf("0.5")]


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    bars = project.assets[setup["ballbars"]]["setup"]
    robot = project.assets[setup["robot"]]["setup"] if setup.get("robot") else {}
    if set(setup) - {"ballbars", "robot", "flange", "tool_x", "tool_y", "tool_z", "sequences"} or set(robot) - {"repeatability"} or set(bars) - {
            "length_12", "length_13", "length_23", "placement", "reading_constant", "support_constant", "meaning"}:
        raise NotImplementedError("measured points, more than three bars, other choices")
    divisor = MEANING[bars.get("meaning", "standard")]
    nominal = [length(bars, "length_" + key) for key in ("12", "13", "23")]
    at = supports_of(*map(Dual, nominal))
    supports = supports_of(*(Dual(value) + inputs.deviation(i, length(bars, "support_constant") / divisor) for i, value in enumerate(nominal)))
    r_b, o_b = placement(bars.get("placement"))
    back = transposed(r_b)
    r, o = chained((back, [-c for c in times(back, o_b)]), placement(setup["flange"]))
    tool = [Dual(length(setup, "tool_" + axis)) for axis in "xyz"]
    points, turned, normals, radius = [], [], {}, hypot(*tool).v
    for row in table(setup["sequences"], project.folder):
        axis, own = "xyz".index(row["axis"]), []
        for i in range(int(row["points"])):
            rotation = turn(axis, Dual(row["start"] + row["span"] * i / (int(row["points"]) - 1)))
            p, name = plus(o, times(r, times(rotation, tool))), f"{row['axis']} {i + 1}"
            readings = []
            for bar, support in enumerate(at):
                d = minus(p, support)
                # A radius that is rectangular in [0, r] in a random direction: variance r^2/3 of the distance, r^2/9 of each coordinate.
                e = [inputs.deviation((name, c), length(robot, "repeatability") / 3) for c in range(3)]
                readings.append(hypot(*d) + dot(unit(d), e) + inputs.deviation((name, "bar", bar), length(bars, "reading_constant") / divisor))
            own.append(met(supports, readings))
            turned.append((rotation, own[-1]))
            results |= {(c, name): value for c, value in zip("xyz", own[-1])}
        points += own
        start = dict(zip("xyz", (c.v for c in o))) | {"n_" + c: r[i][axis].v for i, c in enumerate("xyz")}
        form, p = fitted("plane", start, own)
        normals[axis] = form.placed(p)[0]
        for other in range(3):
            if other != axis:
                v = times(transposed(r), normals[axis])
                results[f"alpha_{'xyz'[axis]}{'xyz'[other]}", "axes of the flange"] = atan2(v[other], v[axis])
    if set(normals) != {0, 1}:
        raise NotImplementedError("rotations about other axes than x and y")
    form, p = fitted("sphere", dict(zip("xyz", (c.v for c in o))) | {"d": 2 * radius}, points)
    centre = form.placed(p)[1]
    results |= {(c, "centre of the flange"): value for c, value in zip("xyz", centre)}
    z = unit(cross(normals[0], normals[1]))  # y as measured, z normal to both, x completes
    flange = transposed([cross(normals[1], z), normals[1], z])
    found = [Dual(0)] * 3
    for rotation, p in turned:
        found = plus(found, times(transposed(product(flange, rotation)), minus(p, centre)))
    return results | {(c, "TCP"): value / len(turned) for c, value in zip("xyz", found)}, inputs
