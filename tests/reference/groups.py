"""The model "observations in groups" (JCGM 100 H.5): u of the mean from the scatter of the groups' means, or of all observations."""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from linear import scatter
from tables import table
from units import factor, number


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    if setup.get("data", "observations") == "summary":
        rows = table(setup["groups"], project.folder)
        groups = [(number(row["mean"]), number(row["s"]), int(row.get("n", setup.get("per_group", 5)))) for row in rows]
    else:
        members = {}
        for row in table(setup["observations"], project.folder):
            members.setdefault(row["group"], []).append(number(row["value"]))
        groups = [(*scatter(values), len(values)) for values in members.values()]
    between = setup.get("between", "included")
    if between == "none":
        count = sum(n for _, _, n in groups)
        mean = mp.fsum(m * n for m, _, n in groups) / count
        s = mp.sqrt(mp.fsum(n * (m - mean) ** 2 + s ** 2 * (n - 1) for m, s, n in groups) / (count - 1))
    elif between == "included":
        count = len(groups)
        mean, s = scatter([m for m, _, _ in groups])
    else:
        raise NotImplementedError("components of variance")
    inputs.nu, unit = mp.mpf(count - 1), factor(setup.get("unit"))
    return {setup.get("symbol", "V"): Dual(mean * unit) + inputs.deviation("mean", s / mp.sqrt(count) * unit)}, inputs
