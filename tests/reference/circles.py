"""The model "robot by joint trajectories" with typed uncertainties (Wen et al., 2.1.2 to 2.1.4, corrected as the model says): circles by least squares, frames from
their axes, parameters by Eq 5."""
import mpmath as mp

from dual import Dual, asin, atan2, cos, sin
from first_order import Inputs
from fits import fitted
from geometry import perpendicular
from robots import Arm
from tables import table
from units import quantity
from vectors import cross, dot, minus, outside, placement, plus, scaled, transposed, unit, values


def start(points):
    """The circle through the first point, one in the middle and the last one: normal, centre, diameter."""
    a, b = (minus(values(points[i]), values(points[0])) for i in (len(points) // 2, -1))
    n = values(cross(list(map(Dual, a)), list(map(Dual, b))))
    square = mp.fsum(c * c for c in n)
    aa, bb = (mp.fsum(c * c for c in side) for side in (a, b))
    d = [x / (2 * square) for x in values(cross([Dual(aa * y - bb * x) for x, y in zip(a, b)], list(map(Dual, n))))]
    return dict(zip(("n_x", "n_y", "n_z"), n)) | dict(zip("xyz", plus(values(points[0]), d))) | {"d": 2 * mp.norm(d)}


def trajectories(setup, arm, zero, project, inputs):
    """Points of each joint as duals, and the side from which they run anticlockwise by it."""
    u, found = quantity(setup, "u_point", "15e-6"), []
    typed = lambda name, p: [Dual(c) + inputs.deviation((*name, axis), u) for axis, c in zip("xyz", p)]
    if setup.get("data", "simulated") == "simulated":
        half, count = quantity(setup, "half_range", mp.pi / 3), int(setup.get("point_count", 50))
        ball = placement(setup["ball"])[1] if "ball" in setup else [Dual(c) / 1000 for c in (80, 60, 40)]
        for j, joint in enumerate(arm.joints):
            turned = lambda k: [q + (joint["sign"] * half * (mp.mpf(2 * k) / (count - 1) - 1) if i == j else 0) for i, q in enumerate(zero)]
            found.append(([typed((j, k), values(outside(arm.base, outside(arm.frames(turned(k))[-1], ball)))) for k in range(count)], 1))
        return found
    for j, joint in enumerate(arm.joints):
        rows = [row for row in table(setup["points"], project.folder) if int(row["joint"]) == j + 1]
        points = [typed((j, k), [row[axis] for axis in "xyz"]) for k, row in enumerate(rows)]
        read = all("q" in row for row in rows)
        found.append((points, joint["sign"] * (1 if rows[-1]["q"] >= rows[0]["q"] else -1) if read else 1))
    return found


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    if setup.get("point_uncertainty", "typed") != "typed" or setup.get("plane", "total") != "total" or setup.get("uncertainties", "stated") != "stated":
        raise NotImplementedError("an instrument, planes by Eq 1, uncertainties as seen")
    arm = Arm(project.assets[setup["nominal"]], project.folder, Inputs())
    zero = [joint["q_zero"] for joint in arm.joints]
    axes = []
    for j, (points, side) in enumerate(trajectories(setup, arm, zero, project, inputs), 1):
        begin = start(points)
        form, p = fitted("circle", begin, points)
        n, centre, radius, _ = form.placed(p)
        if dot(n, [Dual(begin[key]) for key in ("n_x", "n_y", "n_z")]).v * side < 0:
            n = scaled(n, -1)
        axes.append((centre, n))
        results[f"R_{j}", "circles"] = radius
    limit = mp.sin(quantity(setup, "parallel_limit", mp.pi / 180))
    parallel = [mp.norm(values(cross(a, b))) < limit for (_, a), (_, b) in zip(axes, axes[1:])]
    nominal = arm.frames(zero)
    frames = placed(axes, parallel, along([n for _, n in axes], nominal), arm.joints[0])
    for j in range(len(axes) - 1):
        for key, value in between(frames[j], frames[j + 1], parallel[j]).items():
            if j or key not in ("theta", "d"):
                results[f"{key}_{j + 1}", f"joint {j + 1}"] = value
    return results, inputs


def along(axes, nominal):
    """The x of the nominal frames, turned to the axes that were found."""
    h = sum((mp.matrix(values(n)) * mp.matrix(values(transposed(r)[2])).T for n, (r, _) in zip(axes, nominal)), mp.zeros(3))
    u, _, v = mp.svd_r(h)
    turned = u * mp.diag([1, 1, mp.sign(mp.det(u) * mp.det(v))]) * v
    return [[Dual(c) for c in turned * mp.matrix(values(transposed(r)[0]))] for r, _ in nominal[1:]]


def placed(axes, parallel, nominal, first):
    """Frames (x, y, z, origin) 0 to n - 1; `nominal`: their x, which decides between the two senses."""
    frames = [None]
    for i in range(1, len(axes)):
        (p, n), (q, m) = axes[i - 1], axes[i]
        if parallel[i - 1]:
            z, o = (frames[-1][2], frames[-1][3]) if i > 1 else (n, p)
            there = plus(q, scaled(m, dot(minus(o, q), z) / dot(m, z)))
            x = cross(unit(cross(m, minus(there, o))), m)
        else:
            there, x = perpendicular(p, n, q, m)[1], unit(cross(n, m))
        x = x if dot(x, nominal[i - 1]).v > 0 else scaled(x, -1)
        frames.append((x, cross(m, x), m, there))
    (p, z), theta = axes[0], first["theta"].v
    x = unit(cross(frames[1][1], z)) if parallel[0] else frames[1][0]
    o = minus(p if parallel[0] else perpendicular(*axes[1], *axes[0])[1], scaled(z, first["d"].v))
    x = minus(scaled(x, mp.cos(theta)), scaled(cross(z, x), mp.sin(theta)))
    frames[0] = x, cross(z, x), z, o
    return frames


def between(a, b, parallel):
    """Parameters of Eq 5 that lead from frame a to frame b: m = Rz(theta) Rx(alpha) Ry(beta)."""
    m = [[dot(x, y) for y in b[:3]] for x in a[:3]]
    o = [dot(minus(b[3], a[3]), x) for x in a[:3]]
    if not parallel:
        found = {"theta": atan2(m[1][0], m[0][0]), "alpha": atan2(m[2][1], m[2][2]), "d": o[2]}
    else:
        sign = 1 if m[2][2].v > 0 else -1  # against each other: alpha is next to a half turn
        found = {"theta": atan2(-sign * m[0][1], sign * m[1][1]), "alpha": asin(m[2][1]), "beta": atan2(-sign * m[2][0], sign * m[2][2])}
        found["alpha"] = found["alpha"] if sign > 0 else mp.pi - found["alpha"]
    return found | {"a": o[0] * cos(found["theta"]) + o[1] * sin(found["theta"])}
