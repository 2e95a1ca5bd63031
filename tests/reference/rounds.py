"""The model "theodolite in rounds" (ISO 17123-3), all targets in all sets: the scheme of means, reduced to the first target; the index error."""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from linear import scatter
from tables import table

TURN = 2 * mp.pi


def evaluate(entry, project):
    inputs, series = Inputs(), {}
    for row in table(entry["setup"]["readings"], project.folder):
        series.setdefault(row.get("series", "1"), {}).setdefault(row["set"], {})[row["target"]] = row
    if any(set(row) != set(first) for sets in series.values() for first in sets.values() for row in sets.values()):
        raise NotImplementedError("targets that are not read in every set")
    results, index = {}, [[(row["V_I"] + row["V_II"] - TURN) / 2 for one in sets.values() for row in one.values()] for sets in series.values()]
    for symbol, residuals in ("s_Hz", of_directions), ("s_V", of_zeniths):
        squares, nu = map(mp.fsum, zip(*(residuals(list(sets.values())) for sets in series.values())))
        results[symbol] = Dual(mp.sqrt(squares / nu)) + inputs.deviation(symbol, mp.sqrt(squares / nu / (2 * nu)))
    readings, nu = mp.fsum(map(len, index)), mp.fsum(len(i) - 1 for i in index)
    s = mp.sqrt(mp.fsum(scatter(i)[1] ** 2 * (len(i) - 1) for i in index) / nu)
    results["delta"] = Dual(mp.fsum(sum(index, [])) / readings) + inputs.deviation("delta", s / mp.sqrt(readings), nu)
    return results, inputs


def of_directions(sets):
    """Sum of the squared residuals of a series and its degrees of freedom."""
    targets, first = list(sets[0]), next(iter(sets[0]))
    mean = lambda row: row["Hz_I"] + turned(row["Hz_II"] - row["Hz_I"] - mp.pi) / 2
    x = [{t: turned(mean(one[t]) - mean(one[first]) - mean(sets[0][t]) + mean(sets[0][first])) for t in targets} for one in sets]
    over_sets = {t: mp.fsum(one[t] for one in x) / len(x) for t in targets}
    squares = mp.mpf(0)
    for one in x:
        d = [over_sets[t] - one[t] for t in targets]
        squares += mp.fsum((v - mp.fsum(d) / len(d)) ** 2 for v in d)
    return squares, mp.mpf((len(sets) - 1) * (len(targets) - 1))


def of_zeniths(sets):
    x = [[(one[t]["V_I"] - one[t]["V_II"] + TURN) / 2 for one in sets] for t in sets[0]]
    return mp.fsum(scatter(values)[1] ** 2 * (len(values) - 1) for values in x), mp.mpf((len(sets) - 1) * len(x))


def turned(angle):
    return angle - TURN * mp.nint(angle / TURN)
