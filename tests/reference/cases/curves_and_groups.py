"""Straight lines and parabolas through points, and observations in groups, with their closed forms."""
import random

import mpmath as mp

from book import Book

LINE = "closed form (JCGM 100 H.3, Eqs H.13); second evaluator, 50 digits"
GROUPS = "closed form; second evaluator (tests/reference/groups.py), 50 digits"


def main():
    book = Book("curves-and-groups", "Lines through points, and observations in groups",
                "Straight lines and parabolas by least squares with the uncertainty of their residuals; means of observations that were made in groups. Invented figures; reference values: see covaria verify.")
    for number in range(12):
        draw = random.Random(f"line {number}")
        n, degree, origin = 4 + number, 2 if number % 4 == 3 else 1, draw.choice((0, 20, -3))
        points = [[round(2.5 * i + draw.uniform(0, 1), 2), round(0.37 * i * i * (degree == 2) + 1.2 * i + 4 + draw.gauss(0, 0.05), 3)] for i in range(n)]
        setup = {"degree": degree, "origin": origin, "points": {"columns": ["x", "y"], "rows": points}}
        name = ("Straight line" if degree == 1 else "Parabola") + f" through {n} points"
        entry = book.analysis(f"curve-{number + 1}", "calibration-curve", name, setup)
        expected = {}
        if degree == 1:
            x, y = ([mp.mpf(p[k]) - (origin if k == 0 else 0) for p in points] for k in (0, 1))
            sx, sy, sxx, sxy = mp.fsum(x), mp.fsum(y), mp.fsum(v * v for v in x), mp.fsum(a * b for a, b in zip(x, y))
            d = n * sxx - sx ** 2
            a, b = (sy * sxx - sx * sxy) / d, (n * sxy - sx * sy) / d
            s = mp.sqrt(mp.fsum((q - a - b * p) ** 2 for p, q in zip(x, y)) / (n - 2))
            expected = {("y_1", "curve"): (a, s * mp.sqrt(sxx / d)), ("y_2", "curve"): (b, s * mp.sqrt(n / d))}
        book.case(name + f", {number + 1}", LINE, entry, {}, None, expected, ["JCGM 100:2008, H.3"])
    for number in range(6):
        draw = random.Random(f"groups {number}")
        groups, each, between = 3 + number, 2 + number % 3, "none" if number % 2 else "included"
        rows = [[f"day {g + 1}", round(10 + 0.02 * draw.gauss(0, 1) + 0.01 * draw.gauss(0, 1), 4)] for g in range(groups) for _ in range(each)]
        setup = {"between": between, "observations": {"columns": ["group", "value"], "rows": rows}}
        name = f"{groups} groups of {each} observations, differences between groups {'left out' if number % 2 else 'included'}"
        entry = book.analysis(f"groups-{number + 1}", "observations-in-groups", name, setup)
        values = [mp.mpf(v) for _, v in rows]
        parts = [mp.fsum(values[g * each:(g + 1) * each]) / each for g in range(groups)] if between == "included" else values
        mean = mp.fsum(parts) / len(parts)
        u = mp.sqrt(mp.fsum((v - mean) ** 2 for v in parts) / (len(parts) - 1) / len(parts))
        book.case(name, GROUPS, entry, {}, None, {"V": (None, u)}, ["JCGM 100:2008, H.5", "JCGM 100:2008, 4.2.3"])
    book.write("Lines and groups: closed forms and a second evaluator at 50 digits, made by tests/reference/cases/curves_and_groups.py")


if __name__ == "__main__":
    main()
