"""The model "measurement equation": typed equations over Python's own parser, inputs from the tables of the set-up."""
import itertools
import re

import mpmath as mp

import dual
from dual import Dual
from first_order import Inputs
from linear import scatter
from statements import of_distribution, of_statement
from tables import table
from units import exact, factor, number, quantity, si

FUNCTIONS = {name: getattr(dual, name) for name in
             ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "atan2", "hypot", "sinh", "cosh", "tanh")} | dual.COMPLEX
FUNCTIONS |= {"ln": dual.log, "pow": lambda a, b: Dual.of(a) ** b, "pi": Dual(mp.pi),
              "if_": lambda condition, yes, no: yes if condition else no, "min": lambda *x: min(map(Dual.of, x)), "max": lambda *x: max(map(Dual.of, x)),
              "log10": lambda x: dual.log(x) / mp.log(10), "log2": lambda x: dual.log(x) / mp.log(2),
              "cbrt": lambda x: Dual.of(x) ** (mp.mpf(1) / 3), "number": lambda text, unit: Dual(si(text, unit))}


def python_of(expression):
    """Numbers keep their digits, their unit goes with them; ^ is **."""
    literal = r"((?<![\w.])(?:\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+)(?:\s*\[[^\]]*\])?)"
    parts = re.split(literal, expression)
    for i, part in enumerate(parts):
        digits, _, unit = part.partition("[")
        parts[i] = f'number("{digits.strip()}", "{unit.rstrip("]") or "1"}")' if i % 2 else part.replace("^", "**")
    return re.sub(r"\bif\(", "if_(", "".join(parts)).strip()


def observations(listed, inputs, of_unit):
    """Means of series, correlated where observations are simultaneous (JCGM 100 5.2.3)."""
    series, together, index = {}, {}, {}
    for row in listed:
        if row.get("series"):
            raise NotImplementedError("earlier series")
        x = si(number(row["value"]), of_unit[row["quantity"]])
        series.setdefault(row["quantity"], []).append(x)
        if "number" in row:
            together.setdefault(row["number"], {})[row["quantity"]] = x
    for symbol, values in series.items():
        inputs.estimate[symbol], s = scatter(values)
        index[symbol] = inputs.add(symbol, s / mp.sqrt(len(values)), mp.mpf(len(values) - 1))
    for a, b in itertools.combinations(series, 2):
        pairs = [(o[a] - inputs.estimate[a], o[b] - inputs.estimate[b]) for o in together.values() if a in o and b in o]
        if len(pairs) > 1:
            covariance = mp.fsum(x * y for x, y in pairs) / (len(pairs) - 1) / len(pairs)
            inputs.correlate(index[a], index[b], covariance / inputs.components[index[a]][1] / inputs.components[index[b]][1])


def degrees_of_freedom(row):
    if "r_u" in row:  # relative uncertainty of u (JCGM 100 G.3)
        return 1 / (2 * row["r_u"] ** 2)
    if "nu" in row:
        return exact(row["nu"])
    return exact(row.get("b", 1)) - 1 if row["statement"] == "standard-deviation" else mp.inf


def inputs_of(entry, folder):
    setup, inputs, of_unit = entry["setup"], Inputs(), {}
    listed = table(setup.get("quantities"), folder)
    for row in listed:
        of_unit.setdefault(row["symbol"], row.get("unit", "1"))
    for row in listed:
        symbol, kind, unit = row["symbol"], row.get("statement"), row.get("unit", of_unit[row["symbol"]])
        if "value" in row:
            inputs.estimate.setdefault(symbol, si(row["value"], unit))
        if kind == "limits":
            inputs.estimate[symbol] = (si(row["a"], unit) + si(row["b"], unit)) / 2
        if kind in (None, "constant", "observations"):
            continue
        if "ensemble" in row:
            raise NotImplementedError("ensemble")
        of_figures = row.get("stated_unit", unit)
        scale, value = factor(of_figures), inputs.estimate.get(symbol, mp.mpf(0))
        if of_figures in ("%", "ppm") and unit not in ("1", "%", "ppm"):
            scale, value = abs(value) * scale, mp.mpf(0)
        nu = degrees_of_freedom(row)
        inputs.add(symbol, of_statement(row, nu, value / factor(of_figures)) * scale, nu)
    observations(table(setup.get("observations"), folder), inputs, of_unit)
    for pair in entry.get("correlations", []):
        first, second = (inputs.of_symbol(pair[end].split(".")[0]) for end in ("first", "second"))
        if len(first) > 1 or len(second) > 1:
            raise NotImplementedError("a correlation of several components")
        inputs.correlate(first[0], second[0], exact(pair["coefficient"]))
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
        symbol = edit["symbol"]
        if edit.get("held") or "components" in edit:
            inputs.components = [(None, u, nu) if s == symbol else (s, u, nu) for s, u, nu in inputs.components]
        for component in edit.get("components", []):
            u, mean = of_distribution(component["distribution"], {k: exact(v) for k, v in component["parameters"].items()})
            inputs.estimate[symbol] += mean * factor(component["unit"])
            inputs.add(symbol, u * factor(component["unit"]), exact(component.get("degreesOfFreedom", "inf")))
        if edit.get("estimate"):  # the expectation of the whole, so also where components have a mean
            inputs.estimate[symbol] = quantity(edit, "estimate")
        if edit.get("combination") == "arithmetic":
            for i, j in itertools.combinations(inputs.of_symbol(symbol), 2):
                inputs.correlate(i, j, 1)


def evaluate(entry, project):
    """Everything that an equation defines, as duals over the inputs."""
    inputs = inputs_of(entry, project.folder)
    edited(entry, inputs)
    names, defined = FUNCTIONS | {s: Dual(v, {s: mp.mpf(1)}) for s, v in inputs.estimate.items()} | project.linked(entry, inputs), {}
    equations = entry["setup"]["equations"]
    lines = equations if isinstance(equations, list) else equations.split("\n")
    pending = [part for line in lines for part in line.split("#")[0].split(";") if part.strip()]
    while pending:
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
        if len(later) == len(pending):
            raise NotImplementedError("an estimate that the table does not state")
        pending = later
    for symbol, z in list(defined.items()):
        if isinstance(z.v, mp.mpc):
            defined |= {symbol + "_re": dual.re(z), symbol + "_im": dual.im(z)}
    return defined, inputs
