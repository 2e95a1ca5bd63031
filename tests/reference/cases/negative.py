"""Figures that an evaluation gets wrong when it overlooks a clause: ours, in closed form, and the naive one beside it. And quantiles of Student's t,
order statistics, probabilities of conformance and risks."""
import mpmath as mp

from book import Book, quantile, upper_tail

TRIALS = mp.mpf(10) ** 6
CLOSED = "closed form; tests/reference/cases/negative.py, 50 digits"


class Distribution:
    """Mean, u, kurtosis, and the ends of the interval of probability 0.95 with the density there."""

    def __init__(self, mean, u, kurtosis, low, high, at_low, at_high):
        self.mean, self.u, self.kurtosis, self.low, self.high, self.at_low, self.at_high = map(mp.mpf, (mean, u, kurtosis, low, high, at_low, at_high))

    @staticmethod
    def of(density, low, high, mean, u, kurtosis):
        return Distribution(mean, u, kurtosis, low, high, density(low), density(high))

    def errors(self):
        """Standard errors of what 10^6 trials tell."""
        tail = mp.mpf("0.025")
        own = [mp.sqrt(tail * (1 - tail) / TRIALS) / f for f in (self.at_low, self.at_high)]
        together = tail * tail / TRIALS / (self.at_low * self.at_high)
        half = mp.sqrt(own[0] ** 2 + own[1] ** 2 - 2 * together) / 2
        of_u = self.u * mp.sqrt((self.kurtosis - 1) / (4 * TRIALS))
        expanded = (self.high - self.low) / 2
        return {"mc-mean": (self.mean, self.u / mp.sqrt(TRIALS)), "mc-u": (self.u, of_u), "mc-low": (self.low, own[0]), "mc-high": (self.high, own[1]),
                "result-U": (expanded, half), "result-k": (expanded / self.u, expanded / self.u * mp.hypot(half / expanded, of_u / self.u))}


WORDS = {"mc-mean": "mean", "mc-u": "u, Monte Carlo", "mc-low": "lower end, Monte Carlo", "mc-high": "upper end, Monte Carlo", "result-U": "U, Monte Carlo",
         "result-k": "U/u, Monte Carlo"}


class Negative(Book):
    def equation(self, key, name, equations, quantities, columns, unit=None, options=None, observations=None, correlations=None, outputs=("y",), extra=None):
        setup = {"equations": equations, "quantities": {"columns": columns, "rows": quantities}}
        setup["outputs"] = {"columns": ["symbol"] + (["unit"] if unit else []) + (["group"] if extra == "joint" else []),
                            "rows": [[symbol] + ([unit] if unit else []) + (["joint"] if extra == "joint" else []) for symbol in outputs]}
        if observations:
            numbered = len(observations[0]) == 3
            setup["observations"] = {"columns": ["quantity", "number", "value"] if numbered else ["quantity", "value"], "rows": observations}
        entry = self.analysis(key, "measurement-equation", name, setup, options or {"trials": 1000000})
        if correlations:
            entry["correlations"] = correlations
        return entry

    def add(self, title, source, clauses, checks):
        self.cases.append({"project": f"resources/verification/{self.name}.covaria", "title": title, "source": source, "clauses": clauses, "checks": checks})

    def own_line(self, entry, y, u, nu, symbol="y", unit="1", group="", condition=8, published=None):
        """The line by the law of propagation: sums of a few terms, each rounded once or twice."""
        return [self.line(entry, symbol, group, unit, mp.mpf(y), mp.mpf(u), mp.mpf(nu), [mp.mpf(condition)] * 3)]

    def trials(self, entry, distribution, symbol="y", unit=None):
        made = []
        for figure, (value, error) in distribution.errors().items():
            check = {"what": f"{WORDS[figure]}, {symbol}", "analysis": entry["id"], "output": symbol, "figure": figure, "reference": float(value), "scatter": float(mp.nstr(error, 4))}
            if unit and figure != "result-k":
                check["unit"] = unit
            made.append(check)
        return made


def single(entry, figure, what, reference, condition=8, scale=None, unit=None, symbol="y", **more):
    made = {"what": what, "analysis": entry["id"], "output": symbol, "figure": figure, "reference": float(reference), "condition": condition}
    if scale:
        made["scale"] = scale
    if unit:
        made["unit"] = unit
    return made | more


def naive(checks, figure, value, how, **more):
    """The figure with the naive one beside it; of a line, as a check of its own."""
    for check in checks:
        if check.get("figure") == figure:
            check["naive"], check["naiveHow"] = float(value), how
            return checks
    line = next(check for check in checks if "line" in check and figure in check["line"])
    reference = line["line"][figure]
    made = {key: line[key] for key in ("analysis", "output", "group", "unit") if key in line}
    if figure in ("k", "degrees-of-freedom"):
        made.pop("unit", None)
    checks.append({"what": f"{figure}, not the naive one", **made, "figure": figure, "reference": reference, "condition": 4 * line["condition"] + 2 * line["quantileCondition"],
                   "scale": max(abs(reference), line["scale"]), "naive": float(value), "naiveHow": how, **more})
    return checks


STANDARD = ["symbol", "value", "statement", "a"]
FIRST = {"method": "first-order"}


def correlated(book):
    e = book.equation("ten-resistors", "Ten resistors by one standard", ["y = " + " + ".join(f"a_{i}*R_s" for i in range(1, 11))],
                      [["R_s", 1000, "ohm", "standard", 0.1]] + [[f"a_{i}", 1, "1", "constant", None] for i in range(1, 11)], ["symbol", "value", "unit", "statement", "a"], "ohm", FIRST)
    checks = naive(book.own_line(e, 10000, 1, mp.inf, unit="ohm"), "u", mp.sqrt(10) / 10, "adds the variances of ten resistors as if each had its own standard", published=1.0, halfDigit=0.5)
    book.add("Ten resistors in series, calibrated by one standard", "JCGM 100:2008, 5.2.2, example", ["JCGM 100:2008, 5.2.2"], checks)
    e = book.equation("difference", "Difference of two lengths by one scale", ["y = (a - b)*(1 + s)"],
                      [["a", 1000, "standard", 0.003], ["b", 999, "standard", 0.004], ["s", 0, "standard", 0.0001]], STANDARD, None, FIRST)
    u = mp.sqrt(mp.mpf("0.003") ** 2 + mp.mpf("0.004") ** 2 + mp.mpf("1e-8"))
    checks = naive(book.own_line(e, 1, u, mp.inf, condition=2000), "u", mp.sqrt(mp.mpf("25e-6") + mp.mpf("0.1") ** 2 + mp.mpf("0.0999") ** 2),
                   "gives each length a scale of its own")
    book.add("Difference of two lengths that share a scale", CLOSED, ["JCGM 100:2008, 5.2.2", "JCGM 100:2008, F.1.2.3"], checks)
    for number, r in enumerate((0.9, 0.5, -0.6)):
        e = book.equation(f"correlated-{number + 1}", f"Sum of correlated quantities, r = {r}", ["y = a + b"], [["a", 1, "standard", 0.3], ["b", 2, "standard", 0.4]], STANDARD, None, FIRST,
                          correlations=[{"first": "a", "second": "b", "coefficient": r}])
        u = mp.sqrt(mp.mpf("0.25") + mp.mpf("0.24") * mp.mpf(str(r)))
        book.add(f"Sum of two quantities with r = {r}", CLOSED, ["JCGM 100:2008, 5.2.2"], naive(book.own_line(e, 3, u, mp.inf), "u", 0.5, "leaves the covariance out"))
    pairs = [(10.1, 5.21), (10.3, 5.38), (9.9, 5.02), (10.2, 5.27), (10.0, 5.13)]
    for n in (3, 4, 5):
        own = [(mp.mpf(str(a)), mp.mpf(str(b))) for a, b in pairs[:n]]
        sums = [a + b for a, b in own]
        spread = lambda x: mp.sqrt(mp.fsum((v - mp.fsum(x) / n) ** 2 for v in x) / (n - 1) / n)
        u, ua, ub = spread(sums), spread([a for a, _ in own]), spread([b for _, b in own])
        e = book.equation(f"together-{n}", f"Two quantities observed together, n = {n}", ["y = a + b"], [["a", "observations"], ["b", "observations"]], ["symbol", "statement"], None, FIRST,
                          observations=[row for i, (a, b) in enumerate(pairs[:n], 1) for row in (["a", i, a], ["b", i, b])])
        checks = book.own_line(e, mp.fsum(sums) / n, u, n - 1, condition=300)
        checks = naive(checks, "u", mp.hypot(ua, ub), "leaves the covariance out")
        nu = mp.hypot(ua, ub) ** 4 / (ua ** 4 / (n - 1) + ub ** 4 / (n - 1))
        checks = naive(checks, "degrees-of-freedom", nu, "puts correlated means into the Welch-Satterthwaite formula, which is for independent ones")
        checks = naive(checks, "k", quantile(0.95, nu), "takes k for those degrees of freedom")
        book.add(f"Two quantities observed together {n} times", CLOSED, ["JCGM 100:2008, 5.2.3", "JCGM 100:2008, G.4.1"], checks)


def copulas(book):
    """Rectangular quantities whose stated coefficients are the least that exist: no normal scores have them, the nearest ones have r = 6/π asin(-1/4)."""
    stated, drawn = mp.mpf("-0.5"), 6 / mp.pi * mp.asin(mp.mpf("-0.25"))
    symbols = ("a", "b", "c")
    for number, weights in enumerate(((1, 1, 2), (1, -2, 3))):
        terms = " + ".join(f"{w}*{s}" for w, s in zip(weights, symbols)).replace("+ -", "- ")
        e = book.equation(f"copula-{number + 1}", f"Three rectangular quantities with r = -0.5, weights {weights}", [f"y = {terms}"], [[s, 0, "rectangular", 1] for s in symbols], STANDARD,
                          correlations=[{"first": a, "second": b, "coefficient": -0.5} for a, b in ("ab", "ac", "bc")])
        squares, products = sum(w * w for w in weights), sum(weights) ** 2 - sum(w * w for w in weights)
        u, of_trials = (mp.sqrt((squares + r * products) / 3) for r in (stated, drawn))
        scatter = float(mp.nstr(of_trials / mp.sqrt(TRIALS), 4))  # of u as for a kurtosis of 5, which no such sum has
        checks = book.own_line(e, 0, u, mp.inf) + [{"what": what, "analysis": e["id"], "output": "y", "figure": figure, "reference": float(value), "scatter": scatter}
                                                   for figure, what, value in (("mc-mean", "mean", 0), ("mc-u", "u, Monte Carlo", of_trials))]
        book.add(f"Correlated rectangular quantities at the bound of what normal scores have, weights {weights}", "moments in closed form; tests/reference/cases/negative.py, 50 digits", ["JCGM 101:2008, 5.3.2"],
                 naive(checks, "mc-u", mp.sqrt(mp.mpf(squares) / 3), "draws them independently"))


def roots(book):
    for key, name, equation, row, unit, y, part in (("edge", "Edge of a square by its area", "y = sqrt(A)", ["A", 400, "mm^2", "standard", 2], "mm", 20, 2),
                                                   ("cube", "Edge of a cube by its volume", "y = cbrt(V)", ["V", 8000, "mm^3", "standard", 24], "mm", 20, 3),
                                                   ("ball", "Diameter of a ball by its mass and density", "y = cbrt(6*m/(pi*rho))", ["m", 4.5, "g", "standard", 0.003], "mm", None, 3)):
        rows = [row] + ([["rho", 7.8, "g/cm^3", "constant", None]] if y is None else [])
        y = mp.mpf(y) if y else 10 * mp.cbrt(6 * mp.mpf("4.5") / (mp.pi * mp.mpf("7.8")))
        e = book.equation(f"root-{key}", name, [equation], rows, ["symbol", "value", "unit", "statement", "a"], unit, FIRST)
        u = y * mp.mpf(str(row[4])) / row[1] / part
        checks = naive(book.own_line(e, y / 1000, u / 1000, mp.inf, unit=unit, condition=32), "u", u * part, "carries the relative uncertainty over without the exponent")
        book.add(name, CLOSED, ["JCGM 100:2008, 5.1.2"], checks)


def resolution(book):
    for n, step in ((3, 0.1), (5, 0.01), (10, 1.0)):
        e = book.equation(f"resolution-{n}", f"{n} readings that are all the same", ["y = x + d"], [["x", None, "observations", None], ["d", 0, "resolution", step]], STANDARD, None, FIRST,
                          observations=[["x", 20.0]] * n)
        u = mp.mpf(str(step)) / mp.sqrt(12)
        checks = naive(book.own_line(e, 20, u, mp.inf), "u", 0, "takes the scatter of the indications alone, which is zero")
        book.add(f"{n} indications that are all the same, resolution {step}", CLOSED, ["JCGM 100:2008, F.2.2.1", "JCGM 100:2008, 4.3.7"], checks)
    half = mp.mpf("0.05")
    e = book.equation("one-rectangle", "One rectangular quantity", ["y = x"], [["x", 1, "rectangular", 0.05]], STANDARD)
    checks = book.own_line(e, 1, half / mp.sqrt(3), mp.inf) + book.trials(e, Distribution(1, half / mp.sqrt(3), 1.8, 1 - 0.95 * half, 1 + 0.95 * half, 10, 10))
    naive(checks, "result-U", quantile(0.95) * half / mp.sqrt(3), "takes k = 1.96 where one rectangular distribution is all there is")
    book.add("One rectangular quantity", CLOSED, ["JCGM 100:2008, G.2.3", "JCGM 101:2008, 6.4.2"], checks)


def few(book):
    values = [10.1, 9.87, 10.16, 9.81, 10.22, 9.75, 10.28, 9.69, 10.34, 9.63, 10.02, 9.94]
    for n in (2, 3, 4, 5, 6, 8, 10, 12):
        own = [mp.mpf(str(v)) for v in values[:n]]
        mean = mp.fsum(own) / n
        u, nu = mp.sqrt(mp.fsum((v - mean) ** 2 for v in own) / (n - 1) / n), n - 1
        e = book.equation(f"few-{n}", f"{n} observations", ["y = x"], [["x", "observations"]], ["symbol", "statement"], None, FIRST, observations=[["x", v] for v in values[:n]])
        checks = naive(book.own_line(e, mean, u, nu, condition=100), "U", 2 * u, "takes k = 2 whatever the number of observations")
        book.add(f"Mean of {n} observations", CLOSED, ["JCGM 100:2008, 4.2.3", "JCGM 100:2008, G.3.2", "JCGM 100:2008, G.6.4"], checks)
    for n in (4, 6, 8):  # by Monte Carlo: t with n - 1 degrees of freedom, its kurtosis exists from 5 on
        own = [mp.mpf(str(v)) for v in values[:n]]
        mean, nu = mp.fsum(own) / n, mp.mpf(n - 1)
        s = mp.sqrt(mp.fsum((v - mean) ** 2 for v in own) / (n - 1) / n)
        t = quantile(0.95, nu)
        density = mp.gamma((nu + 1) / 2) / mp.gamma(nu / 2) / mp.sqrt(nu * mp.pi) * (1 + t * t / nu) ** (-(nu + 1) / 2) / s
        e = book.equation(f"student-{n}", f"{n} observations, Monte Carlo", ["y = x"], [["x", "observations"]], ["symbol", "statement"], observations=[["x", v] for v in values[:n]])
        u = s * mp.sqrt(nu / (nu - 2))
        trials = book.trials(e, Distribution(mean, u, 3 + 6 / (nu - 4) if nu > 4 else 1e4, mean - t * s, mean + t * s, density, density))
        naive(trials, "result-U", t * u, "multiplies u of the trials, which has the tails of t, by t once more")
        naive(trials, "mc-high", mean + quantile(0.95) * s, "draws a normal distribution with u = s/√n")
        book.add(f"Mean of {n} observations by Monte Carlo", CLOSED, ["JCGM 101:2008, 6.4.9", "JCGM 101:2008, 5.3.2"], book.own_line(e, mean, s, n - 1, condition=100) + trials)


def nonlinear(book):
    chi = lambda p: 2 * mp.erfinv(mp.mpf(p)) ** 2  # quantile of chi-squared with one degree of freedom
    density = lambda x: mp.exp(-x / 2) / mp.sqrt(2 * mp.pi * x)
    second = {"secondOrder": True}
    for number, u in enumerate((1.0, 0.5, 2.0)):
        v = mp.mpf(str(u)) ** 2
        e = book.equation(f"square-{number + 1}", f"Square of a quantity about zero, u = {u}", ["y = x^2"], [["x", 0, "standard", u]], STANDARD, None, dict(second))
        low, high = v * chi("0.025"), v * chi("0.975")
        trials = book.trials(e, Distribution(v, mp.sqrt(2) * v, 15, low, high, density(low / v) / v, density(high / v) / v))
        naive(trials, "mc-u", 0, "stops at the first derivative, which is zero")
        naive(trials, "mc-mean", 0, "takes f at the estimates")
        checks = [single(e, "estimate", "estimate", 0, scale=1.0), single(e, "u", "u, first order", 0, scale=1.0), single(e, "U", "U, first order", 0, scale=1.0),
                  single(e, "low", "lower end, first order", 0, scale=1.0), single(e, "high", "upper end, first order", 0, scale=1.0),
                  {"what": "effective degrees of freedom", "analysis": e["id"], "output": "y", "figure": "degrees-of-freedom", "reference": "infinite", "condition": 1},
                  single(e, "k", "coverage factor", quantile(0.95)),
                  single(e, "u-second-order", "u, second order", mp.sqrt(2) * v, condition=1e6, naive=0.0, naiveHow="stops at the first derivative, which is zero"),
                  single(e, "validated", "law of propagation validated", 0, scale=1.0, naive=1.0, naiveHow="trusts the law of propagation without clause 8")]
        book.add(f"Square of a quantity about zero, u = {u}", CLOSED, ["JCGM 100:2008, 5.1.2 note", "JCGM 101:2008, 5.11.6", "JCGM 101:2008, 8", "JCGM 101:2008, 9.3"], checks + trials)
    e = book.equation("cosine", "Cosine error", ["y = l*cos(b)"], [["l", 1000, "constant", None], ["b", 0, "standard", 0.05]], STANDARD, None, dict(second))
    u = mp.mpf("0.05")
    mean, square = 1000 * mp.exp(-u * u / 2), 500000 * (1 + mp.exp(-2 * u * u))
    fourth = mp.mpf(10) ** 12 * (3 + 4 * mp.exp(-2 * u * u) + mp.exp(-8 * u * u)) / 8
    third = mp.mpf(10) ** 9 * (3 * mp.exp(-u * u / 2) + mp.exp(-9 * u * u / 2)) / 4
    variance = square - mean ** 2
    kurtosis = (fourth - 4 * mean * third + 6 * mean ** 2 * square - 3 * mean ** 4) / variance ** 2
    angles = [u * mp.sqrt(2) * mp.erfinv(mp.mpf(p)) for p in ("0.975", "0.025")]  # |b| beyond which a tail lies
    ends = [1000 * mp.cos(a) for a in angles]
    slopes = [2 * mp.npdf(a, 0, u) / (1000 * mp.sin(a)) for a in angles]
    trials = book.trials(e, Distribution(mean, mp.sqrt(variance), kurtosis, *ends, *slopes))
    naive(trials, "mc-mean", 1000, "takes f at the estimates")
    naive(trials, "mc-high", 1000, "lets the interval go beyond what a cosine can be")
    checks = [single(e, figure, what, value, scale=1000.0) for figure, what, value in
              (("estimate", "estimate", 1000), ("u", "u, first order", 0), ("U", "U, first order", 0), ("low", "lower end, first order", 1000), ("high", "upper end, first order", 1000))]
    checks += [{"what": "effective degrees of freedom", "analysis": "cosine", "output": "y", "figure": "degrees-of-freedom", "reference": "infinite", "condition": 1},
               single(e, "k", "coverage factor", quantile(0.95))]
    book.add("Cosine error", CLOSED, ["JCGM 100:2008, F.2.4.4", "JCGM 101:2008, 5.11.6"], checks + trials)


def bounded(book):
    ln = mp.log
    for number, m in enumerate((2, 0.5)):
        m_ = mp.mpf(str(m))
        e = book.equation(f"exponential-{number + 1}", f"Quantity that is not negative, estimate {m}", ["y = x"], [["x", m, "exponential", None]], STANDARD)
        low, high = -m_ * ln(mp.mpf("0.975")), -m_ * ln(mp.mpf("0.025"))
        trials = book.trials(e, Distribution(m_, m_, 9, low, high, mp.exp(-low / m_) / m_, mp.exp(-high / m_) / m_))
        naive(trials, "mc-low", m_ - quantile(0.95) * m_, "lets the interval reach below the bound")
        book.add(f"Quantity that is not negative, estimate {m}", CLOSED, ["JCGM 101:2008, 6.4.10", "JCGM 100:2008, F.2.4.1"], book.own_line(e, m_, m_, mp.inf) + trials)
    for number, (x, u) in enumerate(((0.5, 1.0), (0.2, 0.4), (1.0, 0.7))):
        m, s = mp.mpf(str(x)), mp.mpf(str(u))
        e = book.equation(f"cut-{number + 1}", f"Quantity cut at its bound, {x} with u = {u}", ["y = max(x, 0)"], [["x", x, "standard", u]], STANDARD)
        z = m / s
        mean = m * mp.ncdf(z) + s * mp.npdf(z)
        moment = [mp.quad(lambda v, k=k: v ** k * mp.npdf(v, m, s), [0, m, m + 5 * s, m + 40 * s]) for k in range(5)]
        variance = moment[2] - mean ** 2
        kurtosis = (moment[4] - 4 * mean * moment[3] + 6 * mean ** 2 * moment[2] - 3 * mean ** 4) / variance ** 2
        high = m + quantile(0.95) * s
        errors = Distribution(mean, mp.sqrt(variance), kurtosis, 0, high, mp.mpf("1e9"), mp.npdf(high, m, s))
        trials = book.trials(e, errors)
        for check in trials:  # a tail of trials is at the bound itself
            if check["figure"] == "mc-low":
                check.pop("scatter"), check.update(condition=1, scale=1.0)
        naive(trials, "mc-low", m - quantile(0.95) * s, "lets the interval reach below the bound")
        naive(trials, "mc-mean", m, "takes f at the estimates")
        book.add(f"Quantity cut at its bound, {x} with u = {u}", CLOSED, ["JCGM 101:2008, 5.11.6", "JCGM 101:2008, 8"], book.own_line(e, m, s, mp.inf) + trials)
    for number, (nominal, a, b) in enumerate(((10, 9.9, 10.4), (20, 19.9, 20.6), (5, 4.7, 5.1))):
        a_, b_ = mp.mpf(str(a)), mp.mpf(str(b))
        e = book.equation(f"asymmetric-{number + 1}", f"Limits {a} and {b} about {nominal}", ["y = x"], [["x", "limits", a, b]], ["symbol", "statement", "a", "b"], None, FIRST)
        checks = book.own_line(e, (a_ + b_) / 2, (b_ - a_) / mp.sqrt(12), mp.inf, condition=100)
        naive(checks, "u", max(b_ - nominal, nominal - a_) / mp.sqrt(3), "takes the larger distance from the nominal value as half-width")
        naive(checks, "estimate", nominal, "keeps the nominal value")
        book.add(f"Limits that are not symmetric, {a} and {b}", CLOSED, ["JCGM 100:2008, 4.3.8"], checks)


def joint(book):
    for number, count in enumerate((2, 3)):
        symbols = ["y", "z", "w"][:count]
        e = book.equation(f"joint-{count}", f"{count} results together", [f"{s} = x_{s}" for s in symbols], [[f"x_{s}", 1, "standard", 0.1] for s in symbols], STANDARD, None, FIRST, outputs=symbols, extra="joint")
        checks = []
        for s in symbols:
            checks += book.own_line(e, 1, 0.1, mp.inf, symbol=s, group="joint")
        chi = mp.findroot(lambda x: mp.gammainc(mp.mpf(count) / 2, 0, x / 2, regularized=True) - mp.mpf("0.95"), 6 if count == 2 else 7.8)
        k = single(e, "ellipsoid", "factor of the ellipse" if count == 2 else "factor of the ellipsoid", mp.sqrt(chi), symbol="y", naive=float(quantile(0.95)), naiveHow="takes the coverage factor of one result for all together")
        q = single(e, "rectangle", "factor of the rectangle", mp.sqrt(2) * mp.erfinv(1 - mp.mpf("0.05") / count), symbol="y", naive=float(quantile(0.95)), naiveHow="joins intervals that cover 95 % each")
        k["group"] = q["group"] = "joint"
        book.add(f"{count} results together", CLOSED, ["JCGM 102:2011, 6.5"], checks + [k, q])


def conformity(book):
    places = [(3.9, 0.2, mp.inf), (3.5, 0.2, mp.inf), (3.7, 0.2, mp.inf), (-3.95, 0.1, mp.inf), (3.8, 0.2, 3), (3.8, 0.2, 5), (0.0, 1.5, 4), (4.1, 0.2, mp.inf)]
    for number, (y, u, nu) in enumerate(places):
        columns, row = ["symbol", "value", "statement", "a", "nu"], ["x", y, "standard", u, None if nu == mp.inf else nu]
        e = book.equation(f"conformity-{number + 1}", f"{y} with u = {u} within ±4", ["y = x"], [row], columns, None, FIRST)
        m, s, limits = mp.mpf(str(y)), mp.mpf(str(u)), {"lowerLimit": -4.0, "upperLimit": 4.0}
        inside = 1 - upper(( 4 - m) / s, nu) - upper((m + 4) / s, nu)
        normal = 1 - upper((4 - m) / s, mp.inf) - upper((m + 4) / s, mp.inf)
        k = quantile(0.95, nu)
        accepted = abs(m) <= 4 - k * s
        checks = book.own_line(e, m, s, nu)
        p = single(e, "conformance", "probability of conformance", inside, condition=100, requirement=limits)
        if nu != mp.inf:
            p |= {"naive": float(normal), "naiveHow": "takes the normal distribution whatever the degrees of freedom"}
        band = single(e, "guard-band", "guard band, w = U", k * s, condition=16, requirement=limits)
        verdict = single(e, "accepted", "accepted (1) or rejected (0)", int(accepted), scale=1.0, requirement=limits)
        if abs(m) <= 4 and not accepted:
            verdict |= {"naive": 1.0, "naiveHow": "accepts whatever is inside the tolerance"}
        index = single(e, "capability-index", "C_m", 8 / (4 * s), requirement=limits)
        book.add(f"Conformity of {y} with u = {u}" + ("" if nu == mp.inf else f", {nu} degrees of freedom"), CLOSED, ["JCGM 106:2012, 7", "JCGM 106:2012, 8"], checks + [p, band, verdict, index])
    for number, (u_0, u) in enumerate(((1.5, 0.2), (2.0, 0.5), (2.5, 1.0))):
        e = book.equation(f"risk-{number + 1}", f"Risks, prior {u_0}, u = {u}", ["y = x"], [["x", 1, "standard", u]], STANDARD, None, FIRST)
        s_0, s = mp.mpf(str(u_0)), mp.mpf(str(u))
        accept = 4 - quantile(0.95) * s
        in_accept = lambda v: mp.ncdf((accept - v) / s) - mp.ncdf((-accept - v) / s)
        pieces = [4, 4 + s, 4 + 4 * s, 4 + 10 * s, 4 + 30 * s]
        consumer = 2 * mp.quad(lambda v: mp.npdf(v, 0, s_0) * in_accept(v), pieces)
        producer = 2 * mp.quad(lambda v: mp.npdf(v, 0, s_0) * (1 - in_accept(v)), [0, max(accept - 8 * s, mp.mpf("0.1")), accept - s, accept, 4])
        rule = {"lowerLimit": -4.0, "upperLimit": 4.0, "priorMean": 0.0, "priorStandardDeviation": u_0}
        checks = book.own_line(e, 1, s, mp.inf)
        specific = upper((4 - mp.mpf(1)) / s, mp.inf) + upper((mp.mpf(1) + 4) / s, mp.inf)
        for key, what, value in (("consumer-risk", "global risk of the consumer", consumer), ("producer-risk", "global risk of the producer", producer)):
            checks.append(single(e, key, what, value, condition=1e5, scale=1.0, requirement=rule, naive=float(specific), naiveHow="takes the probability of this one result for the risk of the rule"))
        book.add(f"Global risks, prior {u_0}, u = {u}", CLOSED, ["JCGM 106:2012, 9.5"], checks)


def upper(t, nu):
    return upper_tail(t, nu) if t >= 0 else 1 - upper_tail(-t, nu)


def effective(book):
    e = book.equation("g41", "Product of three quantities", ["y = x_1*x_2*x_3"],
                      [["x_1", 1, "standard", 0.0025, 9], ["x_2", 1, "standard", 0.0057, 4], ["x_3", 1, "standard", 0.0082, 14]], ["symbol", "value", "statement", "a", "nu"], "%", {"method": "first-order"})
    parts = [(mp.mpf("0.0025"), 9), (mp.mpf("0.0057"), 4), (mp.mpf("0.0082"), 14)]
    u = mp.sqrt(mp.fsum(a ** 2 for a, _ in parts))
    nu = u ** 4 / mp.fsum(a ** 4 / n for a, n in parts)
    checks = book.own_line(e, 1, u, nu, unit="%", condition=20)
    naive(checks, "u", 100 * u, "", published=1.03, halfDigit=0.005)
    naive(checks, "degrees-of-freedom", 27, "adds the degrees of freedom", published=19.0, halfDigit=0.05)
    naive(checks, "k", 2, "takes k = 2", published=2.09, halfDigit=0.005)
    naive(checks, "U", 200 * u, "takes k = 2", published=2.2, halfDigit=0.05)
    for check in checks:
        if check.get("naiveHow") == "":
            check.pop("naive"), check.pop("naiveHow")
    book.add("Welch-Satterthwaite formula", "JCGM 100:2008, G.4.1, example", ["JCGM 100:2008, G.4.1", "JCGM 100:2008, G.4.2"], checks)


def student(book):
    """k of t tables, to the digits that every table prints, and to all of a double."""
    for nu in [*range(1, 21), 25, 30, 35, 40, 45, 50, 100]:
        checks = []
        for p in (0.9, 0.95, 0.99):
            e = book.equation(f"t-{nu}-{round(100 * p)}", f"Student's t, {nu} degrees of freedom, {round(100 * p)} %", ["y = x"], [["x", 0, "standard", 1, nu]], ["symbol", "value", "statement", "a", "nu"], None,
                              {"method": "first-order", "coverageProbability": p})
            line = book.own_line(e, 0, 1, nu)
            naive(line, "k", quantile(p), "takes the normal distribution whatever the degrees of freedom", published=float(mp.nstr(quantile(p, mp.mpf(nu)), 12)), halfDigit=0.005)
            k = quantile(p, mp.mpf(nu))
            line[-1]["published"] = float(mp.nint(k * 100) / 100)
            checks += line
        book.add(f"Student's t with {nu} degrees of freedom", "JCGM 100:2008, Table G.2 (90 %, 95 %, 99 %); 50 digits", ["JCGM 100:2008, G.3.2", "JCGM 100:2008, G.3.4"], checks)


def order_statistics(book):
    """The largest and the least of n rectangular quantities: beta distributions."""
    for n in (2, 3, 4, 5):
        names = [f"x_{i}" for i in range(1, n + 1)]
        for which, call in (("largest", "max"), ("least", "min")):
            nested = names[0]
            for name in names[1:]:
                nested = f"{call}({nested}, {name})"
            e = book.equation(f"{which}-{n}", f"The {which} of {n}", [f"y = {nested}"], [[name, "limits", 0, 1] for name in names], ["symbol", "statement", "a", "b"])
            mean, variance = mp.mpf(n) / (n + 1), mp.mpf(n) / ((n + 1) ** 2 * (n + 2))
            raw = [mp.mpf(n) / (n + k) for k in range(5)]
            kurtosis = (raw[4] - 4 * mean * raw[3] + 6 * mean ** 2 * raw[2] - 3 * mean ** 4) / variance ** 2
            low, high = mp.mpf("0.025") ** (mp.mpf(1) / n), mp.mpf("0.975") ** (mp.mpf(1) / n)
            at = lambda x: n * x ** (n - 1)
            made = Distribution(mean, mp.sqrt(variance), kurtosis, low, high, at(low), at(high))
            if which == "least":
                made = Distribution(1 - mean, mp.sqrt(variance), kurtosis, 1 - high, 1 - low, at(high), at(low))
            checks = book.trials(e, made)  # at the kink the law of propagation gives nothing
            naive(checks, "mc-mean", 0.5, "takes f at the estimates")
            book.add(f"The {which} of {n} rectangular quantities", "order statistics, beta distribution; closed form", ["JCGM 101:2008, 7"], checks)


def main():
    book = Negative("negative", "Where a naive evaluation goes wrong",
                    "Correlated quantities, resolution, few observations, strongly non-linear models, bounds, limits that are not symmetric, joint results, conformity. Each has the figure of a naive evaluation beside its own: see covaria verify.")
    for add in (correlated, copulas, roots, resolution, few, nonlinear, bounded, joint, conformity, effective, student, order_statistics):
        add(book)
    book.write("Negative cases: closed forms at 50 digits with the figure of a naive evaluation, made by tests/reference/cases/negative.py")


if __name__ == "__main__":
    main()
