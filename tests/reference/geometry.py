"""The models "geometry from points" (orthogonal least squares; a circle in two steps, plane and projection) and "relation of features"."""
import mpmath as mp

import instruments
from dual import Dual, atan2, hypot, tan
from equations import Inputs
from fits import Form, across, fitted, scaled
from networks import table
from poses import angles_zyx, cross, dot, minus, plus, transposed, unit
from statements import INFINITE
from units import factor


def length(setup, key, default="0"):
    given = setup.get(key)
    return mp.mpf(default) if given is None else mp.mpf(repr(given["value"])) * factor(given["unit"])


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
            for i, axis in enumerate("xyz"):
                for key, u in (((number, axis), row.get("u_" + axis, length(setup, "u_point", "5e-6"))), (("common", axis), length(setup, "u_common_" + axis))):
                    p[i] = p[i] + inputs.deviation(key, u)
        elif kind == "asset":
            p = instruments.point(project.assets[setup["instrument"]], p, number, inputs)
        found.append(p)
    return found


def scattered(name, kind, form, p, points, inputs):
    """The points with the deviations that their residuals show, s^2 = sum of squares / degrees of freedom; those of a circle in its plane and across."""
    n = form.placed(p)[0]
    parts = {}
    for x in points:
        for names, deviations in form.residuals(p, x):
            parts[names] = parts.get(names, 0) + mp.fsum(d.v ** 2 for d in deviations)
    rows = {"point": 3, "line": 2}.get(kind, 1)
    nu = mp.mpf(rows * len(points) - Form.FREE[kind])
    directions = [[Dual(int(i == j)) for j in range(3)] for i in range(3)] if kind != "circle" else [n, *across(n)]
    found = []
    for number, x in enumerate(points):
        for k, direction in enumerate(directions):
            part = ("ab" if k == 0 else "uvr") if kind == "circle" else next(iter(parts))
            deviation = inputs.deviation((name, number, k), mp.sqrt(parts[part] / nu), nu, (name, part))
            x = plus(x, scaled([Dual(c.v) for c in direction], deviation))
        found.append(x)
    return found


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    features = table(setup["features"], project.folder)
    rows, name = table(setup["points"], project.folder), features[0]["name"]
    for row in rows:
        name = row.setdefault("feature", name)
    points = measured(setup, rows, project, inputs)
    started = {}
    for o in project.results[entry["id"]]["outputs"]:
        started.setdefault(o["group"], {})[o["symbol"]] = mp.mpf(repr(o["estimate"])) * factor(o["unit"])
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
            found |= dict(zip(("n_x", "n_y", "n_z"), n))
        if r is not None:
            found["d"] = 2 * r
        if kind == "cone":
            found["alpha"] = 2 * t
            results |= {(axis, "apex of " + name): value for axis, value in zip("xyz", minus(c, scaled(n, r / tan(t))))}
        deviations = [form.residuals(p, x)[-1][1] for x in own]
        if "f_t" in started[name]:
            if kind in ("line", "point"):
                far = [hypot(*d) for d in deviations]
                found["f_t"] = 2 * max(far, key=lambda d: d.v)
            else:
                far = [d[0] for d in deviations]
                found["f_t"] = max(far, key=lambda d: d.v) - min(far, key=lambda d: d.v)
            found["f_q"] = (sum((d * d for d in far), Dual(0)) / len(far)) ** mp.mpf("0.5")
        results |= {(symbol, name): value for symbol, value in found.items()}
    return results, inputs


def foot(p, q, m):
    """Of the place p on the plane through q with normal m."""
    return minus(p, scaled(m, dot(m, minus(p, q))))


def perpendicular(p, n, q, m):
    """Feet of the common perpendicular of two lines."""
    w, b = minus(q, p), dot(n, m)
    s = (dot(n, w) - b * dot(m, w)) / (1 - b * b)
    t = (b * dot(n, w) - dot(m, w)) / (1 - b * b)
    return plus(p, scaled(n, s)), plus(q, scaled(m, t))


def axis_frame(z, towards):
    x = unit(minus(towards, scaled(z, dot(z, towards))))
    return x, cross(z, x), z


def related(kind, first, second, third):
    (p, n), (q, m) = first, second
    r, l = third if third else (None, None)
    place = lambda at: dict(zip("xyz", at))
    if kind == "distance":
        return {"l": hypot(*minus(q, p))}
    if kind == "from-plane":
        return {"l": dot(m, minus(p, q))}
    if kind == "from-line":
        return {"l": hypot(*cross(m, minus(p, q)))}
    if kind == "between-lines":
        a, b = perpendicular(p, n, q, m)
        return {"l": hypot(*minus(b, a))}
    if kind == "angle":
        return {"phi": atan2(hypot(*cross(n, m)), dot(n, m))}
    if kind == "middle":
        return place(scaled(plus(p, q), mp.mpf("0.5")))
    if kind == "foot-on-plane":
        return place(foot(p, q, m))
    if kind == "foot-on-line":
        return place(plus(q, scaled(m, dot(m, minus(p, q)))))
    if kind == "line-and-plane":
        return place(plus(p, scaled(n, dot(m, minus(q, p)) / dot(m, n))))
    if kind == "two-lines":
        a, b = perpendicular(p, n, q, m)
        return place(scaled(plus(a, b), mp.mpf("0.5")))
    if kind in ("three-planes", "two-planes"):
        direction = unit(cross(n, m))
        if kind == "two-planes":  # next to the place of the first
            r, l = p, direction
        volume = dot(n, cross(m, l))
        at = scaled(plus(plus(scaled(cross(m, l), dot(n, p)), scaled(cross(l, n), dot(m, q))), scaled(cross(n, m), dot(l, r))), 1 / volume)
        return place(at) | (dict(zip(("n_x", "n_y", "n_z"), direction)) if kind == "two-planes" else {})
    if kind == "tilts":
        most = min(range(3), key=lambda j: abs(m[j].v))
        x, y, z = axis_frame(m, l if l else minus(r, q) if r else [Dual(int(i == most)) for i in range(3)])
        n = n if dot(n, z).v > 0 else scaled(n, -1)
        return {"t_x": atan2(dot(n, x), dot(n, z)), "t_y": atan2(dot(n, y), dot(n, z))}  # towards x, towards y
    if kind in ("frame", "frame-on-plane"):
        origin = p if kind == "frame" else foot(p, q, m)
        return place(origin) | angles_zyx(transposed(axis_frame(m, l if l else minus(r, origin))))
    raise NotImplementedError(kind)


def relations(entry, project):
    setup, inputs, known, results = entry["setup"], Inputs(), {}, {}
    for number, row in enumerate(table(setup["features"], project.folder)):
        there = row.get("feature", row["name"])
        if row.get("analysis"):
            taken = project.taken(row["analysis"], inputs)
            p, n = ([taken.get((symbol + axis, there)) for axis in "xyz"] for symbol in ("", "n_"))
        else:
            p = [Dual(row.get(axis, 0)) + inputs.deviation((number, axis), row.get("u", mp.mpf(0))) for axis in "xyz"]
            n = [None if "n_" + axis not in row else Dual(row["n_" + axis]) for axis in "xyz"]
            if n[0] is not None:
                n = unit(n)
                for k, e in enumerate(across(n)):
                    n = plus(n, scaled(e, inputs.deviation((number, k), row.get("u_n", mp.mpf(0)))))
        known[row["name"]] = p, None if n[0] is None else unit(n)
    for row in table(setup["relations"], project.folder):
        found = related(row["relation"], known[row["first"]], known[row["second"]], known[row["third"]] if row.get("third") else None)
        results |= {(symbol, row["name"]): value for symbol, value in found.items()}
    return results, inputs
