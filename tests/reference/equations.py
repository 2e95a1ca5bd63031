"""The model "measurement equation": typed equations over Python's own parser, inputs from the tables of the set-up."""
import re

import mpmath as mp

import dual
from dual import Dual
from statements import INFINITE, of_distribution, of_statement, quantile_normal, quantile_student
from units import factor, zero

FUNCTIONS = {name: getattr(dual, name) for name in
             ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "sinh", "cosh", "tanh")} | dual.COMPLEX
FUNCTIONS |= {"ln": dual.log, "pow": lambda a, b: Dual.of(a) ** b, "pi": Dual(mp.pi),
              "if_": lambda condition, yes, no: yes if condition else no, "min": lambda *x: min(map(Dual.of, x)), "max": lambda *x: max(map(Dual.of, x)),
              "log10": lambda x: dual.log(x) / mp.log(10), "log2": lambda x: dual.log(x) / mp.log(2),
              "cbrt": lambda x: Dual.of(x) ** (mp.mpf(1) / 3), "number": lambda text, unit: Dual(mp.mpf(text) * factor(unit) + zero(unit))}


def rows(table):
    keys = [column.split(" [")[0] for column in table["columns"]]
    return [dict(zip(keys, row)) for row in table["rows"]]


def python_of(expression):
    """Numbers keep their digits, their unit goes with them; ^ is **."""
    number = r"((?<![\w.])(?:\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)(?:\s*\[[^\]]*\])?)"
    parts = re.split(number, expression.split("#")[0])
    for i, part in enumerate(parts):
        digits, _, unit = part.partition("[")
        parts[i] = f'number("{digits.strip()}", "{unit.rstrip("]") or "1"}")' if i % 2 else part.replace("^", "**")
    return re.sub(r"\bif\(", "if_(", "".join(parts)).strip()


class Inputs:
    """Estimates, components (u, nu) and correlations between components."""

    def __init__(self):
        self.estimate, self.components, self.correlation = {}, [], {}
        self.known, self.estimates = set(), {}
        self.taken, self.origin = set(), {}  # analyses whose results are inputs, and the component there of a component here

    def add(self, symbol, u, nu=INFINITE):
        self.components.append((symbol, u, nu))
        return len(self.components) - 1

    def deviation(self, symbol, u, nu=INFINITE, estimate=None):
        """A deviation about zero as a dual; the same one where it is asked for again. Those of one `estimate` of variance share its nu."""
        if symbol not in self.known and u != 0:
            self.known.add(symbol)
            i = self.add(symbol, u, nu)
            if estimate is not None:
                self.estimates[i] = estimate
        return Dual(0, {symbol: mp.mpf(1)} if u != 0 else {})

    def correlate(self, i, j, r):
        self.correlation[min(i, j), max(i, j)] = mp.mpf(r)


def observations(setup, inputs, of_unit):
    series, together = {}, {}
    for row in rows(setup["observations"]):
        if row.get("series"):
            raise NotImplementedError("earlier series")
        x = mp.mpf(row["value"]) * factor(of_unit[row["quantity"]]) + zero(of_unit[row["quantity"]])
        series.setdefault(row["quantity"], []).append(x)
        if row.get("number") is not None:
            together.setdefault(row["number"], {})[row["quantity"]] = x
    index = {}
    for symbol, values in series.items():
        n = len(values)
        mean = mp.fsum(values) / n
        inputs.estimate[symbol] = mean
        index[symbol] = inputs.add(symbol, mp.sqrt(mp.fsum((x - mean) ** 2 for x in values) / (n - 1) / n), mp.mpf(n - 1))
    names = list(series)
    for i, a in enumerate(names):  # means of simultaneous observations (JCGM 100 5.2.3)
        for b in names[i + 1:]:
            pairs = [(o[a], o[b]) for o in together.values() if a in o and b in o]
            if len(pairs) > 1:
                n = len(pairs)
                covariance = mp.fsum((x - inputs.estimate[a]) * (y - inputs.estimate[b]) for x, y in pairs) / (n - 1) / n
                inputs.correlate(index[a], index[b], covariance / inputs.components[index[a]][1] / inputs.components[index[b]][1])


def inputs_of(entry):
    setup, inputs, of_unit = entry["setup"], Inputs(), {}
    listed = rows(setup.get("quantities", {"columns": [], "rows": []}))
    for row in listed:
        of_unit.setdefault(row["symbol"], row.get("unit") or "1")
    for row in listed:
        symbol, kind, unit = row["symbol"], row.get("statement"), row.get("unit") or of_unit[row["symbol"]]
        if symbol not in inputs.estimate and row.get("value") is not None:
            inputs.estimate[symbol] = mp.mpf(repr(row["value"])) * factor(unit) + zero(unit)
        if kind == "limits":
            inputs.estimate[symbol] = (mp.mpf(repr(row["a"])) + mp.mpf(repr(row["b"]))) / 2 * factor(unit) + zero(unit)
        if kind in (None, "", "constant", "observations"):
            continue
        if kind in ("pooled", "sample", "histogram", "instrument", "binomial", "poisson", "weibull", "weibull-deviation",
                    "exponential") or row.get("ensemble"):
            raise NotImplementedError(kind or "ensemble")
        of_figures = row.get("stated_unit") or unit
        in_figures = inputs.estimate.get(symbol, 0) / factor(of_figures)
        if of_figures in ("%", "ppm") and unit not in ("1", "%", "ppm"):
            scale, in_figures = abs(inputs.estimate[symbol]) * factor(of_figures), mp.mpf(0)
        else:
            scale = factor(of_figures)
        nu = mp.mpf(repr(row["nu"])) if row.get("nu") is not None else INFINITE
        if row.get("r_u"):
            nu = 1 / (2 * (mp.mpf(repr(row["r_u"])) / 100) ** 2)
        if kind == "standard-deviation" and row.get("nu") is None:
            nu = mp.mpf(repr(row["b"] or 1)) - 1
        if kind == "certificate-p":
            p = (1 + mp.mpf(repr(row["b"])) / 100) / 2
            k = quantile_normal(p) if nu == INFINITE else quantile_student(p, nu)
            u = mp.mpf(repr(row["a"])) / k
        else:
            u = of_statement(kind, row.get("a"), row.get("b"), in_figures)
        inputs.add(symbol, u * scale, nu)
    if "observations" in setup:
        observations(setup, inputs, of_unit)
    for pair in entry.get("correlations", []):
        at = {}
        for i, (symbol, _, _) in enumerate(inputs.components):
            at.setdefault(symbol, []).append(i)
        first, second = at[pair["first"].split(".")[0]], at[pair["second"].split(".")[0]]
        if len(first) > 1 or len(second) > 1:
            raise NotImplementedError("a correlation of several components")
        inputs.correlate(first[0], second[0], repr(pair["coefficient"]))
    return inputs


def value_of(expression, names):
    return Dual.of(eval(python_of(expression), {"__builtins__": {}}, names))


def solved(line, names):
    """"solve a = 1 [V], b = 2: f = g and h = k": Newton's method, then derivatives of the solution by the theorem of implicit functions."""
    starts, equations = line.strip()[len("solve"):].split(":", 1)
    unknowns = [start.split("=", 1) for start in starts.split(",")]
    symbols = [symbol.strip() for symbol, _ in unknowns]
    values = mp.matrix([value_of(start, names).v for _, start in unknowns])
    for _ in range(60):
        trial = names | {s: Dual(v, {("unknown", s): mp.mpf(1)}) for s, v in zip(symbols, values)}
        sides = [equation.split("=", 1) for equation in re.split(r"\band\b", equations)]
        f = [value_of(left, trial) - value_of(right, trial) for left, right in sides]
        inverse = mp.matrix([[row.g.get(("unknown", s), mp.mpf(0)) for s in symbols] for row in f]) ** -1
        step = inverse * mp.matrix([row.v for row in f])
        values -= step
        if mp.norm(step) < mp.mpf(10) ** (5 - mp.mp.dps) * mp.norm(values):
            break
    else:
        raise NotImplementedError("Newton's method does not settle")
    keys = {k for row in f for k in row.g if k[0] != "unknown"}
    return {s: Dual(values[i], {k: -mp.fsum(inverse[i, j] * row.g.get(k, 0) for j, row in enumerate(f)) for k in keys}) for i, s in enumerate(symbols)}


def edited(entry, inputs):
    """Edits of input quantities: another estimate, components in the place of the own ones, none at all."""
    for edit in entry.get("inputs", []):
        symbol, given = edit["symbol"], edit.get("estimate")
        if edit.get("held") or "components" in edit:
            inputs.components = [(None, u, nu) if s == symbol else (s, u, nu) for s, u, nu in inputs.components]
        for component in edit.get("components", []):
            u, mean = of_distribution(component["distribution"], {k: mp.mpf(repr(v)) for k, v in component["parameters"].items()})
            inputs.estimate[symbol] += mean * factor(component["unit"])
            inputs.add(symbol, u * factor(component["unit"]), mp.mpf(component.get("degreesOfFreedom", "inf")))
        if given:  # the expectation of the whole, so also where components have a mean
            inputs.estimate[symbol] = mp.mpf(repr(given["value"])) * factor(given["unit"]) + zero(given["unit"])
        if edit.get("combination") == "arithmetic":
            own = [i for i, (s, _, _) in enumerate(inputs.components) if s == symbol]
            for i in own:
                for j in own:
                    if i < j:
                        inputs.correlate(i, j, 1)


def evaluate(entry, linked=lambda inputs: {}):
    """symbol -> (estimate, Dual over the inputs) of everything that an equation defines, and the inputs."""
    inputs = inputs_of(entry)
    edited(entry, inputs)
    names = dict(FUNCTIONS)
    names |= {s: Dual(v, {s: mp.mpf(1)}) for s, v in inputs.estimate.items()}
    names |= linked(inputs)
    defined = {}
    equations = entry["setup"]["equations"]
    lines = equations if isinstance(equations, list) else equations.split("\n")
    pending = [part for line in lines for part in line.split("#")[0].split(";") if part.strip()]
    for _ in range(len(pending) + 1):
        later = []
        for line in pending:
            try:
                if line.lstrip().startswith("solve "):
                    found = solved(line, names)
                else:
                    name, expression = line.split("=", 1)
                    found = {name.strip(): value_of(expression, names)}
            except NameError:
                later.append(line)
                continue
            names |= found
            defined |= found
        pending = later
    if pending:
        raise NotImplementedError("an estimate that the table does not state")
    for symbol, z in list(defined.items()):
        if isinstance(z.v, mp.mpc):
            defined |= {symbol + "_re": dual.re(z), symbol + "_im": dual.im(z)}
    return defined, inputs
