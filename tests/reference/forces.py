"""The models "force-moment channels" and "force-moment loads" (Kim, Eqs 1 to 10): calibrated channels, unknown loads beside them, and the calibration matrix by
least squares through zero. A row of a matrix is a channel, a column the axis that is loaded; loads by the rated loads, readings by the rated outputs."""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from linear import scatter
from tables import table
from units import exact, quantity

LARGEST, POOLED = "largest", "pooled"


class Sensor:
    """Of each axis: rated load and output, s of one reading with its nu and number, machine, zero, hysteresis; rated outputs and readings of all channels."""

    def __init__(self, asset, project):
        setup = asset["setup"]
        self.rated = {row["axis"]: row.get("rated_force", row.get("rated_moment")) for row in table(setup["channels"], project.folder)}
        self.axes, self.resolution, self.increasing = list(self.rated), quantity(setup, "resolution"), []
        machine = {row["axis"]: exact(row["U"]) / exact(row.get("k", 2)) for row in table(project.assets[setup["calibrator"]]["setup"]["loads"], project.folder)}
        self.machine = {axis: machine[axis] for axis in self.axes}
        (self.read if setup.get("data", "readings") == "readings" else self.summarise)(setup, project.folder)

    def summarise(self, setup, folder):
        rows = {row["axis"]: row for row in table(setup["summary"], folder)}
        crossed = {row["axis"]: row for row in table(setup.get("interference"), folder)}
        self.outputs = {(h, c): rows[h]["rated_output"] if h == c else crossed.get(h, {}).get(c, mp.mpf(0)) for h in self.axes for c in self.axes}
        self.zero, self.hysteresis = ({h: rows[h].get(key, mp.mpf(0)) for h in self.axes} for key in ("zero_error", "hysteresis"))
        self.s = {(h, how): (rows[h]["u_A"] * mp.sqrt(3), mp.mpf(2), 3) for h in self.axes for how in (LARGEST, POOLED)}

    def read(self, setup, folder):
        runs = {}
        for row in table(setup["readings"], folder):
            if row.get("series") != "preload":
                runs.setdefault((row["loaded_axis"], row["run"]), []).append(row)
        net, ends = {}, {}  # (loaded, phase, step) -> readings of the runs, less the unloaded ones (Eq 1)
        for (loaded, _), rows in runs.items():
            before, after = (next((row for row in rows if row["phase"] == phase), None) for phase in ("zero_before", "zero_after"))
            if after:
                ends.setdefault(loaded, []).append(abs(after[loaded] - before[loaded]))
            for row in rows:
                if row["phase"] in ("increasing", "decreasing"):
                    values = {h: row[h] - before[h] for h in self.axes}
                    net.setdefault((loaded, row["phase"], row["step"]), {})[row["run"]] = values
                    if row["phase"] == "increasing":
                        self.increasing.append((loaded, exact(row["load"]), values))
        self.zero = {h: max(ends.get(h, [mp.mpf(0)])) for h in self.axes}
        self.outputs, self.s, self.hysteresis = {}, {}, {}
        for c in self.axes:
            steps = {step: found for (loaded, phase, step), found in net.items() if (loaded, phase) == (c, "increasing")}
            for h in self.axes:
                values = [one[h] for one in steps[max(steps)].values()]
                self.outputs[h, c] = mp.fsum(values) / len(values)
            own = [(scatter([one[c] for one in found.values()])[1], len(found)) for found in steps.values()]
            s, n = max(own, key=lambda one: one[0] / mp.sqrt(one[1]))
            nu = mp.fsum(count - 1 for _, count in own)
            self.s[c, LARGEST] = s, mp.mpf(n - 1), n
            self.s[c, POOLED] = mp.sqrt(mp.fsum(one ** 2 * (count - 1) for one, count in own) / nu), nu, n
            self.hysteresis[c] = max((abs(up[c] - net[c, "decreasing", step][run][c]) for step, found in steps.items() for run, up in found.items()
                                      if run in net.get((c, "decreasing", step), {})), default=mp.mpf(0))

    def element(self, h, c, quadratic):
        """(slope, coefficient of the square, their covariance, degrees of freedom), by rated values."""
        points = [(load / self.rated[c], values[h] / self.outputs[h, h]) for loaded, load, values in self.increasing if loaded == c]
        if not points:
            s, nu, n = self.s[h, LARGEST]
            return self.outputs[h, c] / self.outputs[h, h], mp.mpf(0), mp.diag([(s / self.outputs[h, h]) ** 2 / n]), nu
        design = mp.matrix([[load ** k for k in (1, 2)[:1 + quadratic]] for load, _ in points])
        y, inverse, nu = mp.matrix([value for _, value in points]), (design.T * design) ** -1, mp.mpf(len(points) - design.cols)
        beta = inverse * (design.T * y)
        return beta[0], beta[1] if quadratic else mp.mpf(0), inverse * (mp.norm(y - design * beta) ** 2 / nu), nu


def rectangular(width):
    return width / mp.sqrt(12)


def channels(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    sensor = Sensor(project.assets[setup["sensor"]], project)
    for h in sensor.axes:
        s, nu, n = sensor.s[h, setup.get("repeatability", LARGEST)]
        out = sensor.outputs[h, h]
        v = out + inputs.deviation((h, "repeatability"), s / mp.sqrt(n), nu) + inputs.deviation((h, "machine"), sensor.machine[h] * abs(out))
        for key, width in (("resolution", sensor.resolution), ("zero", sensor.zero[h]), ("hysteresis", sensor.hysteresis[h])):
            v += inputs.deviation((h, key), rectangular(width))
        others = [c for c in sensor.axes if c != h and setup.get("other_loads", "all") != "none"]
        if setup.get("other_loads") == "largest":
            others = [max(others, key=lambda c: abs(sensor.outputs[h, c]))]
        for c in others:
            v += inputs.deviation((c, "load"), 1 / mp.sqrt(3)) * sensor.outputs[h, c]
        results |= {(f"{h[0]}_{h[1]}", h): v * (sensor.rated[h] / out), ("V", h): v, ("r", h): v / out}
    return results, inputs


def loads(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    sensor, quadratic = Sensor(project.assets[setup["sensor"]], project), setup.get("matrix") == "quadratic"
    axes, how, a, b = sensor.axes, setup.get("repeatability", LARGEST), {}, {}
    for h in axes:
        for c in axes:
            slope, square, covariance, nu = sensor.element(h, c, quadratic)
            machine = inputs.deviation((c, "machine"), sensor.machine[c])
            estimate = ("residuals", h, c) if sensor.increasing else ("repeatability", h)
            first = inputs.deviation((h, c, 1), mp.sqrt(covariance[0, 0]), nu, estimate)
            a[h, c], b[h, c] = slope + first + machine * slope, Dual(0)
            if quadratic:
                along = covariance[0, 1] / covariance[0, 0]
                second = inputs.deviation((h, c, 2), mp.sqrt(covariance[1, 1] - along * covariance[0, 1]), nu, estimate)
                b[h, c] = square + first * along + second + machine * (2 * square)
    given = setup.get("given", "loads")
    for k, row in enumerate(table(setup[given], project.folder)):
        l = {c: row.get(c, mp.mpf(0)) / sensor.rated[c] for c in axes} if given == "loads" else None
        v = {h: row[h] / sensor.outputs[h, h] if l is None else mp.fsum((a[h, c].v + b[h, c].v * l[c]) * l[c] for c in axes) for h in axes}
        l = l or solved(a, b, {h: Dual(x) for h, x in v.items()}, axes)
        part = {h: mp.mpf(1) if setup.get("hysteresis") == "full" else min(mp.mpf(1), abs(l[h].v if isinstance(l[h], Dual) else l[h])) for h in axes}
        read = {}
        for h in axes:
            s, nu, _ = sensor.s[h, how]
            parts = (("resolution", sensor.resolution), ("zero", sensor.zero[h]), ("hysteresis", part[h] * sensor.hysteresis[h]))
            own = [inputs.deviation((k, h, key), rectangular(width)) for key, width in parts]
            read[h] = v[h] + sum(own, inputs.deviation((k, h, "repeatability"), s, nu, ("repeatability", h))) / sensor.outputs[h, h]
        l = solved(a, b, read, axes)
        results |= {(f"{c[0]}_{c[1]}", row["name"]): l[c] * sensor.rated[c] for c in axes}
        results |= {(f"{c[0]}_{c[1]},0", row["name"]): read[c] / a[c, c] * sensor.rated[c] for c in axes}
    return results, inputs


def solved(a, b, v, axes):
    """l with A l + B l^2 = v, by Newton's method: values and derivatives converge together."""
    l = {c: Dual(0) for c in axes}
    for _ in range(9):
        slopes = mp.matrix([[(a[h, c] + b[h, c] * l[c] * 2).v for c in axes] for h in axes]) ** -1
        rest = [v[h] - sum(((a[h, c] + b[h, c] * l[c]) * l[c] for c in axes), Dual(0)) for h in axes]
        l = {c: l[c] + sum((r * slopes[i, j] for j, r in enumerate(rest)), Dual(0)) for i, c in enumerate(axes)}
    return l
