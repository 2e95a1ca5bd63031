"""The model "network adjustment" with stated uncertainties: Gauss-Markov adjustment, dense, in 40 digits.

The results of the program are only where Newton's method begins; what is compared is the solution of the normal equations, and its derivatives with
respect to each reading, K = (J' P J)^-1 J' P. In a free network the sum of squares of the changes of the datum's coordinates is least.
"""
import mpmath as mp

from dual import Dual, atan2, hypot
from first_order import Inputs
from tables import table
from vectors import minus

LENGTHS = ("slope-distance", "horizontal-distance", "height-difference", "x", "y", "z", "dx", "dy", "dz")


def bearing(v, sense):
    return atan2(v[1], v[0]) if sense == "x-to-y" else atan2(v[0], v[1])


def computed(row, at, sense):
    """The reading as the unknowns give it."""
    kind, place = row["kind"], lambda end: [at[row[end], axis] for axis in "xyz"]
    if kind in ("x", "y", "z"):
        return at[row["from"], kind]
    d = minus(place("to"), place("from"))
    d[2] += row.get("height_to", 0) - row.get("height_from", 0)
    if kind in ("dx", "dy", "dz"):
        return d["xyz".index(kind[1])]
    if kind == "height-difference":
        return d[2]
    if kind == "slope-distance":
        return hypot(*d)
    if kind == "horizontal-distance":
        return hypot(d[0], d[1])
    if kind == "zenith-angle":
        return atan2(hypot(d[0], d[1]), d[2])
    if kind == "azimuth":
        return bearing(d, sense)
    if kind == "direction":
        return bearing(d, sense) - at[row["from"], "o", row.get("round", "")]
    if kind == "angle":
        return bearing(minus(place("second"), place("from")), sense) - bearing(d, sense)
    raise NotImplementedError(kind)


def evaluate(entry, project):
    setup, inputs, started = entry["setup"], Inputs(), project.started(entry["id"])
    if setup.get("uncertainties", "stated") != "stated" or any(setup.get(key) for key in ("stations", "correlations", "seen_in", "instruments")):
        raise NotImplementedError("uncertainties as seen, tilts, correlations")
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
    place = known | values
    for row in readings:
        if row["kind"] == "direction":
            azimuth = bearing([place[row["to"], axis] - place[row["from"], axis] for axis in "xy"], sense).v
            values.setdefault((row["from"], "o", row.get("round", "")), azimuth - row["angle"])
    index = {key: i for i, key in enumerate(values)}
    n, constants = len(index), {key: Dual(value) for key, value in known.items()}
    for i, row in enumerate(readings):
        inputs.add(i, row["u_length" if row["kind"] in LENGTHS else "u_angle"])
    for _ in range(4):
        at = constants | {key: Dual(value, {index[key]: mp.mpf(1)}) for key, value in values.items()}
        constraints = null_space(values, index, datum, readings, [p for p in points if "fixed" in (p["plane"], p["height"])])
        normal, right = mp.zeros(n + len(constraints)), mp.zeros(n + len(constraints), len(readings) + 1)
        for i, row in enumerate(readings):
            h, length = computed(row, at, sense), row["kind"] in LENGTHS
            misclosure = row["length" if length else "angle"] - h.v
            if not length:
                misclosure -= 2 * mp.pi * mp.nint(misclosure / (2 * mp.pi))
            weight = 1 / inputs.components[i][1] ** 2
            for a, da in h.g.items():
                right[a, 0] += da * weight * misclosure
                right[a, i + 1] = da * weight
                for b, db in h.g.items():
                    normal[a, b] += da * weight * db
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
        if key[1] == "o":
            name = "o_" + key[0] + (f"_{key[2]}" if key[2] else ""), "orientations"
            results[name] = at[key] - 2 * mp.pi * mp.nint((values[key] - started.get(name, values[key])) / (2 * mp.pi))
        else:
            results[key[1], key[0]] = at[key]
    for row in table(setup.get("distances"), project.folder):
        results[f"{row['from']}–{row['to']}", "distances"] = hypot(*(at[row["to"], axis] - at[row["from"], axis] for axis in "xyz"))
    return results, inputs


def null_space(values, index, datum, readings, fixed):
    """What no reading tells and no fixed coordinate holds, restricted to the datum: shifts, and the turn about the vertical."""
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
    return [row for row in rows + [turn] * (len(held) < 2) if row]
