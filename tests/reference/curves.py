"""The model "calibration curve" with the uncertainty from the residuals (JCGM 100 H.3): polynomials by their normal equations in 40 digits."""
import mpmath as mp

import linear
from dual import Dual
from first_order import Inputs
from tables import table
from units import factor, number


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    if setup.get("uncertainty", "residuals") != "residuals" or setup.get("inverse"):
        raise NotImplementedError("stated uncertainties of the points, inverse use")
    points = table(setup["points"], project.folder)
    origin, y = number(setup.get("origin", 0)), [number(p["y"]) for p in points]
    powers = range(1 if setup.get("through_origin") else 0, setup.get("degree", 1) + 1)
    powers_of = lambda x: [(number(x) - origin) ** k for k in powers]
    solution, gain, s, inputs.nu = linear.fitted(mp.matrix([powers_of(p["x"]) for p in points]), y)
    if s < mp.mpf("1e-12") * max(map(abs, y)):
        raise NotImplementedError("points without scatter")
    x_unit, y_unit = factor(setup.get("x_unit")), factor(setup.get("y_unit"))
    deviations = [inputs.deviation(i, s * y_unit) for i in range(len(y))]
    coefficients = [sum((e * gain[k, i] for i, e in enumerate(deviations)), Dual(c * y_unit)) for k, c in enumerate(solution)]
    results = {(f"y_{power + 1}", "curve"): c / x_unit ** power for power, c in zip(powers, coefficients)}
    for i, prediction in enumerate(table(setup.get("predictions"), project.folder)):
        results[f"b_{i + 1}", "use"] = sum((c * w for c, w in zip(coefficients, powers_of(prediction["x"]))), Dual(0))
    return results, inputs
