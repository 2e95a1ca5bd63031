"""The model "network adjustment" with stated uncertainties: Gauss-Markov adjustment, dense, in 40 digits.

The results of the program are only where Newton's method begins; what is compared is the solution of the normal equations, and its derivatives with
respect to each reading, K = (J' P J)^-1 J' P. In a free network the sum of squares of the changes of the datum's coordinates is least.
"""
import csv
import pathlib
import re

import mpmath as mp

from dual import Dual, atan2, hypot
from equations import Inputs
from units import factor


def table(given, folder):
    """Rows as maps from key to (value in SI, or text); units stand in the heads."""
    if "csv" in given:
        lines = [line for line in (folder / given["csv"]).read_text().splitlines() if line and not line.startswith("#")]
        listed = list(csv.reader(lines))
        columns, listed = listed[0], listed[1:]
    else:
        columns, listed = given["columns"], given["rows"]
    found = []
    for row in listed:
        values = {}
        for column, cell in zip(columns, row):
            key, unit = re.fullmatch(r"([^\[]*?)\s*(?:\[(.*)\])?", column).groups()
            if cell is None or cell == "":
                continue
            values[key] = mp.mpf(cell if isinstance(cell, str) else repr(cell)) * factor(unit) if unit else cell
        found.append(values)
    return found


UNIT_OF_U = {"u_length": "mm", "u_x": "mm", "u_y": "mm", "u_z": "mm", "u_angle": "rad"}
LENGTHS = ("slope-distance", "horizontal-distance", "height-difference", "x", "y", "z", "dx", "dy", "dz")


def with_units(row):
    """Heads without a unit are in that of the declaration."""
    return {key: mp.mpf(value) * factor(UNIT_OF_U[key]) if key in UNIT_OF_U and isinstance(value, str) else
            mp.mpf(value) if key in ("length", "angle", "height_from", "height_to") and isinstance(value, str) else value for key, value in row.items()}


def computed(row, at, orientation, sense):
    """The reading as the unknowns give it."""
    kind = row["kind"]
    a = at[row["from"]]
    if kind in ("x", "y", "z"):
        return Dual.of(a["xyz".index(kind)])
    b = at[row["to"]]
    d = [Dual.of(q) - p for p, q in zip(a, b)]
    d[2] = d[2] + row.get("height_to", 0) - row.get("height_from", 0)
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
    bearing = lambda v: atan2(v[1], v[0]) if sense == "x-to-y" else atan2(v[0], v[1])
    if kind == "azimuth":
        return bearing(d)
    if kind == "direction":
        return bearing(d) - orientation[row["from"], row.get("round", "")]
    if kind == "angle":
        return bearing([Dual.of(q) - p for p, q in zip(a, at[row["second"]])]) - bearing(d)
    raise NotImplementedError(kind)


def evaluate(entry, project):
    setup = entry["setup"]
    if setup.get("uncertainties", "stated") != "stated" or setup.get("stations") or setup.get("correlations") or setup.get("seen_in") or setup.get("instruments"):
        raise NotImplementedError("uncertainties as seen, tilts, correlations")
    started = {(o["symbol"], o["group"]): mp.mpf(repr(o["estimate"])) * factor(o["unit"]) for o in project.results[entry["id"]]["outputs"]}
    points, readings = table(setup["points"], project.folder), [with_units(r) for r in table(setup["readings"], project.folder)]
    values, datum, known, place = {}, [], {}, {point["name"]: point for point in points}
    for point in points:
        for axis in "xyz":
            state, key = point["height" if axis == "z" else "plane"], (point["name"], axis)
            if state == "none":
                known[key] = mp.mpf(0)
            elif state == "fixed":
                known[key] = point[axis]
            else:
                values[key] = started[axis, point["name"]]
                if state == "stated":
                    readings.append({"kind": axis, "from": point["name"], "length": point[axis], "u_length": point["u_" + axis]})
                if state == "datum":
                    datum.append((key, point[axis]))
    for row in readings:
        if row["kind"] == "direction":
            a, b = ([values.get((row[end], axis), known.get((row[end], axis), place[row[end]].get(axis))) for axis in "xy"] for end in ("from", "to"))
            azimuth = mp.atan2(b[1] - a[1], b[0] - a[0]) if setup.get("sense", "x-to-y") == "x-to-y" else mp.atan2(b[0] - a[0], b[1] - a[1])
            values.setdefault((row["from"], "o", row.get("round", "")), azimuth - row["angle"])
    index = {key: i for i, key in enumerate(values)}
    inputs = Inputs()
    for i, row in enumerate(readings):
        inputs.add(i, row["u_length"] if row["kind"] in LENGTHS else row["u_angle"])
    for _ in range(4):
        at = {p["name"]: [known[p["name"], a] if (p["name"], a) in known else Dual(values[p["name"], a], {index[p["name"], a]: mp.mpf(1)})
                          for a in "xyz"] for p in points}
        orientation = {(k[0], k[2]): Dual(v, {index[k]: mp.mpf(1)}) for k, v in values.items() if len(k) == 3}
        n, constraints = len(index), null_space(values, index, datum, readings, [p for p in points if "fixed" in (p["plane"], p["height"])])
        normal, right = mp.zeros(n + len(constraints)), mp.zeros(n + len(constraints), len(readings) + 1)
        for i, row in enumerate(readings):
            h = computed(row, at, orientation, setup.get("sense", "x-to-y"))
            length = row["kind"] in LENGTHS
            misclosure = row["length" if length else "angle"] - h.v
            if not length:
                misclosure -= 2 * mp.pi * mp.nint(misclosure / (2 * mp.pi))
            weight = 1 / inputs.components[i][1] ** 2
            for a, da in h.g.items():
                right[a, 0] += da * weight * misclosure
                right[a, i + 1] = da * weight
                for b, db in h.g.items():
                    normal[a, b] += da * weight * db
        for c, row in enumerate(constraints):
            for a, value in row.items():
                normal[n + c, a] = normal[a, n + c] = value
            right[n + c, 0] = -mp.fsum(value * (values[key] - typed) for key, typed in datum for a, value in row.items() if index[key] == a)
        solution = normal ** -1 * right
        for key, i in index.items():
            values[key] += solution[i, 0]
    results = {}
    dual = lambda key: Dual(values[key], {i: solution[index[key], i + 1] for i in range(len(readings))}) if key in index else Dual(known[key])
    for key in index:
        if len(key) == 3:
            name = "o_" + key[0] + (f"_{key[2]}" if key[2] else ""), "orientations"
            turns = mp.nint((values[key] - started.get(name, values[key])) / (2 * mp.pi))
            results[name] = dual(key) - 2 * mp.pi * turns
        else:
            results[key[1], key[0]] = dual(key)
    for row in table(setup.get("distances", {"columns": [], "rows": []}), project.folder):
        ends = [[dual((row[end], axis)) for axis in "xyz"] for end in ("from", "to")]
        results[f"{row['from']}–{row['to']}", "distances"] = hypot(*(q - p for p, q in zip(*ends)))
    return results, inputs


def null_space(values, index, datum, readings, fixed):
    """What no reading tells and no fixed coordinate holds, restricted to the datum: shifts, and the turn about the vertical."""
    if not datum:
        return []
    if any(row["kind"] in ("x", "y", "z", "azimuth", "dx", "dy") for row in readings) or \
            not any(row["kind"].endswith("distance") for row in readings):
        raise NotImplementedError("a free network with coordinates, azimuths or no scale")
    held = [point for point in fixed if point["plane"] == "fixed"]
    shifts = ("" if held else "xy") + ("" if any(point["height"] == "fixed" for point in fixed) else "z")
    rows = [{index[key]: mp.mpf(1) for key, _ in datum if key[1] == axis} for axis in shifts]
    x_0, y_0 = (held[0]["x"], held[0]["y"]) if held else (0, 0)
    turn = {index[name, axis]: y_0 - values[name, "y"] if axis == "x" else values[name, "x"] - x_0 for (name, axis), _ in datum if axis != "z"}
    return [row for row in rows + [turn] * (len(held) < 2) if row]
