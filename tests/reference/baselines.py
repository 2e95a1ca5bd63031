"""The model "distance meter on a baseline" (ISO 17123-4): d = X_to - X_from - delta by least squares, u from the residuals; scale by reference lengths."""
import mpmath as mp

from dual import Dual
from equations import Inputs
from geometry import length
from networks import table


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    readings = table(setup["readings"], project.folder)
    if any("height" in key for row in readings for key in row):
        raise NotImplementedError("slope distances")
    place = {}
    for row in readings:
        place.setdefault(row["from"], len(place))
        place.setdefault(row["to"], len(place))
    begin = {name: next((r["distance"] for r in readings if (r["from"], r["to"]) == (next(iter(place)), name)), mp.mpf(0)) for name in place}
    order = sorted(place, key=lambda name: begin[name])
    design = mp.zeros(len(readings), len(order))  # X_2 ... X_n, then delta: reading + delta = X_to - X_from
    for i, row in enumerate(readings):
        for name, sign in ((row["to"], 1), (row["from"], -1)):
            if name != order[0]:
                design[i, order.index(name) - 1] = sign
        design[i, len(order) - 1] = -1
    gain = (design.T * design) ** -1 * design.T
    solution = gain * mp.matrix([row["distance"] for row in readings])
    residuals = mp.matrix([row["distance"] for row in readings]) - design * solution
    nu = mp.mpf(len(readings) - len(order))
    s = mp.sqrt(mp.fsum(r * r for r in residuals) / nu)
    deviations = [inputs.deviation(i, s, nu, "distances") for i in range(len(readings))]
    unknowns = [sum((e * gain[k, i] for i, e in enumerate(deviations)), Dual(v)) for k, v in enumerate(solution)]
    results = {"delta": unknowns[-1], "s": Dual(s) + inputs.deviation("s", s / mp.sqrt(2 * nu))}
    results |= {f"X_{k + 2}": x for k, x in enumerate(unknowns[:-1])}
    if setup.get("scale") == "reference":
        # reference = (1 + m) X: the mean of (reference - X) with the weights of lengths, the atmosphere and the shared scale beside it.
        rows = table(setup["reference"], project.folder)
        m = scale_of(rows, [unknowns[order.index(r["pillar"]) - 1] for r in rows], gain, design, order, s, inputs, length(setup, "u_reference_scale"))
        results["m"] = m + inputs.deviation("atmosphere", length(setup, "u_atmosphere"))
    return results, inputs


def scale_of(rows, x, gain, design, order, s, inputs, u_scale):
    """Generalised least squares of reference - X = m X, with the covariance of X and of the reference lengths."""
    common = inputs.deviation("reference scale", u_scale)
    n = len(rows)
    cofactors = (design.T * design) ** -1
    at = [order.index(r["pillar"]) - 1 for r in rows]
    covariance = mp.matrix(n, n)
    for i in range(n):
        for j in range(n):
            covariance[i, j] = s ** 2 * cofactors[at[i], at[j]] + (rows[i]["u"] ** 2 if i == j else 0)
    weight = covariance ** -1
    lengths = mp.matrix([v.v for v in x])
    row = lengths.T * weight
    row = row / (row * lengths)[0]
    return sum(((Dual(r["distance"]) * (1 + common) + inputs.deviation(("reference", r["pillar"]), r["u"]) - v) * row[j]
                for j, (r, v) in enumerate(zip(rows, x))), Dual(0))
