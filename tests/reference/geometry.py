"""The models "geometry from points" (orthogonal least squares; a circle in two steps, plane and projection) and "relation of features"."""
import mpmath as mp

import instruments
from dual import Dual, atan2, hypot, sqrt, tan
from first_order import Inputs
from fits import Form, fitted
from tables import table
from units import quantity
from vectors import IDENTITY, NORMAL, across, angles_zyx, cross, dot, mean, minus, plus, scaled, transposed, unit, values, without


def measured(setup, rows, project, inputs):
    """Points as duals."""
    kind, found = setup.get("point_uncertainty", "typed"), []
    if kind == "asset" and setup["instrument"] not in project.assets:
        raise NotImplementedError("points of another analysis")
    for number, row in enumerate(rows):
        if any(key.startswith("r_") for key in row):
            raise NotImplementedError("correlated coordinates")
        p = [Dual(row[axis]) for axis in "xyz"]
        if kind == "typed":
            own = [inputs.deviation((number, axis), row.get("u_" + axis, quantity(setup, "u_point", "5e-6"))) for axis in "xyz"]
            p = plus(p, own, [inputs.deviation(("common", axis), quantity(setup, "u_common_" + axis)) for axis in "xyz"])
        elif kind == "asset":
            p = instruments.point(project.assets[setup["instrument"]], p, number, inputs)
        found.append(p)
    return found


def scattered(name, kind, form, p, points, inputs):
    """The points with the deviations that their residuals show, s^2 = sum of squares / degrees of freedom; those of a circle in its plane and across."""
    parts = {}
    for x in points:
        for part, deviations in form.residuals(p, x):
            parts[part] = parts.get(part, 0) + mp.fsum(d.v ** 2 for d in deviations)
    nu = mp.mpf({"point": 3, "line": 2}.get(kind, 1) * len(points) - Form.FREE[kind])
    directions, decided = IDENTITY, list(parts) * 3
    if kind == "circle":
        n = form.placed(p)[0]
        directions, decided = [n, *across(n)], ("ab", "uvr", "uvr")
    found = []
    for number, x in enumerate(points):
        for k, (direction, part) in enumerate(zip(directions, decided)):
            deviation = inputs.deviation((name, number, k), mp.sqrt(parts[part] / nu), nu, (name, part))
            x = plus(x, scaled(values(direction), deviation))
        found.append(x)
    return found


def form_deviations(kind, deviations):
    if kind in ("line", "point"):
        far = [hypot(*d) for d in deviations]
        total = 2 * max(far)
    else:
        far = [d[0] for d in deviations]
        total = max(far) - min(far)
    return {"f_t": total, "f_q": sqrt(sum((d * d for d in far), Dual(0)) / len(far))}


def evaluate(entry, project):
    setup, inputs, results, started = entry["setup"], Inputs(), {}, {}
    features = table(setup["features"], project.folder)
    rows, name = table(setup["points"], project.folder), features[0]["name"]
    for row in rows:
        name = row.setdefault("feature", name)
    points = measured(setup, rows, project, inputs)
    for (symbol, group), value in project.started(entry["id"]).items():
        started.setdefault(group, {})[symbol] = value
    for feature in features:
        name, kind = feature["name"], feature["form"]
        if kind.endswith("2d"):
            raise NotImplementedError("forms in the xy-plane")
        own = [point for point, row in zip(points, rows) if row["feature"] == name]
        form, p = fitted(kind, started[name], own)
        if setup.get("point_uncertainty") == "scatter":
            own = scattered(name, kind, form, p, own, inputs)
            form, p = fitted(kind, started[name], own)
        n, c, r, t = form.placed(p)
        if kind in ("cylinder", "cone"):  # next to the mean of the points
            along = dot(n, minus(p[:3], c))
            c = plus(c, scaled(n, along))
            r = r + along * tan(t) if kind == "cone" else r
        found = dict(zip("xyz", c))
        if kind not in ("point", "sphere"):
            found |= dict(zip(NORMAL, n))
        if r is not None:
            found["d"] = 2 * r
        if kind == "cone":
            found["alpha"] = 2 * t
            results |= {(axis, "apex of " + name): value for axis, value in zip("xyz", minus(c, scaled(n, r / tan(t))))}
        if "f_t" in started[name]:
            found |= form_deviations(kind, [form.residuals(p, x)[-1][1] for x in own])
        results |= {(symbol, name): value for symbol, value in found.items()}
    return results, inputs


def foot_on_plane(p, q, m):
    """Of the place p on the plane through q with normal m."""
    return minus(p, scaled(m, dot(m, minus(p, q))))


def perpendicular(p, n, q, m):
    """Feet of the common perpendicular of two lines."""
    w, b = minus(q, p), dot(n, m)
    s = (dot(n, w) - b * dot(m, w)) / (1 - b * b)
    t = (b * dot(n, w) - dot(m, w)) / (1 - b * b)
    return plus(p, scaled(n, s)), plus(q, scaled(m, t))


def three_planes(p, n, q, m, r, l):
    volume = dot(n, cross(m, l))
    return scaled(plus(scaled(cross(m, l), dot(n, p)), scaled(cross(l, n), dot(m, q)), scaled(cross(n, m), dot(l, r))), 1 / volume)


def axis_frame(z, towards):
    x = unit(without(towards, z))
    return x, cross(z, x), z


def tilts(n, m, towards):
    """Of the direction n from m, towards x and towards y."""
    x, y, z = axis_frame(m, towards)
    n = n if dot(n, z).v > 0 else scaled(n, -1)
    return {"t_x": atan2(dot(n, x), dot(n, z)), "t_y": atan2(dot(n, y), dot(n, z))}


LENGTHS = {"distance": lambda p, n, q, m: hypot(*minus(q, p)),
           "from-plane": lambda p, n, q, m: dot(m, minus(p, q)),
           "from-line": lambda p, n, q, m: hypot(*cross(m, minus(p, q))),
           "between-lines": lambda p, n, q, m: hypot(*minus(*perpendicular(p, n, q, m)))}
PLACES = {"middle": lambda p, n, q, m: mean([p, q]),
          "foot-on-plane": lambda p, n, q, m: foot_on_plane(p, q, m),
          "foot-on-line": lambda p, n, q, m: plus(q, scaled(m, dot(m, minus(p, q)))),
          "line-and-plane": lambda p, n, q, m: plus(p, scaled(n, dot(m, minus(q, p)) / dot(m, n))),
          "two-lines": lambda p, n, q, m: mean(perpendicular(p, n, q, m))}


def related(kind, first, second, third):
    (p, n), (q, m), (r, l) = first, second, third
    if kind in LENGTHS:
        return {"l": LENGTHS[kind](p, n, q, m)}
    if kind in PLACES:
        return dict(zip("xyz", PLACES[kind](p, n, q, m)))
    if kind == "angle":
        return {"phi": atan2(hypot(*cross(n, m)), dot(n, m))}
    if kind == "three-planes":
        return dict(zip("xyz", three_planes(p, n, q, m, r, l)))
    if kind == "two-planes":  # next to the place of the first
        direction = unit(cross(n, m))
        return dict(zip(("x", "y", "z", *NORMAL), three_planes(p, n, q, m, p, direction) + direction))
    if kind == "tilts":
        return tilts(n, m, l if l else minus(r, q) if r else IDENTITY[min(range(3), key=lambda j: abs(m[j].v))])
    if kind in ("frame", "frame-on-plane"):
        origin = p if kind == "frame" else foot_on_plane(p, q, m)
        return dict(zip("xyz", origin)) | angles_zyx(transposed(axis_frame(m, l if l else minus(r, origin))))
    raise NotImplementedError(kind)


def relations(entry, project):
    setup, inputs, known, results = entry["setup"], Inputs(), {None: (None, None)}, {}
    for number, row in enumerate(table(setup["features"], project.folder)):
        if "analysis" in row:
            there, taken = row.get("feature", row["name"]), project.taken(row["analysis"], inputs)
            p, n = ([taken.get((symbol, there)) for symbol in symbols] for symbols in ("xyz", NORMAL))
        else:
            p = [Dual(row.get(axis, 0)) + inputs.deviation((number, axis), row.get("u", 0)) for axis in "xyz"]
            n = [Dual(row[axis]) if axis in row else None for axis in NORMAL]
            if n[0] is not None:
                n = unit(n)
                n = plus(n, *(scaled(e, inputs.deviation((number, k), row.get("u_n", 0))) for k, e in enumerate(across(n))))
        known[row["name"]] = p, None if n[0] is None else unit(n)
    for row in table(setup["relations"], project.folder):
        found = related(row["relation"], *(known[row.get(key)] for key in ("first", "second", "third")))
        results |= {(symbol, row["name"]): value for symbol, value in found.items()}
    return results, inputs
