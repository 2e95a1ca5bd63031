"""The model "calibration curve" with the uncertainty from the residuals (JCGM 100 H.3): polynomials by their normal equations in 40 digits."""
import mpmath as mp

from dual import Dual
from equations import Inputs
from networks import table
from units import factor, number


def evaluate(entry, project):
    setup = entry["setup"]
    if setup.get("uncertainty", "residuals") != "residuals" or setup.get("inverse"):
        raise NotImplementedError("stated uncertainties of the points, inverse use")
    points = table(setup["points"], project.folder)
    x, y = [number(p["x"]) for p in points], [number(p["y"]) for p in points]
    origin = number(setup.get("origin", 0))
    powers = range(1 if setup.get("through_origin") else 0, setup.get("degree", 1) + 1)
    design = mp.matrix([[(v - origin) ** k for k in powers] for v in x])
    gain = (design.T * design) ** -1 * design.T
    coefficients = gain * mp.matrix(y)
    residuals = mp.matrix(y) - design * coefficients
    nu = len(x) - len(powers)
    s = mp.sqrt(mp.fsum(r * r for r in residuals) / nu)
    if s < mp.mpf("1e-12") * max(map(abs, y)):
        raise NotImplementedError("points without scatter")
    inputs, y_unit, x_unit = Inputs(), factor(setup.get("y_unit")), factor(setup.get("x_unit"))
    inputs.nu = mp.mpf(nu)
    for i in range(len(x)):
        inputs.add(i, s * y_unit)
    results = {}
    row = lambda weights: Dual(mp.fsum(w * c for w, c in zip(weights, coefficients)) * y_unit,
                               {i: mp.fsum(w * gain[k, i] for k, w in enumerate(weights)) for i in range(len(x))})
    for k, power in enumerate(powers):
        one = row([int(j == k) for j in range(len(powers))])
        scale = 1 / x_unit ** power
        results[f"y_{power + 1}", "curve"] = one * scale
    for i, prediction in enumerate(table(setup.get("predictions", {"columns": [], "rows": []}), project.folder)):
        results[f"b_{i + 1}", "use"] = row([(number(prediction["x"]) - origin) ** k for k in powers])
    return results, inputs
