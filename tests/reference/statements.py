"""Standard uncertainty of a typed statement (JCGM 100 4.2, 4.3, F.2; JCGM 101 6.4)."""
import mpmath as mp

from units import exact

# The figure, a half-width for example, over the standard deviation.
DIVISOR = {"standard": 1, "laplace": 1, "laplace-scale": 1 / mp.sqrt(2), "rectangular": mp.sqrt(3), "triangular": mp.sqrt(6), "arcsine": mp.sqrt(2),
           "resolution": mp.sqrt(12)}
# Of figures a and b, degrees of freedom and, in the unit of a, the estimate.
UNCERTAINTY = {
    "standard-deviation": lambda a, n, nu, value: a / mp.sqrt(1 if n is None else n),
    "certificate-k": lambda a, k, nu, value: a / (2 if k is None else k),
    "certificate-p": lambda a, percent, nu, value: a / quantile_student((1 + percent / 100) / 2, nu),
    "limits": lambda low, high, nu, value: (high - low) / mp.sqrt(12),
    "trapezoidal": lambda a, ratio, nu, value: a * mp.sqrt((1 + ratio ** 2) / 6),  # of top to base
    "curvilinear-trapezoid": lambda a, inexactness, nu, value: mp.sqrt(a ** 2 / 3 + inexactness ** 2 / 9),  # of the half-width
    "mpe": lambda a, percent, nu, value: (a + (percent or 0) / 100 * abs(value)) / mp.sqrt(3),
    "counts": lambda a, b, nu, value: mp.sqrt(a)}


def quantile_normal(p):
    return mp.sqrt(2) * mp.erfinv(2 * mp.mpf(p) - 1)


def student_cdf(t, nu):
    tail = mp.betainc(nu / 2, mp.mpf(1) / 2, 0, nu / (nu + t * t), regularized=True) / 2
    return 1 - tail if t > 0 else tail


def quantile_student(p, nu):
    """p > 1/2."""
    normal = quantile_normal(p)
    if nu == mp.inf:
        return normal
    guess = normal * (1 + (normal ** 2 + 1) / (4 * nu))
    return mp.findroot(lambda t: student_cdf(t, nu) - p, (guess, guess * mp.mpf("1.05")), tol=1e-30)


def of_statement(row, nu, value):
    """u of a row of the table of quantities, in the unit of its figures."""
    a, b = (None if row.get(key) is None else exact(row[key]) for key in "ab")
    kind = row["statement"]
    if kind in DIVISOR:
        return a / DIVISOR[kind]
    if kind in UNCERTAINTY:
        return UNCERTAINTY[kind](a, b, nu, value)
    raise NotImplementedError(kind)


def of_distribution(kind, p):
    """(u, mean) of a distribution with these parameters (JCGM 101 6.4)."""
    if kind in ("normal", "laplace") and "standard_deviation" in p:
        return p["standard_deviation"], p.get("mean", mp.mpf(0))
    if kind in ("rectangular", "triangular", "arcsine"):
        return (p["high"] - p["low"]) / 2 / DIVISOR[kind], (p["high"] + p["low"]) / 2
    if kind == "exponential":
        return p["mean"], p["mean"]
    raise NotImplementedError(kind)
