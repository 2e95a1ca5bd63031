"""The model "TCP from ballbars", the plan of rotations with three bars (Brosed et al., Eqs 1 to 8): trilateration, planes and sphere by least squares."""
from dual import Dual, atan2, hypot, sqrt
from first_order import Inputs
from fits import fitted
from instruments import MEANING
from tables import table
from units import quantity
from vectors import NORMAL, ZERO, chained, cross, dot, inside, mean, minus, outside, placement, product, times, transposed, turn, unit, values

SETUP, ROBOT = {"ballbars", "robot", "flange", "tool_x", "tool_y", "tool_z", "sequences"}, {"repeatability"}
BARS = {"length_12", "length_13", "length_23", "placement", "reading_constant", "support_constant", "meaning"}


def supports_of(l_12, l_13, l_23):
    x = (l_13 * l_13 + l_12 * l_12 - l_23 * l_23) / (2 * l_12)
    return [ZERO, [l_12, Dual(0), Dual(0)], [x, sqrt(l_13 * l_13 - x * x), Dual(0)]]


def met(supports, bars):
    """Where three lengths meet above the plane of the supports."""
    (a, _, _), (b, c, _) = supports[1:]
    x = (bars[0] ** 2 - bars[1] ** 2 + a * a) / (2 * a)
    y = (bars[0] ** 2 - bars[2] ** 2 + b * b + c * c - 2 * b * x) / (2 * c)
    return [x, y, sqrt(bars[0] ** 2 - x * x - y * y)]


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    bars = project.assets[setup["ballbars"]]["setup"]
    robot = project.assets[setup["robot"]]["setup"] if setup.get("robot") else {}
    if set(setup) - SETUP or set(robot) - ROBOT or set(bars) - BARS:
        raise NotImplementedError("measured points, more than three bars, other choices")
    divisor = MEANING[bars.get("meaning", "standard")]
    lengths = [Dual(quantity(bars, "length_" + key)) for key in ("12", "13", "23")]
    at = supports_of(*lengths)
    supports = supports_of(*(value + inputs.deviation(i, quantity(bars, "support_constant") / divisor) for i, value in enumerate(lengths)))
    r_b, o_b = placement(bars.get("placement"))
    r, o = chained((transposed(r_b), inside((r_b, o_b), ZERO)), placement(setup["flange"]))
    tool = [Dual(quantity(setup, "tool_" + axis)) for axis in "xyz"]
    start = dict(zip("xyz", values(o)))
    turned, normals = [], {}
    for row in table(setup["sequences"], project.folder):
        axis, count, own = "xyz".index(row["axis"]), int(row["points"]), []
        for i in range(count):
            rotation = turn(axis, Dual(row["start"] + row["span"] * i / (count - 1)))
            p, name = outside((r, o), times(rotation, tool)), f"{row['axis']} {i + 1}"
            # A radius that is rectangular in [0, r] in a random direction: variance r^2/3 of the distance, r^2/9 of each coordinate.
            apart = [inputs.deviation((name, c), quantity(robot, "repeatability") / 3) for c in "xyz"]
            readings = []
            for bar, support in enumerate(at):
                d = minus(p, support)
                readings.append(hypot(*d) + dot(unit(d), apart) + inputs.deviation((name, bar), quantity(bars, "reading_constant") / divisor))
            own.append(met(supports, readings))
            turned.append((rotation, own[-1]))
            results |= {(c, name): value for c, value in zip("xyz", own[-1])}
        form, p = fitted("plane", start | {n: r[i][axis].v for i, n in enumerate(NORMAL)}, own)
        normals[axis] = form.placed(p)[0]
        v = times(transposed(r), normals[axis])
        results |= {(f"alpha_{'xyz'[axis]}{'xyz'[other]}", "axes of the flange"): atan2(v[other], v[axis]) for other in {0, 1, 2} - {axis}}
    if set(normals) != {0, 1}:
        raise NotImplementedError("rotations about other axes than x and y")
    form, p = fitted("sphere", start | {"d": 2 * hypot(*tool).v}, [p for _, p in turned])
    centre = form.placed(p)[1]
    z = unit(cross(normals[0], normals[1]))  # y as measured, z normal to both, x completes
    flange = transposed([cross(normals[1], z), normals[1], z])
    tcp = mean([inside((product(flange, rotation), centre), p) for rotation, p in turned])
    for group, place in (("centre of the flange", centre), ("TCP", tcp)):
        results |= {(c, group): value for c, value in zip("xyz", place)}
    return results, inputs
