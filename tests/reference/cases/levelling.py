"""Levelling nets whose covariance is known in closed form: rings, lines and complete graphs, held and free."""
import mpmath as mp

from book import Book

SOURCE = "closed form; tests/reference/cases/levelling.py, 50 digits"


def points(n, held, true):
    return {"columns": ["name", "z [m]", "plane", "height"],
            "rows": [[f"P{i + 1}", true[i] if (held and i == 0) or not held else None, "none", "fixed" if held and i == 0 else "unknown" if held else "datum"] for i in range(n)]}


def readings(pairs, true, u):
    """Height differences that miss the truth by up to 0.4 mm."""
    rows = []
    for number, (i, j) in enumerate(pairs):
        own = u[number] if isinstance(u, list) else u
        rows.append(["height-difference", f"P{i + 1}", f"P{j + 1}", round(true[j] - true[i] + (number * 7 % 9 - 4) * 1e-4, 4), own])
    return {"columns": ["kind", "from", "to", "length [m]", "u_length [mm]"], "rows": rows}


def main():
    book = Book("levelling", "Levelling nets with known covariance",
                "Rings, lines and complete graphs of height differences, held by one bench mark or free. Their covariances are known in closed form: see covaria verify.")
    true = [round(0.7 * ((i * 5) % 7) - 1.3 + i * 0.11, 2) for i in range(12)]

    def net(key, title, n, held, pairs, u, variance, clause="JCGM 102:2011, 6.3"):
        setup = {"points": points(n, held, true), "readings": readings(pairs, true, u)}
        entry = book.analysis(key, "network-adjustment", title, setup)
        expected = {("z", f"P{k + 1}"): (None, mp.sqrt(variance(k)) / 1000) for k in range(1 if held else 0, n)}
        book.case(title, SOURCE, entry, {"z": "m"}, {("z", f"P{k + 1}"): mp.mpf(true[k]) for k in range(n)}, expected, [clause])

    for n in range(3, 11):
        u = mp.mpf("0.3") + n
        ring = [(i, (i + 1) % n) for i in range(n)]
        net(f"ring-{n}", f"Ring of {n} height differences, held", n, True, ring, float(u), lambda k: u ** 2 * k * (n - k) / n)
    for n in range(3, 9):
        u = mp.mpf("0.4")
        ring = [(i, (i + 1) % n) for i in range(n)]
        net(f"free-ring-{n}", f"Ring of {n} height differences, free", n, False, ring, float(u), lambda k: u ** 2 * (n * n - 1) / (12 * mp.mpf(n)))
    for n in range(3, 8):
        u, pairs = mp.mpf("0.5"), [(i, j) for i in range(n) for j in range(i + 1, n)]
        net(f"free-all-{n}", f"All height differences between {n} points, free", n, False, pairs, float(u), lambda k: u ** 2 * (n - 1) / mp.mpf(n) ** 2)
        net(f"all-{n}", f"All height differences between {n} points, held", n, True, pairs, float(u), lambda k: u ** 2 * 2 / mp.mpf(n))
    for n in range(2, 7):
        u = mp.mpf("0.7")
        net(f"line-{n}", f"Line of {n - 1} height differences", n, True, [(i, i + 1) for i in range(n - 1)], float(u), lambda k: u ** 2 * k)
    for number, (a, b) in enumerate([(0.2, 0.3), (0.1, 1.0), (0.5, 0.5), (0.01, 2.0), (0.7, 0.9), (1.5, 0.4)]):
        weighted = 1 / (1 / mp.mpf(str(a)) ** 2 + 1 / mp.mpf(str(b)) ** 2)
        net(f"twice-{number + 1}", f"A height difference read twice, with {a} mm and {b} mm", 2, True, [(0, 1), (0, 1)], [a, b], lambda k: weighted)
    book.write("Levelling nets: figures of closed forms at 50 digits, made by tests/reference/cases/levelling.py")


if __name__ == "__main__":
    main()
