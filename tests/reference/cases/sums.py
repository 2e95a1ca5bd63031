"""Sums y = x + r with r rectangular, by a Monte Carlo method with reduced variance: what is left of it is the inversion of characteristic functions, held against
integrals of distribution functions in 50 digits. And what skewness and excess kurtosis scatter by chance."""
import mpmath as mp

from book import Book, upper_tail

HALF = mp.mpf("0.75")
CLOSED = "distribution function of the sum, 50 digits; tests/reference/cases/sums.py"


def clipped(x):
    return min(max(x, mp.mpf(0)), mp.mpf(1))


def uniform(low, high):
    return lambda x: clipped((x - low) / (high - low))


def smeared(function, *breaks):
    """Distribution function of the sum of x, with its distribution function and where that is not smooth, and r."""
    return lambda y: mp.quad(function, sorted({y - HALF, y + HALF, *(b for b in map(mp.mpf, breaks) if abs(b - y) < HALF)})) / (2 * HALF)


def stepped(values, probabilities):
    whole = mp.fsum(probabilities)
    return lambda y: mp.fsum(p * clipped((y - v + HALF) / (2 * HALF)) for v, p in zip(values, probabilities)) / whole


def curvilinear(x, w=mp.mpf(1), d=mp.mpf("0.4")):
    """Half-width rectangular in w -+ d."""
    t, (low, high) = abs(x), (w - d, w + d)
    inside = min(max(t, low), high)
    part = (inside - low + t * mp.log(high / inside)) / (2 * d) if t < high else mp.mpf(1)
    return (1 + mp.sign(x) * part) / 2


def trapezoidal(x, long=mp.mpf("1.3"), short=mp.mpf("0.7")):
    """The sum of two rectangular numbers, half-widths 1.3 and 0.7."""
    corner = lambda z: max(z, 0) ** 2
    return (corner(x + long + short) - corner(x + long - short) - corner(x - long + short) + corner(x - long - short)) / (8 * long * short)


def student(x, nu=mp.mpf(9)):
    upper = upper_tail(abs(x), nu) if x else mp.mpf(1) / 2
    return 1 - upper if x > 0 else upper


LAPLACE = mp.mpf("0.5") / mp.sqrt(2)
HISTOGRAM = [(0, 1, 1), (1, 2, 2), (2, 4, 1)]
# x: its row, observations, distribution function of y, mean and u of x
CASES = {
    "rectangular": (["", "limits", -1, 3, None], None, smeared(uniform(-1, 3), -1, 3), 1, 2 / mp.sqrt(3)),
    "limits inexactly known": ([0, "curvilinear-trapezoid", 1, 0.4, None], None, smeared(curvilinear, *"-1.4 -0.6 0 0.6 1.4".split()), 0, mp.sqrt(mp.mpf(1) / 3 + mp.mpf("0.16") / 9)),
    "trapezoidal": ([0, "trapezoidal", 2, 0.3, None], None, smeared(trapezoidal, *"-2 -0.6 0.6 2".split()), 0, 2 * mp.sqrt(mp.mpf("1.09") / 6)),
    "arc sine": ([0, "arcsine", 1, None, None], None, smeared(lambda x: mp.mpf(x > 0) if abs(x) >= 1 else mp.mpf(1) / 2 + mp.asin(x) / mp.pi, -1, 1), 0, 1 / mp.sqrt(2)),
    "normal": ([10, "standard", 2, None, None], None, smeared(lambda x: mp.ncdf((x - 10) / 2), 10), 10, 2),
    "Student t": ([5, "standard", 2, None, 9], None, smeared(lambda x: student((x - 5) / 2), 5), 5, 2 * mp.sqrt(mp.mpf(9) / 7)),
    "exponential": ([3, "exponential", None, None, None], None, smeared(lambda x: 1 - mp.exp(-x / 3) if x > 0 else mp.mpf(0), 0), 3, 3),
    "gamma": (["", "counts", 4, None, None], None, smeared(lambda x: mp.gammainc(5, 0, x, regularized=True) if x > 0 else mp.mpf(0), 0), 5, mp.sqrt(5)),
    "Laplace": ([3, "laplace", 0.5, None, None], None, smeared(lambda x: mp.exp((x - 3) / LAPLACE) / 2 if x < 3 else 1 - mp.exp((3 - x) / LAPLACE) / 2, 3), 3, mp.mpf("0.5")),
    "Weibull": (["", "weibull", 2, 1.5, None], None, smeared(lambda x: 1 - mp.exp(-(x / 2) ** mp.mpf("1.5")) if x > 0 else mp.mpf(0), 0), 2 * mp.gamma(mp.mpf(5) / 3),
                2 * mp.sqrt(mp.gamma(mp.mpf(7) / 3) - mp.gamma(mp.mpf(5) / 3) ** 2)),
    "Poisson": (["", "poisson", 12, None, None], None, stepped(range(120), [mp.exp(-12) * mp.mpf(12) ** k / mp.factorial(k) for k in range(120)]), 12, mp.sqrt(12)),
    "binomial": (["", "binomial", 50, 10, None], None, stepped(range(51), [mp.binomial(50, k) * mp.mpf("0.1") ** k * mp.mpf("0.9") ** (50 - k) for k in range(51)]), 5, mp.sqrt("4.5")),
    "sample": (["", "sample", None, None, None], [[1, 1], [2, 4], [3, 3], [5, 2]], stepped([1, 2, 3, 5], [1, 4, 3, 2]), mp.mpf("2.8"), mp.sqrt("1.56")),
    "histogram": (["", "histogram", None, None, None], [[0, 1], [1, 2], [2, 1], [4, None]], smeared(lambda x: mp.fsum(w * uniform(low, high)(x) for low, high, w in HISTOGRAM) / 4, 0, 1, 2, 4),
                  mp.mpf(13) / 8, mp.sqrt(mp.mpf(43) / 12 - mp.mpf(169) / 64))}


def quantile(function, p, mean, u):
    return mp.findroot(lambda y: function(y) - p, (mean - 3 * u, mean + 3 * u), solver="anderson", tol=mp.mpf(10) ** -30)


def scattered(function, mean, u, low, high):
    """Standard errors of the two ends and, relative, of their distance by u in 10^6 trials."""
    with mp.workdps(15):
        steps, step = range(1, 200), u / 10
        fourth = mp.fsum(4 * (i * step) ** 3 * (1 - function(mean + i * step) + function(mean - i * step)) for i in steps) * step
        tail, f = mp.mpf("0.025"), [(function(end + step / 1000) - function(end - step / 1000)) * 500 / step for end in (low, high)]
        ends = [mp.sqrt(tail * (1 - tail)) / (1000 * one) for one in f]
        width = mp.sqrt(ends[0] ** 2 + ends[1] ** 2 - 2 * tail * tail / (f[0] * f[1]) / 10 ** 6) / (high - low)
        return *ends, mp.hypot(width, mp.sqrt((fourth / u ** 4 - 1) / 4) / 1000)


def main():
    book = Book("sums", "Sums of two quantities", "One quantity of each distribution and a rectangular one, by Monte Carlo with reduced variance. Reference values: see covaria verify.")
    for number, (name, (row, observations, function, mean, u_x)) in enumerate(CASES.items(), 1):
        setup = {"equations": "y = x + r", "quantities": {"columns": ["symbol", "value", "statement", "a", "b", "nu"],
                                                         "rows": [["x", None if row[0] == "" else row[0], *row[1:]], ["r", 0, "rectangular", float(HALF), None, None]]}}
        if observations:
            setup["observations"] = {"columns": ["quantity", "value", "weight"], "rows": [["x", *values] for values in observations]}
        entry = book.analysis(f"sum-{number}", "measurement-equation", f"x is {name}", setup, {"trials": 100000, "varianceReduction": "control-variate"})
        u = mp.sqrt(u_x ** 2 + HALF ** 2 / 3)
        low, high = (quantile(function, mp.mpf(p), mean, u) for p in ("0.025", "0.975"))
        check = lambda what, figure, reference, **more: {"what": f"{what}, {name} and rectangular", "analysis": entry["id"], "output": "y", "figure": figure, "reference": float(reference), **more}
        *of_ends, of_ratio = scattered(function, mean, u, low, high)
        exact = {"absolute": float(mp.nstr(u * mp.mpf("2e-7" if name == "Weibull" else "2e-8"), 2))}  # that one by a quadrature
        checks = [check("mean", "mc-mean", mean, **exact), check("u, Monte Carlo", "mc-u", u, **exact)]
        for what, figure, value, scatter in (("lower end", "mc-low", low, of_ends[0]), ("upper end", "mc-high", high, of_ends[1])):
            checks.append(check(f"{what}, Monte Carlo", figure, value, **({"scatter": float(mp.nstr(scatter, 4))} if name in ("Poisson", "binomial") else exact)))  # steps have no inversion
        ratio = (high - low) / (2 * u * mp.sqrt(2) * mp.erfinv(mp.mpf("0.95")))
        normal = max(abs(ratio - 1), abs(high + low - 2 * mean) / (high - low) * ratio) < mp.mpf("0.05")
        checks += [check("standard error of the skewness by chance, times the root of the trials", "mc-skewness-error", mp.sqrt(6), condition=2),
                   check("standard error of the excess kurtosis by chance, times the root of the trials", "mc-kurtosis-error", mp.sqrt(24), condition=2),
                   check("width of the interval by that of a normal distribution", "mc-coverage-ratio", ratio, scatter=float(mp.nstr(of_ratio * ratio, 4))),
                   check("a normal distribution describes it", "mc-normal", normal, absolute=1e-9)]
        book.cases.append({"project": "resources/verification/sums.covaria", "title": f"Sum of a quantity that is {name} and a rectangular one", "source": CLOSED,
                           "clauses": ["JCGM 101:2008, 5.3.2", "JCGM 101:2008, 7"], "checks": checks})
    for trials, deviates in ((200, False), (40000, True)):  # 9 % of the width lie within what 200 trials tell
        entry = book.analysis(f"trials-{trials}", "measurement-equation", f"{trials} trials", {"equations": "y = x + r", "quantities": {
            "columns": ["symbol", "value", "statement", "a"], "rows": [["x", 1, "rectangular", 2], ["r", 0, "rectangular", float(HALF)]]}}, {"trials": trials})
        check = {"what": f"a normal distribution describes it, as far as {trials} trials tell", "analysis": entry["id"], "output": "y", "figure": "mc-normal", "reference": float(not deviates), "absolute": 1e-9}
        book.cases.append({"project": "resources/verification/sums.covaria", "title": f"Verdict on a normal distribution of {trials} trials", "source": CLOSED,
                           "clauses": ["JCGM 101:2008, 8"], "checks": [check]})
    book.write("Sums: distribution functions at 50 digits, made by tests/reference/cases/sums.py")


if __name__ == "__main__":
    main()
