"""The model "network adjustment" with stated uncertainties, correlations, tilts and figures of instruments: Gauss-Markov adjustment, dense, in 40 digits.

The results of the program are only where Newton's method begins; what is compared is the solution of the normal equations, and its derivatives with
respect to each reading, K = (J' P J)^-1 J' P. In a free network the sum of squares of the changes of the datum's coordinates is least.
"""
import mpmath as mp

from dual import Dual, atan2, hypot
from first_order import Inputs
from tables import table
from units import exact, quantity
from vectors import minus, product, times, transposed, turn

LENGTHS = ("slope-distance", "horizontal-distance", "height-difference", "x", "y", "z", "dx", "dy", "dz")


def bearing(v, sense):
    return atan2(v[1], v[0]) if sense == "x-to-y" else atan2(v[0], v[1])


FIGURES = {"zero": ("length", "c", LENGTHS[:2]), "scale": ("ratio", "m", LENGTHS[:2]), "refraction": ("ratio", "k", ("zenith-angle",)), "index": ("angle", "i", ("zenith-angle",)),
           "collimation": ("angle", "q", ("direction",))}


def computed(row, at, sense):
    """The reading as the unknowns give it; in face two, which is brought to face one, index and collimation count the other way."""
    kind, place = row["kind"], lambda end: [at[row[end], axis] for axis in "xyz"]
    if kind in ("x", "y", "z"):
        return at[row["from"], kind]
    if kind == "stated":
        return at[row["from"]]
    figure = lambda name: at.get(("figure", row.get("instrument"), name), Dual(0)) * (-1 if row.get("face") == "two" and name in ("index", "collimation") else 1)

    def seen(end):
        d = minus(place(end), place("from"))
        d[2] += row.get("height_to", 0) - row.get("height_from", 0)
        if kind == "zenith-angle" and "curvature" in at:
            d[2] -= at["curvature"] / 2 * (1 - at.get(("figure", row.get("instrument"), "refraction"), at["refraction"])) * (d[0] ** 2 + d[1] ** 2)
        if (row["from"], "tilt", 0) in at and kind in ("direction", "zenith-angle", "angle", "azimuth"):
            d = times(transposed(product(*(turn(i, at[row["from"], "tilt", i]) for i in (0, 1)))), d)
        return d

    d = seen("to")
    if kind in ("dx", "dy", "dz"):
        return d["xyz".index(kind[1])]
    if kind == "height-difference":
        return d[2]
    if kind.endswith("distance"):
        return (hypot(*d) if kind == "slope-distance" else hypot(d[0], d[1])) * (1 + figure("scale")) + figure("zero")
    if kind == "zenith-angle":
        return atan2(hypot(d[0], d[1]), d[2]) + figure("index")
    if kind == "azimuth":
        return bearing(d, sense)
    if kind == "direction":
        return bearing(d, sense) - at[row["from"], "o", row.get("round", "")] + figure("collimation") * (hypot(*d) / hypot(d[0], d[1]))
    if kind == "angle":
        return bearing(seen("second"), sense) - bearing(d, sense)
    raise NotImplementedError(kind)


def of_instruments(setup, folder, values, known, readings):
    """Figures and tilts: unknowns, and what is stated of them as readings."""
    if "earth_radius" in setup:
        known |= {"curvature": 1 / quantity(setup, "earth_radius"), "refraction": quantity(setup, "refraction", "0.13")}
    for row in table(setup.get("figures"), folder):
        what, _, _ = FIGURES[row["figure"]]
        key, value = ("figure", row.get("instrument"), row["figure"]), row.get(what, known["refraction"] if row["figure"] == "refraction" else mp.mpf(0))
        (known if row["knowledge"] == "fixed" else values)[key] = value
        if row["knowledge"] == "stated":
            readings.append({"kind": "stated", "from": key, "length": value, "u_length": row["u_" + what]})
    for row in table(setup.get("stations"), folder):
        for i in (0, 1):
            values[row["point"], "tilt", i] = mp.mpf(0)
            if row["tilt"] == "levelled":
                readings.append({"kind": "stated", "from": (row["point"], "tilt", i), "length": mp.mpf(0), "u_length": row["u_tilt"]})
    for row in readings:
        if row.get("face") == "two":
            row["angle"] = 2 * mp.pi - row["angle"] if row["kind"] == "zenith-angle" else row["angle"] - mp.pi


def weights(setup, readings, inputs):
    """Of each reading, with those that it is correlated with: the inverse of the covariance."""
    labels = {row["label"]: i for i, row in enumerate(readings) if "label" in row}
    c = mp.diag([u ** 2 for _, u, _ in inputs.components])
    listed = (setup.get("correlations") or {"rows": []})["rows"]
    for first, second, r in listed:
        i, j = labels[first], labels[second]
        inputs.correlate(i, j, exact(r))
        c[i, j] = c[j, i] = exact(r) * inputs.components[i][1] * inputs.components[j][1]
    if not listed:
        return [{i: 1 / c[i, i]} for i in range(c.rows)]
    p = c ** -1
    return [{k: p[i, k] for k in range(c.rows) if p[i, k]} for i in range(c.rows)]


def evaluate(entry, project):
    setup, inputs, started = entry["setup"], Inputs(), project.started(entry["id"])
    if setup.get("uncertainties", "stated") != "stated" or any(setup.get(key) for key in ("seen_in", "frames", "gross_limit")):
        raise NotImplementedError("uncertainties as seen, own frames")
    points, readings, sense = table(setup["points"], project.folder), table(setup["readings"], project.folder), setup.get("sense", "x-to-y")
    values, datum, known = {}, [], {}
    for point in points:
        for axis in "xyz":
            state, key = point["height" if axis == "z" else "plane"], (point["name"], axis)
            if state in ("none", "fixed"):
                known[key] = point[axis] if state == "fixed" else mp.mpf(0)
            else:
                values[key] = started[axis, point["name"]]
            if state == "stated":
                readings.append({"kind": axis, "from": point["name"], "length": point[axis], "u_length": point["u_" + axis]})
            if state == "datum":
                datum.append((key, point[axis]))
    of_instruments(setup, project.folder, values, known, readings)
    place = known | values
    for row in readings:
        if row["kind"] == "direction":
            azimuth = bearing([place[row["to"], axis] - place[row["from"], axis] for axis in "xy"], sense).v
            values.setdefault((row["from"], "o", row.get("round", "")), azimuth - row["angle"])
    index = {key: i for i, key in enumerate(values)}
    n, constants = len(index), {key: Dual(value) for key, value in known.items()}
    for i, row in enumerate(readings):
        inputs.add(i, row["u_length" if row["kind"] in LENGTHS + ("stated",) else "u_angle"])
    weight = weights(setup, readings, inputs)
    for _ in range(6 if table(setup.get("stations"), project.folder) else 4):
        at = constants | {key: Dual(value, {index[key]: mp.mpf(1)}) for key, value in values.items()}
        constraints = null_space(values, index, datum, readings, [p for p in points if "fixed" in (p["plane"], p["height"])])
        normal, right = mp.zeros(n + len(constraints)), mp.zeros(n + len(constraints), len(readings) + 1)
        predicted = [computed(row, at, sense) for row in readings]
        for i, row in enumerate(readings):
            length = row["kind"] in LENGTHS + ("stated",)
            misclosure = row["length" if length else "angle"] - predicted[i].v
            if not length:
                misclosure -= 2 * mp.pi * mp.nint(misclosure / (2 * mp.pi))
            for k, w in weight[i].items():
                for a, da in predicted[k].g.items():
                    right[a, 0] += da * w * misclosure
                    right[a, i + 1] += da * w
                    for b, db in predicted[i].g.items():
                        normal[a, b] += da * w * db
        for c, row in enumerate(constraints, n):
            for a, value in row.items():
                normal[c, a] = normal[a, c] = value
            right[c, 0] = -mp.fsum(row.get(index[key], 0) * (values[key] - typed) for key, typed in datum)
        solution = normal ** -1 * right
        for key, i in index.items():
            values[key] += solution[i, 0]
    results = {}
    at = constants | {key: Dual(values[key], {i: solution[row, i + 1] for i in range(len(readings))}) for key, row in index.items()}
    for key in index:
        if key[0] == "figure":
            results[FIGURES[key[2]][1] + (f"_{key[1]}" if key[1] else ""), "instruments"] = at[key]
        elif key[1] == "tilt":
            results[f"tilt_{'xy'[key[2]]}_{key[0]}", "orientations"] = at[key]
        elif key[1] == "o":
            name = "o_" + key[0] + (f"_{key[2]}" if key[2] else ""), "orientations"
            results[name] = at[key] - 2 * mp.pi * mp.nint((values[key] - started.get(name, values[key])) / (2 * mp.pi))
        else:
            results[key[1], key[0]] = at[key]
    for row in table(setup.get("distances"), project.folder):
        results[f"{row['from']}–{row['to']}", "distances"] = hypot(*(at[row["to"], axis] - at[row["from"], axis] for axis in "xyz"))
    return results, inputs


def null_space(values, index, datum, readings, fixed):
    """What no reading tells and no fixed coordinate holds, restricted to the datum: shifts, and the turn about the vertical, or where all instruments
    lean any turn."""
    if not datum:
        return []
    heights = all(row["kind"] == "height-difference" for row in readings)
    if any(row["kind"] in ("x", "y", "z", "azimuth", "dx", "dy") for row in readings) or \
            not any(row["kind"].endswith("distance") or heights for row in readings):
        raise NotImplementedError("a free network with coordinates, azimuths or no scale")
    held = [point for point in fixed if point["plane"] == "fixed"]
    shifts = ("" if held else "xy") + ("" if any(point["height"] == "fixed" for point in fixed) else "z")
    rows = [{index[key]: mp.mpf(1) for key, _ in datum if key[1] == axis} for axis in shifts]
    x_0, y_0 = (held[0]["x"], held[0]["y"]) if held else (0, 0)
    turn = {index[name, axis]: y_0 - values[name, "y"] if axis == "x" else values[name, "x"] - x_0 for (name, axis), _ in datum if axis != "z"}
    rows += [turn] * (len(held) < 2)
    stations, stated_ = {row["from"] for row in readings if row["kind"] in ("direction", "zenith-angle", "angle")}, [row["from"] for row in readings if row["kind"] == "stated"]
    if stations and all((station, "tilt", 0) in values and (station, "tilt", 0) not in stated_ for station in stations):  # nothing tells the vertical
        if fixed:
            raise NotImplementedError("fixed points and instruments that all lean")
        for a, b in ("yz", "zx"):  # turns about x and y
            rows.append({index[name, axis]: -values[name, b] if axis == a else values[name, a] for (name, axis), _ in datum if axis in (a, b)})
    return [row for row in rows if row]
