"""The model "distance meter on a baseline" (ISO 17123-4): d = X_to - X_from - delta by least squares, u from the residuals; scale by reference lengths."""
import mpmath as mp

import linear
from dual import Dual
from first_order import Inputs
from tables import table
from units import quantity


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    readings = table(setup["readings"], project.folder)
    if any("height" in key for row in readings for key in row):
        raise NotImplementedError("slope distances")
    first = readings[0]["from"]
    begin = {first: mp.mpf(0)} | {row["to"]: row["distance"] for row in readings if row["from"] == first}
    order = sorted(begin, key=begin.get)[1:]
    design = mp.matrix([[int(name == row["to"]) - int(name == row["from"]) for name in order] + [-1] for row in readings])  # X_2 ... X_n, delta
    solution, gain, s, nu = linear.fitted(design, [row["distance"] for row in readings])
    deviations = [inputs.deviation(i, s, nu, "distances") for i in range(len(readings))]
    *places, delta = [sum((e * gain[k, i] for i, e in enumerate(deviations)), Dual(v)) for k, v in enumerate(solution)]
    results = {"delta": delta, "s": Dual(s) + inputs.deviation("s", s / mp.sqrt(2 * nu))}
    results |= {f"X_{k + 2}": x for k, x in enumerate(places)}
    if setup.get("scale") == "reference":
        rows, known = table(setup["reference"], project.folder), dict(zip(order, places))
        m = scale_of(rows, [known[row["pillar"]] for row in rows], s, inputs, inputs.deviation("reference scale", quantity(setup, "u_reference_scale")))
        results["m"] = m + inputs.deviation("atmosphere", quantity(setup, "u_atmosphere"))
    return results, inputs


def scale_of(rows, x, s, inputs, common):
    """Generalised least squares of reference - X = m X, with the covariance of X and of the reference lengths."""
    covariance = mp.matrix([[s ** 2 * mp.fsum(d * b.g[k] for k, d in a.g.items()) for b in x] for a in x])
    covariance += mp.diag([row["u"] ** 2 for row in rows])
    lengths = mp.matrix([value.v for value in x])
    weights = lengths.T * covariance ** -1
    weights /= (weights * lengths)[0]
    return sum(((Dual(row["distance"]) * (1 + common) + inputs.deviation(("reference", row["pillar"]), row["u"]) - value) * weight
                for row, value, weight in zip(rows, x, weights)), Dual(0))
