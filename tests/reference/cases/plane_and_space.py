"""Points from distances, azimuths, directions and zenith angles: closed forms where there are some, and networks that the second evaluator adjusts."""
import math
import random

import mpmath as mp

from book import Book

EVALUATED = "second evaluator (tests/reference/networks.py), 50 digits"
CLOSED = "closed form; tests/reference/cases/plane_and_space.py, 50 digits"
GON = 200 / math.pi


class Net:
    """Points that are known, and readings made of them, rounded as they are typed."""

    def __init__(self, seed, noise=True):
        self.draw, self.points, self.rows, self.true, self.noise = random.Random(seed), [], [], {}, noise
        self.orientations = {}

    def point(self, name, x, y, z=None, state="unknown", typed=False):
        self.true[name] = (x, y, z or 0.0)
        show = typed or state in ("fixed", "datum")
        self.points.append([name, x if show else None, y if show else None, z if show and z is not None else None, state, "none" if z is None else state])
        return self

    def delta(self, a, b):
        return [q - p for p, q in zip(self.true[a], self.true[b])]

    def read(self, kind, a, b, u):
        dx, dy, dz = self.delta(a, b)
        if kind in ("slope-distance", "horizontal-distance", "height-difference"):
            value = {"slope-distance": math.hypot(dx, dy, dz), "horizontal-distance": math.hypot(dx, dy), "height-difference": dz}[kind]
            value += self.draw.gauss(0, u * 1e-3) * self.noise
            self.rows.append([kind, a, b, round(value, 5), None, u, None])
        else:
            value = math.atan2(dy, dx) if kind in ("azimuth", "direction") else math.atan2(math.hypot(dx, dy), dz)
            if kind == "direction":
                value -= self.orientations.setdefault(a, round(self.draw.uniform(0, 6), 3))
            value = value * GON + self.draw.gauss(0, u) * self.noise
            self.rows.append([kind, a, b, None, round(value % 400, 6), None, u])
        return self

    def setup(self):
        return {"points": {"columns": ["name", "x [m]", "y [m]", "z [m]", "plane", "height"], "rows": self.points},
                "readings": {"columns": ["kind", "from", "to", "length [m]", "angle [gon]", "u_length [mm]", "u_angle [gon]"], "rows": self.rows}}

    def started(self):
        return {(axis, name): mp.mpf(p[i]) for name, p in self.true.items() for i, axis in enumerate("xyz")}


def main():
    book = Book("plane-and-space", "Points from distances, azimuths, directions and zenith angles",
                "Polar points, intersections, trilaterations, resections and small networks in the plane and in space. Simulated readings; the figures are exact or of a second evaluator: see covaria verify.")
    units = {None: "m"}

    def add(key, title, source, net, expected=None):
        entry = book.analysis(key, "network-adjustment", title, net.setup())
        units_of = {symbol: "gon" for symbol in (f"o_{name}" for name in net.true)}
        book.case(title, source, entry, units | units_of, net.started(), expected, ["JCGM 102:2011, 6.3"])

    for number, (d, a) in enumerate([(10, 0), (25, 50), (40, 100), (12.5, 130), (80, 210), (3, 290), (150, 333), (60, 390)]):
        angle, r = a / GON, mp.mpf(str(d))
        net = Net(f"polar {number}", noise=False).point("S", 0, 0, state="fixed")
        net.point("P", round(d * math.cos(angle), 4), round(d * math.sin(angle), 4)).read("horizontal-distance", "S", "P", 0.6).read("azimuth", "S", "P", 0.002)
        read_d, read_a = mp.mpf(str(net.rows[0][3])), mp.mpf(str(net.rows[1][4])) * mp.pi / 200
        along, across = mp.mpf("0.6e-3"), mp.mpf("0.002") * mp.pi / 200 * read_d
        c, s = mp.cos(read_a), mp.sin(read_a)
        add(f"polar-{number + 1}", f"Polar point in the plane, {d} m and {a} gon", CLOSED, net,
            {("x", "P"): (read_d * c, mp.sqrt((along * c) ** 2 + (across * s) ** 2)), ("y", "P"): (read_d * s, mp.sqrt((along * s) ** 2 + (across * c) ** 2))})
    for number, (x, y) in enumerate([(5, 5), (0, 12), (10, 8), (-4, 6), (20, 3), (5, 60), (2, -9), (30, -30), (5, 1), (9, 0.5)]):
        net = Net(f"trilateration {number}", noise=False).point("A", 0, 0, state="fixed").point("B", 10, 0, state="fixed").point("P", x, y, typed=True)
        net.read("horizontal-distance", "A", "P", 0.5).read("horizontal-distance", "B", "P", 0.8)
        r, q = (mp.mpf(str(row[3])) for row in net.rows)
        px = (r ** 2 - q ** 2 + 100) / 20
        py = mp.sign(y) * mp.sqrt(r ** 2 - px ** 2)
        u, w = mp.mpf("0.5e-3"), mp.mpf("0.8e-3")
        dx = (r / 10 * u, -q / 10 * w)
        dy = ((r * u - px * dx[0]) / py, -px * dx[1] / py)
        add(f"two-distances-{number + 1}", f"Point from two distances, near ({x}, {y}) m", CLOSED, net, {("x", "P"): (px, mp.hypot(*dx)), ("y", "P"): (py, mp.hypot(*dy))})
    for number, (x, y) in enumerate([(10, 10), (3, 14), (-8, 9), (40, 25), (10, 2), (5, -30), (25, 7), (12, 90)]):
        net = Net(f"intersection {number}", noise=False).point("A", 0, 0, state="fixed").point("B", 20, 0, state="fixed").point("P", x, y)
        net.read("azimuth", "A", "P", 0.001).read("azimuth", "B", "P", 0.0015)
        t, v = (mp.mpf(str(row[4])) * mp.pi / 200 for row in net.rows)
        u, w = mp.mpf("0.001") * mp.pi / 200, mp.mpf("0.0015") * mp.pi / 200
        turn = mp.sin(v - t)
        r = 20 * mp.sin(v) / turn  # from A, by the law of sines
        slopes = (-20 * mp.sin(v) * (-mp.cos(v - t)) / turn ** 2, 20 * (mp.cos(v) * turn - mp.sin(v) * mp.cos(v - t)) / turn ** 2)
        ux = mp.hypot((slopes[0] * mp.cos(t) - r * mp.sin(t)) * u, slopes[1] * mp.cos(t) * w)
        uy = mp.hypot((slopes[0] * mp.sin(t) + r * mp.cos(t)) * u, slopes[1] * mp.sin(t) * w)
        add(f"intersection-{number + 1}", f"Intersection of two azimuths, near ({x}, {y}) m", CLOSED, net, {("x", "P"): (r * mp.cos(t), ux), ("y", "P"): (r * mp.sin(t), uy)})
    for number, (d, a, z) in enumerate([(10, 20, 100), (35, 120, 80), (60, 260, 115), (5, 350, 60), (120, 75, 99), (22, 180, 140)]):
        net = Net(f"polar space {number}", noise=False).point("S", 0, 0, 0.0, state="fixed")
        level = d * math.sin(z / GON)
        net.point("P", level * math.cos(a / GON), level * math.sin(a / GON), d * math.cos(z / GON))
        net.read("slope-distance", "S", "P", 0.6).read("azimuth", "S", "P", 0.002).read("zenith-angle", "S", "P", 0.003)
        r, t, q = mp.mpf(str(net.rows[0][3])), mp.mpf(str(net.rows[1][4])) * mp.pi / 200, mp.mpf(str(net.rows[2][4])) * mp.pi / 200
        u_r, u_t, u_q = mp.mpf("0.6e-3"), mp.mpf("0.002") * mp.pi / 200, mp.mpf("0.003") * mp.pi / 200
        norm = lambda *parts: mp.sqrt(sum(part ** 2 for part in parts))
        add(f"polar-space-{number + 1}", f"Polar point in space, {d} m, {a} gon, zenith angle {z} gon", CLOSED, net, {
            ("x", "P"): (r * mp.sin(q) * mp.cos(t), norm(mp.sin(q) * mp.cos(t) * u_r, r * mp.sin(q) * mp.sin(t) * u_t, r * mp.cos(q) * mp.cos(t) * u_q)),
            ("y", "P"): (r * mp.sin(q) * mp.sin(t), norm(mp.sin(q) * mp.sin(t) * u_r, r * mp.sin(q) * mp.cos(t) * u_t, r * mp.cos(q) * mp.sin(t) * u_q)),
            ("z", "P"): (r * mp.cos(q), norm(mp.cos(q) * u_r, r * mp.sin(q) * u_q))})
    for number, (x, y) in enumerate([(15, 8), (20, 20), (5, 12), (31, 6), (12, 28), (18, -14)]):
        net = Net(f"resection {number}")
        for name, place in {"A": (0, 0), "B": (30, 0), "C": (33, 24), "D": (-2, 27)}.items():
            net.point(name, *place, state="fixed")
        net.point("S", x, y)
        for name in "ABCD":
            net.read("direction", "S", name, 0.001)
        add(f"resection-{number + 1}", f"Resection by four directions, near ({x}, {y}) m", EVALUATED, net)
    for number in range(6):
        net = Net(f"held space {number}")
        draw = net.draw
        for name, place in {"A": (0.0, 0.0, 1.2), "B": (24.0, 1.5, 1.4), "C": (20.0, 16.0, 2.1), "D": (-2.0, 14.0, 0.9)}.items():
            net.point(name, *place, state="fixed")
        net.point("S", round(draw.uniform(6, 14), 3), round(draw.uniform(5, 10), 3), 1.5)
        net.point("P", round(draw.uniform(2, 18), 3), round(draw.uniform(-6, 20), 3), round(draw.uniform(0, 5), 3))
        for target in "ABCDP":
            net.read("direction", "S", target, 0.001).read("zenith-angle", "S", target, 0.0012).read("slope-distance", "S", target, 0.6)
        add(f"station-{number + 1}", f"Station and target in space, place {number + 1}", EVALUATED, net)
    for number in range(5):
        net = Net(f"free plane {number}")
        names = "PQRST"[:3 + number % 3]
        for i, name in enumerate(names):
            net.point(name, round(20 * math.cos(6.2 * i / len(names)) + net.draw.uniform(-4, 4), 2), round(20 * math.sin(6.2 * i / len(names)) + net.draw.uniform(-4, 4), 2), state="datum")
        for i, a in enumerate(names):
            for b in names[i + 1:]:
                net.read("horizontal-distance", a, b, 0.4)
            for b in names:
                if a != b and number > 1:
                    net.read("direction", a, b, 0.002)
        add(f"free-plane-{number + 1}", f"Free network of {len(names)} points in the plane, {number + 1}", EVALUATED, net)
    book.write("Points in the plane and in space: closed forms and a second evaluator at 50 digits, made by tests/reference/cases/plane_and_space.py")


if __name__ == "__main__":
    main()
