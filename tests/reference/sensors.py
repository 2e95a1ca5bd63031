"""The model "points from sensors" (Galetto et al.): their Eqs 1 to 4, and least squares of the readings, weighted by themselves or, with all targets of a
set-up at once, by everything that is uncertain in them.

Least squares end where G = J' W r = 0, J and W where they end: r of the readings from the stations where these are found. Derivatives are
-(dG/dX)^-1 dG/dx with W held, second derivatives of the readings by central differences.
"""
import mpmath as mp

from dual import Dual, atan2, cos, hypot, sin
from first_order import Inputs
from fits import central
from instruments import STATION, figures, reads, rotation, shared, station_deviations
from poses import three_two_one
from tables import table
from units import quantity
from vectors import ZERO, angles_zyx, cross, dot, inside, minus, stated, times, values


class Row:
    """A reading, or a calibrated length: a function of coordinates of targets and of a station, and its uncertainties."""

    def __init__(self, kind, value, targets, sensor=None):
        self.kind, self.value, self.targets, self.sensor = kind, value, targets, sensor
        self.keys = [(t, axis) for t in targets for axis in "xyz"] + ([(sensor, axis) for axis in STATION] if sensor else [])
        self.effects, self.deviation = {}, None

    def computed(self, at, setup):
        points = [[at[t, axis] for axis in "xyz"] for t in self.targets]
        if self.kind == "bar":
            return hypot(*minus(points[1], points[0]))
        return self.seen(inside(pose(setup, [at[self.sensor, axis] for axis in STATION]), points[0]))

    def seen(self, v):
        if self.kind == "across":  # next to the zenith: from the azimuth that was read
            return v[1] * mp.cos(self.azimuth) - v[0] * mp.sin(self.azimuth)
        return hypot(*v) if self.kind == "d" else atan2(v[1], v[0]) if self.kind == "a" else atan2(v[2], hypot(*v[:2]))

    def slopes(self, at, setup):
        """(value, derivatives by `keys`)"""
        y = self.computed({key: Dual(at[key], {key: mp.mpf(1)}) for key in self.keys}, setup)
        return y.v, [y.g.get(key, mp.mpf(0)) for key in self.keys]

    def bends(self, at, setup):
        """Second derivatives by `keys`."""
        own = [at[key] for key in self.keys]
        moved = lambda values_: mp.matrix(self.slopes(dict(zip(self.keys, values_)), setup)[1])
        return [central(moved, own, i) for i in range(len(own))]


def pose(setup, station):
    return rotation(setup, station[3:]), station[:3]


class Network:
    def __init__(self, entry, project, inputs):
        self.setup, self.inputs = entry["setup"], inputs
        self.rounded = getattr(project, "rounded", lambda x: x)  # for condition numbers: with respect to what a program rounds on its way
        read = lambda key: table(self.setup.get(key), project.folder)
        self.sensors = {row["sensor"]: project.assets[row["sensor"]]["setup"] for row in read("sensors")}
        if any(key.startswith("view_") for setup in self.sensors.values() for key in setup):
            raise NotImplementedError("fields of view")
        self.targets, self.at, self.estimator = read("targets"), {}, self.setup.get("estimator", "nonlinear")
        self.together = self.estimator == "nonlinear" and self.setup.get("weights", "with-stations") == "with-stations"
        self.measured, self.set_ups = self.setup.get("evaluation") == "a-posteriori", []
        for row in self.targets:
            if not self.set_ups or row.get("new_set_up"):
                self.set_ups.append([])
            self.set_ups[-1].append(row["name"])
            self.at |= {(row["name"], axis): row[axis] for axis in "xyz"}
        self.readings, self.bars = read("readings"), read("scale_bars")
        self.lengths = [row.get("length") if self.measured else
                        mp.norm([self.at[row["to"], axis] - self.at[row["from"], axis] for axis in "xyz"]) for row in self.bars]
        self.length = [Dual(value) + inputs.deviation(("bar", i), row["u"]) for i, (row, value) in enumerate(zip(self.bars, self.lengths))]

    def located(self, number, names):
        """Positions of these targets, as duals of what is read and stated."""
        stations = {}
        for name, setup in self.sensors.items():
            coordinates = [c.v for part in stated(setup.get("station")) for c in part]
            stations[name] = [Dual(c) + d for c, d in zip(coordinates, station_deviations(setup, (name, number), self.inputs))]
            self.at |= {(name, axis): c for axis, c in zip(STATION, coordinates)}
        rows = [row for name in names for row in self.rows_of(name)]
        if self.estimator != "nonlinear":
            return [self.explicit(name, [row for row in rows if row.targets[0] == name], stations) for name in names]
        if not self.together:
            return [p for name in names for p in self.implicit([name], [row for row in rows if row.targets[0] == name], stations)]
        for i, bar in enumerate(self.bars):
            if bar["role"] == "constraint" and bar["from"] in names:
                rows.append(Row("bar", self.lengths[i], [bar["from"], bar["to"]]))
                rows[-1].u, rows[-1].deviation = bar["u"], self.length[i] - self.lengths[i]
        return self.implicit(names, rows, stations)

    def rows_of(self, name):
        given = [row for row in self.readings if row["target"] == name] if self.measured else [{"sensor": sensor} for sensor in self.sensors]
        for i, row in enumerate(given):
            setup, sensor = self.sensors[row["sensor"]], row["sensor"]
            v = self.view(name, sensor)
            overhead = mp.norm(v[:2]) < mp.norm(v) / 1000
            for kind, key in zip("dae", ("distance", "azimuth", "elevation")):
                if kind not in reads(setup) or self.measured and key not in row:
                    continue
                made = Row("across" if overhead and kind == "a" else kind, row.get(key), [name], sensor)
                made.what, made.azimuth = (name, sensor, i, kind), mp.atan2(v[1], v[0])
                if not self.measured:
                    made.value = mp.mpf(0) if made.kind == "across" else made.seen(list(map(Dual, v))).v
                elif overhead:
                    raise NotImplementedError("readings next to the zenith")
                yield made

    def view(self, name, sensor):
        place = pose(self.sensors[sensor], [Dual(self.at[sensor, axis]) for axis in STATION])
        return values(inside(place, [Dual(self.at[name, axis]) for axis in "xyz"]))

    def weigh(self, rows):
        """Uncertainties of the readings where targets and stations are now."""
        for row in rows:
            if row.sensor:
                setup, v = self.sensors[row.sensor], self.view(row.targets[0], row.sensor)
                across = row.kind == "across"
                kind = "a" if across else row.kind
                row.u = figures(setup, v)[kind] * (max(mp.norm(v[:2]), mp.norm(v) / 1000) if across else 1)
                row.effects = {key: effect for key, effect in shared(setup, v, across)[kind].items() if setup.get("u_" + key)}

    def deviations(self, row):
        if row.deviation is not None:
            return row.deviation
        common = ((self.inputs.deviation((row.sensor, key), quantity(self.sensors[row.sensor], "u_" + key)), effect) for key, effect in row.effects.items())
        return sum((d * effect for d, effect in common), self.inputs.deviation(row.what, row.u))

    def covariance(self, stations):
        c = mp.zeros(6 * len(self.sensors))
        flat = [d for station in stations.values() for d in station]
        u = {symbol: u for symbol, u, _ in self.inputs.components}
        for i, a in enumerate(flat):
            for j, b in enumerate(flat):
                for s in a.g:
                    for t in b.g:
                        pair = tuple(sorted(self.inputs.of_symbol(x)[0] for x in (s, t)))
                        c[i, j] += u[s] * u[t] * (1 if s == t else self.inputs.correlation.get(pair, 0))
        return c

    def implicit(self, names, rows, stations):
        unknowns, by = [(name, axis) for name in names for axis in "xyz"], [(name, axis) for name in self.sensors for axis in STATION]
        c, moved = self.covariance(stations), mp.zeros(len(by), 1)
        stated_at = [self.at[key] for key in by]
        for _ in range(60 if self.measured else 1):
            self.at |= {key: value + m for key, value, m in zip(by, stated_at, moved)}
            self.weigh(rows)
            found = [row.slopes(self.at, self.sensors.get(row.sensor)) for row in rows]
            j, j_s = (mp.matrix([[dict(zip(row.keys, slopes)).get(key, mp.mpf(0)) for key in keys] for row, (_, slopes) in zip(rows, found)]) for keys in (unknowns, by))
            r = mp.matrix([row.value - y if row.kind != "a" else turned(row.value - y) for row, (y, _) in zip(rows, found)]) + j_s * moved
            total = mp.diag([row.u ** 2 for row in rows])
            if self.together:
                total += j_s * c * j_s.T
                for i, a in enumerate(rows):
                    for k, b in enumerate(rows):
                        if a.sensor == b.sensor:
                            total[i, k] += sum(a.effects[key] * b.effects[key] * quantity(self.sensors[a.sensor], "u_" + key) ** 2 for key in a.effects if key in b.effects)
            w = total ** -1
            step = (j.T * w * j) ** -1 * (j.T * w * r)
            self.at |= {key: self.at[key] + d for key, d in zip(unknowns, step)}
            before, moved = moved, c * j_s.T * (w * (r - j * step)) if self.together and self.measured else moved
            if mp.norm(step) + mp.norm(moved - before) < mp.mpf(10) ** -38:
                break
        else:
            raise ArithmeticError("no estimate")
        j, j_s, weight = j.apply(self.rounded), j_s.apply(self.rounded), lambda: w.apply(self.rounded)
        by_x, by_s, weighted = -j.T * weight() * j, -j.T * weight() * j_s, weight() * r
        for i, row in enumerate(rows if self.measured else []):
            for column, key in zip(row.bends(self.at, self.sensors.get(row.sensor)), row.keys):
                for bend, other in zip(column, row.keys):
                    if other in unknowns:
                        to, place = (by_x, unknowns) if key in unknowns else (by_s, by)
                        to[unknowns.index(other), place.index(key)] += bend * weighted[i]
        minus_inverse = -by_x ** -1
        by_reading, by_station = minus_inverse * j.T * weight(), minus_inverse * by_s
        inputs = [(by_reading[:, i], self.deviations(row)) for i, row in enumerate(rows)]
        inputs += [(by_station[:, i], d - d.v) for i, d in enumerate(d for station in stations.values() for d in station)]
        x = [sum((d * self.rounded(column[k]) for column, d in inputs), Dual(self.at[key])) for k, key in enumerate(unknowns)]
        return [x[k:k + 3] for k in range(0, len(x), 3)]

    def explicit(self, name, rows, stations):
        """Eq 3 and, weighted, Eq 4."""
        for _ in range(30 if self.measured else 1):
            self.weigh(rows)
            x = self.linear(rows, {key: [Dual(c.v) for c in station] for key, station in stations.items()}, lambda row: Dual(row.value))
            self.at |= {(name, axis): c.v for axis, c in zip("xyz", x)}
        return self.linear(rows, stations, lambda row: self.deviations(row) + row.value)

    def linear(self, rows, stations, value):
        sights, found = {}, None
        for row in rows:
            sights.setdefault(row.what[:3], {})[row.kind] = row
        for weighted in (False, True)[:2 if self.estimator == "linear" else 1]:
            equations = []
            for (_, sensor, _), read in sights.items():
                if "a" not in read:
                    continue
                place = pose(self.sensors[sensor], stations[sensor])
                a, e = value(read["a"]), value(read["e"]) if "e" in read else Dual(0)
                v = inside(place, found) if weighted else None
                for kind, direction, b in (("d", [cos(e) * cos(a), cos(e) * sin(a), sin(e)], value(read["d"]) if "d" in read else 0),
                                           ("a", [-sin(a), cos(a), Dual(0)], 0), ("e", [-sin(e) * cos(a), -sin(e) * sin(a), cos(e)], 0)):
                    if kind in read and (kind == "a" or "e" in read):
                        n = times(place[0], direction)
                        arm = 1 if not weighted else {"d": 1, "a": hypot(*v[:2]), "e": hypot(*v)}[kind] * read[kind].u
                        equations.append((n, dot(n, place[1]) + b, 1 / (arm * arm)))
            m = [sum((n[i] * n[j] * w for n, _, w in equations), Dual(0)) for i in range(3) for j in range(3)]
            g = [sum((n[i] * b * w for n, b, w in equations), Dual(0)) for i in range(3)]
            columns = [m[0:3], m[3:6], m[6:9]]
            whole = dot(columns[0], cross(columns[1], columns[2]))
            found = [dot(g, cross(columns[(i + 1) % 3], columns[(i + 2) % 3])) / whole for i in range(3)]
        return found


def turned(angle):
    return angle - 2 * mp.pi * mp.nint(angle / (2 * mp.pi))


def evaluate(entry, project):
    inputs = Inputs()
    network = Network(entry, project, inputs)
    p = {name: place for i, names in enumerate(network.set_ups) for name, place in zip(names, network.located(i, names))}
    results = {(axis, name): c for name, place in p.items() for axis, c in zip("xyz", place)}
    read, setup = lambda key: table(setup.get(key), project.folder), entry["setup"]
    for row in read("distances"):
        results[row["from"] + row["to"], "distances"] = hypot(*minus(p[row["to"]], p[row["from"]]))
    for row in read("angles"):
        a, b = (minus(p[row[end]], p[row["at"]]) for end in ("from", "to"))
        results[row["from"] + row["at"] + row["to"], "angles"] = atan2(hypot(*cross(a, b)), dot(a, b))
    for row in read("frames"):
        r, o = three_two_one([p[row[key]] for key in ("origin", "on_x", "in_xy")], "positive-y", ZERO)
        results |= {(symbol, row["name"]): value for symbol, value in (dict(zip("xyz", o)) | angles_zyx(r)).items()}
    for row, length in zip(read("scale_bars"), network.length):
        results[f"Δ{row['from']}{row['to']}", "calibrated lengths"] = hypot(*minus(p[row["to"]], p[row["from"]])) - length
    return results, inputs
