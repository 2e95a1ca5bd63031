"""Standard uncertainty and degrees of freedom of a typed statement (JCGM 100 4.2, 4.3, F.2; JCGM 101 6.4)."""
import mpmath as mp

INFINITE = mp.inf


def quantile_normal(p):
    return mp.sqrt(2) * mp.erfinv(2 * mp.mpf(p) - 1)


def student_cdf(t, nu):
    x = nu / (nu + t * t)
    tail = mp.betainc(nu / 2, mp.mpf(1) / 2, 0, x, regularized=True) / 2
    return 1 - tail if t > 0 else tail


def quantile_student(p, nu):
    """p > 1/2."""
    if nu == INFINITE:
        return quantile_normal(p)
    guess = quantile_normal(p) * (1 + (quantile_normal(p) ** 2 + 1) / (4 * mp.mpf(nu)))
    return mp.findroot(lambda t: student_cdf(t, mp.mpf(nu)) - p, (guess, guess * mp.mpf("1.05")), tol=1e-30)


def of_statement(kind, a, b, value):
    """(u, shift of the estimate); figures in one unit, `value` the estimate in it."""
    a = None if a is None else mp.mpf(repr(a))
    b = None if b is None else mp.mpf(repr(b))
    if kind in (None, "", "constant"):
        return mp.mpf(0)
    if kind == "standard":
        return a
    if kind == "standard-deviation":
        return a / mp.sqrt(b if b is not None else 1)
    if kind == "certificate-k":
        return a / (b if b is not None else 2)
    if kind == "rectangular":
        return a / mp.sqrt(3)
    if kind == "limits":
        return (b - a) / mp.sqrt(12)
    if kind == "triangular":
        return a / mp.sqrt(6)
    if kind == "arcsine":
        return a / mp.sqrt(2)
    if kind == "resolution":
        return a / mp.sqrt(12)
    if kind == "trapezoidal":  # b: ratio of top to base
        return a * mp.sqrt((1 + b ** 2) / 6)
    if kind == "curvilinear-trapezoid":  # b: inexactness of the half-width
        return mp.sqrt(a ** 2 / 3 + b ** 2 / 9)
    if kind == "mpe":
        return (a + (b or 0) / 100 * abs(value)) / mp.sqrt(3)
    if kind == "counts":
        return mp.sqrt(a)
    if kind == "laplace":
        return a
    if kind == "laplace-scale":
        return a * mp.sqrt(2)
    raise NotImplementedError(kind)


def of_distribution(kind, p):
    """(u, mean) of a distribution with these parameters (JCGM 101 6.4)."""
    half = lambda: (p["high"] - p["low"]) / 2
    middle = lambda: (p["high"] + p["low"]) / 2
    if kind in ("normal", "laplace") and "standard_deviation" in p:
        return p["standard_deviation"], p.get("mean", mp.mpf(0))
    if kind in ("rectangular", "triangular", "arcsine"):
        return half() / mp.sqrt({"rectangular": 3, "triangular": 6, "arcsine": 2}[kind]), middle()
    if kind == "exponential":
        return p["mean"], p["mean"]
    raise NotImplementedError(kind)
