"""Forms by orthogonal least squares: NIST's data sets, simulated points, and relations of features; distance meters on a baseline."""
import math
import random

import mpmath as mp

from book import Book

EVALUATED = "second evaluator (tests/reference/{}), 50 digits"
NIST = "NIST, Algorithm Testing System: {} and its least-squares fit (public domain), through OpenDiMet; u by a second evaluator, 50 digits"
LENGTHS = dict.fromkeys(("x", "y", "z", "d", "l", "f_t", "f_q"), "mm")
# (points, fit) of each set as NIST published them: centre, direction, diameter.
SETS = {
    "lin12": ("line", [
        "469.46048 63.21674 -202.77983", "472.53108 62.43437 -199.16563", "475.64188 61.63532 -195.48527", "478.73457 60.91587 -191.8756",
        "481.81521 60.01905 -188.28172", "484.84756 59.30902 -184.62223", "487.97207 58.49895 -181.02119", "491.10804 57.72913 -177.4045",
        "494.19922 56.94879 -173.77888", "497.25094 56.14134 -170.11855", "500.37465 55.37329 -166.48811", "503.45937 54.61203 -162.89281",
        "506.56723 53.80834 -159.27683", "509.65402 52.99382 -155.60415", "512.73879 52.20137 -151.98343"],
        "491.09034066666666667 57.722495333333333333 -177.38524866666666667 0.64019207207419047487 -0.16259354193138917386 0.75081119529183906463"),
    "pla25": ("plane", [
        "-0.80755 -1.36199 -0.17755", "-1.01607 -1.98416 0.06813", "-1.22447 -2.60609 0.31294", "-0.78427 -1.41832 -0.30379",
        "-0.99358 -2.04102 -0.05845", "-1.2008 -2.66386 0.18796"],
        "-1.0044566666666666667 -2.0125733333333333333 0.0048733333333333333333 0.94053335499333179607 -0.20929606987242093331 0.2675671192073981387"),
    "cir2": ("circle", None,
        "681.5549733770771716 -673.34977912239664663 272.41240856437418627 0.2053818345066789328 0.72876945459518842356 0.65323302435172607058 7.8812465477516351453"),
    "cyl24": ("cylinder", None,
        "-0.29897486630809583561 -0.20692103722129259813 0.71421155699545107194 -0.00079998933800503968457 0.0038993954443938215034 0.99999207733472934699 3.2877492601002778271"),
}


def begin(kind, centre, direction, diameter=None, angle=None):
    made = dict(zip("xyz", centre)) | dict(zip(("n_x", "n_y", "n_z"), direction))
    if diameter:
        made["d"] = diameter
    if angle:
        made["alpha"] = angle
    return {key: mp.mpf(str(value)) for key, value in made.items()}


def started(name, found):
    return {(symbol, name): value / 1000 if symbol in "xyzd" else value for symbol, value in found.items()}


def nist(book):
    for key, (kind, points, fit) in SETS.items():
        if points is None:
            points = [line.replace("\t", " ").strip() for line in open(f"nist-{key}.ds").read().splitlines()[1:]]
        rows = [[float(value) for value in line.split()] for line in points]
        published = [mp.mpf(value) for value in fit.split()]
        name = kind
        setup = {"features": {"columns": ["name", "form"], "rows": [[name, kind]]}, "form_deviations": False, "point_uncertainty": "scatter",
                 "points": {"columns": ["x [mm]", "y [mm]", "z [mm]"], "rows": rows}}
        entry = book.analysis(f"nist-{key}", "geometry-from-points", f"NIST {key}: {kind}", setup)
        results, _, made = book.case(f"NIST {key}: {kind} by least squares", NIST.format(key), entry, LENGTHS, started(name, begin(kind, published[:3], published[3:6], *published[6:])),
                                     None, ["JCGM 100:2008, H.3", "JCGM 102:2011, 6.3"], draws=3)
        symbols = ["x", "y", "z", "n_x", "n_y", "n_z", "d"]
        for symbol, value in zip(symbols, published):  # NIST's digits, of the same direction
            own = results[symbol, name].v * (1000 if symbol in "xyzd" else 1)
            sign = mp.sign(results["n_z", name].v) * mp.sign(published[5]) if symbol.startswith("n") else 1
            assert abs(own - sign * value) < mp.mpf(10) ** -17 * max(1, abs(value)), (key, symbol, own, value)


def simulated(book):
    shapes = {"line": 9, "plane": 10, "circle": 8, "sphere": 14, "cylinder": 16, "cone": 18, "point": 5}
    for kind, count in shapes.items():
        for number in range(5 if kind in ("cylinder", "cone") else 6):
            draw = random.Random(f"{kind} {number}")
            a, b = draw.uniform(-0.7, 0.7), draw.uniform(-0.7, 0.7)
            n = [math.sin(b), -math.sin(a) * math.cos(b), math.cos(a) * math.cos(b)]
            x = [math.cos(b), math.sin(a) * math.sin(b), -math.cos(a) * math.sin(b)]
            y = [n[1] * x[2] - n[2] * x[1], n[2] * x[0] - n[0] * x[2], n[0] * x[1] - n[1] * x[0]]
            centre, r, half = [draw.randrange(-40, 40) for _ in range(3)], draw.randrange(10, 40), draw.choice((0.1, 0.2, 0.35))
            arc = 2 * math.pi * (1, 0.5, 1, 0.35, 1, 0.7)[number]
            rows = []
            for i in range(count):
                t, h = arc * i / count, (i * 7 % count) / count * 60 - 30
                u, v, w = {"line": (0, 0, h), "plane": (2 * h * math.cos(t), 40 * math.sin(3 * t), 0), "circle": (r * math.cos(t), r * math.sin(t), 0),
                           "sphere": (r * math.cos(t) * math.cos(h / 30), r * math.sin(t) * math.cos(h / 30), r * math.sin(h / 30)),
                           "cylinder": (r * math.cos(t), r * math.sin(t), h), "point": (0, 0, 0),
                           "cone": ((r + h * math.tan(half)) * math.cos(t), (r + h * math.tan(half)) * math.sin(t), h)}[kind]
                rows.append([round(c + u * e + v * f + w * g + draw.gauss(0, 0.003), 4) for c, e, f, g in zip(centre, x, y, n)])
            scatter = number % 3 == 2 and kind != "point"
            setup = {"features": {"columns": ["name", "form"], "rows": [["F", kind]]}, "form_deviations": False, "points": {"columns": ["x [mm]", "y [mm]", "z [mm]"], "rows": rows}}
            if scatter:
                setup["point_uncertainty"] = "scatter"
            else:
                setup |= {"u_point": {"value": 0.003, "unit": "mm"}, "u_common_x": {"value": 0.002 * (number % 2), "unit": "mm"}}
            entry = book.analysis(f"{kind}-{number + 1}", "geometry-from-points", f"{kind.capitalize()} {number + 1}", setup)
            true = started("F", begin(kind, centre, n, 2 * r if kind not in ("line", "plane", "point") else None, 2 * half if kind == "cone" else None))
            expected = {}
            if kind == "point" and not number % 2:
                expected = {(axis, "F"): (None, mp.mpf("3e-6") / mp.sqrt(count)) for axis in "xyz"}
            book.case(f"{kind.capitalize()} {number + 1}, {count} points, u " + ("of their scatter" if scatter else "as stated"), EVALUATED.format("fits.py"), entry,
                      LENGTHS | {"alpha": "deg"}, true, expected, ["JCGM 102:2011, 6.3"], draws=3)


def related(book):
    kinds = {"distance": 2, "from-plane": 2, "from-line": 2, "between-lines": 2, "middle": 2, "foot-on-plane": 2, "foot-on-line": 2, "line-and-plane": 2, "two-lines": 2,
             "angle": 2, "three-planes": 3, "frame": 3}
    for kind, count in kinds.items():
        for number in range(2):
            draw = random.Random(f"{kind} {number}")
            rows = []
            for i, name in enumerate("ABC"[:count]):
                n = [draw.randrange(-9, 10) + (20 if (i + j) % 3 == 2 else 0) for j in range(3)]
                rows.append([name, *(draw.randrange(-200, 200) for _ in range(3)), *n, draw.choice((0.005, 0.01, 0.02)), draw.choice((0.05, 0.1))])
            setup = {"features": {"columns": ["name", "x [mm]", "y [mm]", "z [mm]", "n_x", "n_y", "n_z", "u [mm]", "u_n [mrad]"], "rows": rows},
                     "relations": {"columns": ["name", "relation", "first", "second", "third"],
                                   "rows": [["R", kind, "A", "B", "C" if count == 3 else None]]}}
            entry = book.analysis(f"{kind}-{number + 1}", "feature-relations", f"{kind}, {number + 1}", setup)
            expected = {}
            if kind == "middle":
                expected = {(axis, "R"): (None, mp.hypot(mp.mpf(str(rows[0][7])), mp.mpf(str(rows[1][7]))) / 2000) for axis in "xyz"}
            book.case(f"Relation {kind}, {number + 1}", EVALUATED.format("geometry.py"), entry, LENGTHS | dict.fromkeys(("phi", "alpha", "beta", "gamma"), "deg"), None, expected,
                      ["JCGM 100:2008, 5.1.2"])


def baselines(book):
    for n in range(4, 10):
        places = [round(20 * i + 3.7 * i * i + 0.13 * (i * 5 % 7), 4) for i in range(n)]
        rows = [[f"P{i + 1}", f"P{j + 1}", round(places[j] - places[i] - 0.0018 + ((i * 7 + j * 5) % 9 - 4) * 2e-4, 4)] for i in range(n) for j in range(i + 1, n)]
        setup = {"readings": {"columns": ["from", "to", "distance [m]"], "rows": rows}}
        entry = book.analysis(f"baseline-{n}", "distance-meter-baseline", f"Baseline of {n} pillars", setup)
        results, inputs, made = book.case(f"Distance meter on a baseline of {n} pillars", EVALUATED.format("baselines.py") + ", cofactor of the zero 6/((n-1)(n-2))", entry, {None: "mm"} | {f"X_{i + 1}": "m" for i in range(n)},
                                          None, None, ["JCGM 100:2008, G.3"],
                                          group_of={"delta": "instrument", "s": "scatter"} | {f"X_{i + 1}": "baseline" for i in range(n)})
        u = next(check for check in made["checks"] if check["output"] == "delta")["line"]["u"]
        cofactor = mp.mpf(6) / ((n - 1) * (n - 2))
        assert abs(mp.mpf(u) - 1000 * results["s"].v * mp.sqrt(cofactor)) < 1e-12 * u, n


def main():
    book = Book("forms", "Forms, relations of features, and baselines",
                "Points of NIST's data sets lin12, pla25, cir2 and cyl24 (public domain), and simulated ones, with forms by orthogonal least squares; typed features and what lies between them; distances between all pillars of baselines. Reference values: see covaria verify.")
    nist(book)
    simulated(book)
    related(book)
    baselines(book)
    book.write("Forms, relations and baselines: NIST's fits and a second evaluator at 50 digits, made by tests/reference/cases/forms.py")


if __name__ == "__main__":
    main()
