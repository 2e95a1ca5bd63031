"""Cases with their figures at 50 digits: projects of resources/verification, and the lists of cases beside them.

A figure is that of the second evaluator (the folder above), which shares no code with the program; where a closed form exists, `Book.case` holds the
evaluator against it first. Condition numbers: all typed numbers of the analysis are changed by a relative 1e-8 with random signs, eight times; the largest
change of a figure over that is its condition number.
"""
import copy
import json
import pathlib
import random
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

import mpmath as mp

import baselines
import curves
import first_order
import geometry
import groups
import identification
import networks
import poses
import robots
from dual import Dual
from units import exact, factor, si

mp.mp.dps = 50
EVALUATORS = {"network-adjustment": networks.evaluate, "pose-from-points": poses.evaluate, "geometry-from-points": geometry.evaluate,
              "feature-relations": geometry.relations, "robot-pose": robots.evaluate, "robot-calibration": identification.evaluate, "distance-meter-baseline": baselines.evaluate,
              "calibration-curve": curves.evaluate, "observations-in-groups": groups.evaluate}
CHANGE = 1e-8
# An angle comes from direction cosines, so that what is rounded is of the size of one radian.
ANGLE = {"arcsec": 648000 / mp.pi, "deg": 180 / mp.pi, "gon": 200 / mp.pi, "µrad": 10 ** 6, "urad": 10 ** 6}
TESTS = pathlib.Path(__file__).resolve().parents[3]
FOLDER = TESTS / "resources" / "verification"


def density(t, nu):
    if nu == mp.inf:
        return mp.npdf(t)
    return mp.exp(mp.loggamma((nu + 1) / 2) - mp.loggamma(nu / 2)) / mp.sqrt(nu * mp.pi) * (1 + t * t / nu) ** (-(nu + 1) / 2)


def upper_tail(t, nu):
    """Probability beyond t > 0."""
    return mp.erfc(t / mp.sqrt(2)) / 2 if nu == mp.inf else mp.betainc(nu / 2, mp.mpf(1) / 2, 0, nu / (nu + t * t), regularized=True) / 2


def quantile(p, nu=mp.inf):
    """k of a coverage interval of probability p: Newton's method on the upper tail."""
    tail = (1 - mp.mpf(p)) / 2
    t = mp.sqrt(2) * mp.erfinv(mp.mpf(p))
    if nu != mp.inf and nu < 3:
        t = max(t, (mp.mpf(1) / (nu * tail)) ** (1 / nu))
    for _ in range(60):
        with mp.workdps(70):  # many degrees of freedom take digits
            step = (upper_tail(t, nu) - tail) / density(t, nu)
        t = t + step if t + step > 0 else t / 2
        if abs(step) < mp.mpf(10) ** -46 * t:
            return t
    raise ArithmeticError(f"t quantile {p} {nu}")


class Started:
    """The project as the evaluators ask for it: they begin where the truth is."""

    def __init__(self, assets, true):
        self.folder, self.assets, self.true = FOLDER, {a["id"]: a for a in assets}, true

    def started(self, name):
        return self.true

    def taken(self, name, inputs):
        raise NotImplementedError


class Shaken(Started):
    """The same with what is rounded on the way changed as much as what is typed."""

    def __init__(self, assets, true, draw):
        super().__init__(assets, true)
        self.rounded = lambda x: x * (1 + draw.choice((-1, 1)) * CHANGE)


def changed(value, draw, key=""):
    """A set-up with every number changed; whole numbers that count are not."""
    if isinstance(value, dict):
        if "rows" in value:
            heads = value["columns"]
            return dict(value, rows=[[changed(cell, draw, head) for head, cell in zip(heads, row)] for row in value["rows"]])
        return {k: changed(v, draw, k) for k, v in value.items()}
    if isinstance(value, list):
        return [changed(v, draw, key) for v in value]
    if isinstance(value, (int, float)) and not isinstance(value, bool) and key not in ("joint", "n", "nu", "degree", "points", "run", "step", "point_count"):
        return value * (1 + draw.choice((-1, 1)) * CHANGE)
    return value


def figure(value):
    return float(value) if value != mp.inf else "infinite"


class Book:
    def __init__(self, name, title, notes):
        self.name, self.project, self.cases = name, {"format": "covaria", "schemaVersion": 2, "title": title, "notes": notes, "assets": [], "analyses": []}, []

    def asset(self, asset):
        self.project["assets"].append(asset)
        return asset

    def analysis(self, key, model, name, setup, options=None):
        entry = {"id": key, "model": model, "name": name, "setup": setup, "options": options or {"method": "first-order"}}
        self.project["analyses"].append(entry)
        return entry

    def case(self, title, source, entry, units, true=None, expected=None, clauses=(), draws=8, group_of=(), size=0, sizes=()):
        """Evaluates, compares with closed forms (`expected`: result -> (estimate or None, u)), and notes every figure of every result.
        `size`: of the coordinates in metres that are rounded on the way to lengths; `sizes`: by unit, of others. `units`: symbol (or None for the others) -> unit in which the program gives it."""
        project = lambda: Started(self.project["assets"], true or {})
        evaluate = EVALUATORS[entry["model"]]
        results, inputs = evaluate(entry, project())
        for key, (estimate, u) in (expected or {}).items():
            own = first_order.uncertainty(results[key].g, inputs)
            assert abs(own - u) <= mp.mpf(10) ** -20 * u, (title, key, own, u)
            assert estimate is None or abs(results[key].v - estimate) <= mp.mpf(10) ** -15 * max(1, abs(estimate)), (title, key)
        figures = {key: self.figures(value, inputs) for key, value in results.items()}
        figures = {key: found for key, found in figures.items() if found[1] > mp.mpf(10) ** -15 and
                   (found[2] < 1e9 or found[2] == mp.inf)}  # without uncertainty, or of finite nu by rounding alone: no line
        condition = {key: [mp.mpf(1)] * 3 for key in figures}
        draw = random.Random(f"{self.name} {entry['id']}")
        for _ in range(draws):
            other = copy.deepcopy(self.project["assets"])
            for asset in other:
                asset["setup"] = changed(asset["setup"], draw)
            moved, moved_inputs = evaluate(dict(entry, setup=changed(entry["setup"], draw)), Shaken(other, true or {}, draw))
            for key, (y, u, nu) in figures.items():
                y_2, u_2, nu_2 = self.figures(moved[key], moved_inputs)
                scale = max(abs(y), u)
                parts = (abs(y_2 - y) / scale, abs(u_2 - u) / u, abs(nu_2 - nu) / nu if nu != mp.inf else 0)
                condition[key] = [max(old, part / CHANGE) for old, part in zip(condition[key], parts)]
        checks = []
        for key, (y, u, nu) in figures.items():
            symbol, group = key if isinstance(key, tuple) else (key, dict(group_of).get(key, ""))
            unit = units.get(symbol, units.get(None, "1"))
            if unit == "gon":  # an orientation is from -200 to 200 gon
                y -= 2 * mp.pi * mp.nint(y / (2 * mp.pi))
            checks.append(self.line(entry, symbol, group, unit, y, u, nu, condition[key], least=dict(sizes).get(unit, size if unit in ("m", "mm") else ANGLE.get(unit, 0) * factor(unit))))
        made = {"project": f"resources/verification/{self.name}.covaria", "title": title, "source": source, "checks": checks}
        if clauses:
            made["clauses"] = list(clauses)
        self.cases.append(made)
        return results, inputs, made

    @staticmethod
    def figures(value, inputs):
        u = first_order.uncertainty(value.g, inputs)
        nu = inputs.nu if inputs.nu else first_order.effective_degrees_of_freedom(value.g, inputs)
        return value.v, u, nu

    def line(self, entry, symbol, group, unit, y, u, nu, condition, what=None, least=0):
        p = entry["options"].get("coverageProbability", 0.95)
        k, size = quantile(p, nu), factor(unit)
        own = p / (2 * density(k, nu) * k)  # of k with respect to p
        if nu != mp.inf:  # and with respect to nu, which has its own
            own += abs(quantile(p, nu * (1 + mp.mpf(10) ** -9)) - k) / k * mp.mpf(10) ** 9 * max(condition[2], 4 * condition[1])
        line = {"estimate": y / size, "u": u / size, "degrees-of-freedom": nu, "k": k, "U": k * u / size, "low": (y - k * u) / size, "high": (y + k * u) / size}
        rounded = lambda x: float(mp.nstr(max(x, mp.mpf(1)), 3))
        made = {"what": what or (f"{symbol} of {group}" if group else symbol), "analysis": entry["id"], "output": symbol}
        if group:
            made["group"] = group
        if unit != "1":
            made["unit"] = unit
        return made | {"line": {key: figure(value) for key, value in line.items()}, "condition": rounded(max(condition[1], condition[2] / 4)),
                       "estimateCondition": rounded(condition[0]), "quantileCondition": rounded(own), "scale": float(max(abs(y), u, least) / size)}

    def write(self, what):
        FOLDER.mkdir(exist_ok=True)
        (FOLDER / f"{self.name}.covaria").write_text(json.dumps(self.project, ensure_ascii=False))
        lines = []
        for case in self.cases:
            checks = ",\n    ".join(json.dumps(check, ensure_ascii=False) for check in case["checks"])
            head = json.dumps({key: value for key, value in case.items() if key != "checks"}, ensure_ascii=False)
            lines.append(f"{head[:-1]}, \"checks\": [\n    {checks}\n  ]}}")
        text = f'{{"what": {json.dumps(what)},\n "cases": [\n  ' + ",\n  ".join(lines) + "\n ]}\n"
        json.loads(text)
        (FOLDER / f"{self.name}.json").write_text(text)
        count = sum(len(check.get("line", [1])) for case in self.cases for check in case["checks"])
        print(f"{self.name}: {len(self.cases)} cases, {count} figures")
