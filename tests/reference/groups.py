"""The model "observations in groups" (JCGM 100 H.5): u of the mean from the scatter of the groups' means, or of all observations."""
import mpmath as mp

from dual import Dual
from equations import Inputs
from networks import table
from units import factor, number


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    if setup.get("data", "observations") == "summary":
        groups = [(number(r["mean"]), number(r["s"]), int(r.get("n", setup.get("per_group", 5)))) for r in table(setup["groups"], project.folder)]
    else:
        members = {}
        for row in table(setup["observations"], project.folder):
            members.setdefault(row["group"], []).append(number(row["value"]))
        groups = []
        for values in members.values():
            mean, n = mp.fsum(values) / len(values), len(values)
            groups.append((mean, mp.sqrt(mp.fsum((v - mean) ** 2 for v in values) / (n - 1)) if n > 1 else mp.mpf(0), n))
    count, all_ = len(groups), sum(n for _, _, n in groups)
    between = setup.get("between", "included")
    if between == "none":
        mean = mp.fsum(m * n for m, _, n in groups) / all_
        within = mp.fsum(s ** 2 * (n - 1) for _, s, n in groups)
        variance = (mp.fsum(n * (m - mean) ** 2 for m, _, n in groups) + within) / (all_ * (all_ - 1))
        inputs.nu = mp.mpf(all_ - 1)
    elif between == "included":
        mean = mp.fsum(m for m, _, _ in groups) / count
        variance = mp.fsum((m - mean) ** 2 for m, _, _ in groups) / (count - 1) / count
        inputs.nu = mp.mpf(count - 1)
    else:
        raise NotImplementedError("components of variance")
    unit = factor(setup.get("unit"))
    inputs.add("mean", mp.sqrt(variance) * unit)
    return {setup.get("symbol", "V"): Dual(mean * unit, {"mean": mp.mpf(1)})}, inputs
