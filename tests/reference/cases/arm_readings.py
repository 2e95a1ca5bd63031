"""An arm identified from distances, touched planes and reflectors: least squares in numpy, slopes by the complex step, in double precision.

Condition numbers are those of book.py, of the size of a metre and a radian at least, with the slopes changed too. Figures are rounded on their way here as in a
program: ten conditions of the last bit, at most 4e-11 mm or 2e-9 of u for an estimate and a relative 1e-13 for u, are four times what the two differ by.
"""
import random

import mpmath as mp
import numpy as np

from book import CHANGE, Book, changed

H, MM, DEG = 1e-40, 1e-3, np.pi / 180
SIZE, UNITS = {"mm": MM, "deg": DEG}, {"theta": "deg", "d": "mm", "a": "mm", "alpha": "deg", "beta": "deg"}
# as designed: theta, d, a, alpha, beta, q_zero, direction; and how far the joints turn
ARM = [[0, 504, 170, -90, None, None, None], [-90, 0, 780, 0, 0, -90, None], [0, 0, 140, -90, None, None, None], [0, 1060, 0, 90, None, None, None],
       [0, 0, 0, -90, None, None, "negative"], [0, 125, 0, 0, None, None, None]]
RANGES = [(-150, 150), (-120, -30), (-35, 65), (-160, 160), (-115, 55), (-170, 170)]
HEADS = {"joints": "theta [deg],d [mm],a [mm],alpha [deg],beta [deg],q_zero [deg],direction", "targets": "name,x [mm],y [mm],z [mm],place",
         "places": "name,what,x [mm],y [mm],z [mm],n_x,n_y,n_z,place", "poses": "name," + ",".join(f"q_{j} [deg]" for j in range(1, 7)),
         "distances": "pose,target,what,to,value [mm],u [mm],zero", "positions": "pose,target,x [mm],y [mm],z [mm]"}


def tables(**rows):
    return {key: {"columns": HEADS[key].split(","), "rows": value} for key, value in rows.items()}


def rotation(a, b, c):  # Rz(c) Ry(b) Rx(a)
    ca, sa, cb, sb, cc, sc = np.cos(a), np.sin(a), np.cos(b), np.sin(b), np.cos(c), np.sin(c)
    return np.array([[cc * cb, cc * sb * sa - sc * ca, cc * sb * ca + sc * sa], [sc * cb, sc * sb * sa + cc * ca, sc * sb * ca - cc * sa], [-sb, cb * sa, cb * ca]])


class Readings:
    """What is typed of an analysis, in m and rad. `numbers`: all that may be unknown (symbol, group, unit, nominal value, whether it is found), in the order in which
    what those before explain is held. Of a plane: its distance from the origin, azimuth and elevation of its normal. `draw`: changes what is rounded."""

    def __init__(self, setup, joints, draw=None):
        read = lambda table: [dict(zip((head.split(" [")[0] for head in table["columns"]), row)) for row in table["rows"]]
        joints, poses, places, targets, distances, positions = map(read, (joints, *(setup[key] for key in ("poses", "places", "targets", "distances", "positions"))))
        zeros = list(dict.fromkeys(d["zero"] for d in distances if d["zero"]))
        exists = lambda joint, key: key not in ("d", "beta") or (joint["beta"] is None) == (key == "d")
        of_plane = lambda p: [("h", "plane " + p["name"], "mm", 0, True)] + 2 * [("", "", "deg", 0, True)]
        parts = {"base": [(symbol, "base", "mm" if symbol in "xyz" else "deg", 0, setup["base_place"] == "found") for symbol in ("x", "y", "z", "alpha", "beta", "gamma")],
                 "places": [n for p in places for n in (of_plane(p) if p["what"] == "plane" else [(c, p["name"], "mm", p[c] or 0, p["place"] == "found") for c in "xyz"])],
                 "zeros": [("z", "zero " + name, "mm", 0, True) for name in zeros], "targets": [(c, t["name"], "mm", t[c], True) for t in targets for c in "xyz"],
                 "joints": [(f"{key}_{j}", "", unit, joint[key] or 0, exists(joint, key)) for j, joint in enumerate(joints, 1) for key, unit in UNITS.items()]}
        self.numbers, ends = sum(parts.values(), []), np.cumsum([len(part) for part in parts.values()])
        self.at = {key: slice(end - len(part), end) for (key, part), end in zip(parts.items(), ends)}
        self.size = np.array([SIZE[number[2]] for number in self.numbers])
        self.nominal = self.size * [number[3] for number in self.numbers]
        self.turns = np.array([[(-1 if j["direction"] else 1) * (p[f"q_{i}"] - (j["q_zero"] or 0)) * DEG for i, j in enumerate(joints, 1)] for p in poses])
        index = lambda rows, name: [row["name"] for row in rows].index(name)
        self.pose, self.target = (np.array([index(rows, row[key]) for row in distances + positions]) for rows, key in ((poses, "pose"), (targets, "target")))
        self.what = np.array([d["what"] for d in distances], str)
        self.to = np.array([index(poses if d["what"] == "pose" else places, d["to"]) for d in distances], int)
        self.zero = np.array([zeros.index(d["zero"]) if d["zero"] else len(zeros) for d in distances], int)
        self.value = MM * np.array([d["value"] for d in distances] + [p[c] for p in positions for c in "xyz"])
        self.shared = setup["u_scale"]["value"] * 1e-6 * np.where(np.arange(len(self.value)) < len(distances), self.value, 0)
        self.weight = 1 / (MM * np.array([d["u"] for d in distances] + 3 * len(positions) * [setup["u_point"]["value"]]))
        self.rounded = 1 + CHANGE * np.array([[draw.choice((-1, 1)) if draw else 0 for _ in self.numbers] for _ in self.value])

    def calculated(self, x):
        base, zeros = x[self.at["base"]], np.append(x[self.at["zeros"]], 0)
        places, targets, joints = (x[self.at[part]].reshape(-1, n) for part, n in (("places", 3), ("targets", 3), ("joints", 5)))
        R, t = np.tile(np.eye(3, dtype=x.dtype), (len(self.turns), 1, 1)), np.zeros((len(self.turns), 3), x.dtype)
        for (theta, d, a, alpha, beta), q in zip(joints, self.turns.T):
            c, s, o = np.cos(theta + q), np.sin(theta + q), 0 * q
            t = t + np.einsum("kij,jk->ki", R, np.array([a * c, a * s, d + o]))
            R = np.einsum("kij,jlk->kil", R, np.array([[c, -s, o], [s, c, o], [o, o, o + 1]])) @ rotation(alpha, 0, 0) @ rotation(0, beta, 0)
        ball = lambda pose, target: (t[pose] + np.einsum("kij,kj->ki", R[pose], targets[target])) @ rotation(*base[3:]).T + base[:3]
        measured, n = ball(self.pose, self.target), len(self.what)
        place = np.append(places, np.ones((1, 3)), axis=0)[np.where(self.what == "pose", 0, self.to)]
        other = np.where((self.what == "pose")[:, None], ball(np.where(self.what == "pose", self.to, 0), self.target[:n]), place)
        away, (h, azimuth, elevation) = np.sqrt(((measured[:n] - other) ** 2).sum(axis=1)), place.T  # of complex numbers: no conjugate
        normal = np.array([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)])
        return np.concatenate([np.where(self.what == "plane", (measured[:n] * normal.T).sum(axis=1) - h, away) + zeros[self.zero], measured[n:].ravel()])

    def slopes(self, x, unknowns):
        """Of readings over their u, scaled to columns of length one; and these lengths."""
        A = self.rounded[:, unknowns] * np.stack([self.weight * self.calculated(x + 1j * H * step).imag / H for step in np.eye(len(x))[unknowns]], axis=1)
        return A / np.linalg.norm(A, axis=0).clip(1e-300), np.linalg.norm(A, axis=0)

    def solve(self, start):
        """(Symbol, group, unit) of all that is told, estimates, u, correlation; Gauss-Newton, the arm from as designed."""
        x = np.append(start, self.nominal[len(start):])
        found = np.array([i for i, number in enumerate(self.numbers) if number[4]])
        found = found[self.slopes(x, found)[1] > 1e-6 * self.slopes(x, found)[1].max()]
        rests = abs(np.diag(np.linalg.qr(self.slopes(x, found)[0])[1]))  # of a column beyond what those before it explain
        told = found[rests > 1e-3]
        assert rests[rests <= 1e-3].max() < 100 * CHANGE
        for _ in range(10):
            A, scale = self.slopes(x, told)
            Q, R = np.linalg.qr(A)
            gain, residuals = np.linalg.solve(R, Q.T) / scale[:, None], self.weight * (self.value - self.calculated(x).real)
            moved = gain @ residuals
            x[told] += moved
        assert (abs(moved) < 1e-8 * np.linalg.norm(gain, axis=1)).all() and 0.4 < residuals @ residuals / (len(residuals) - len(told)) < 1.6
        part, named = self.weight * self.shared, [n for n, i in enumerate(told) if self.numbers[i][0]]
        covariance = (gain @ gain.T + np.outer(gain @ part, gain @ part))[np.ix_(named, named)]
        u = np.sqrt(np.diag(covariance))
        return [self.numbers[told[n]][:3] for n in named], x[told[named]], u, covariance / np.outer(u, u)


def type_readings(setup, joints, draw, true):
    """Of an arm that is not as designed, its surroundings where `true` says (mm, degrees). In poses that touch planes joints 2 and 3 turn until they do."""
    model = Readings(setup, joints)
    x, noise = model.nominal.copy(), np.array([draw.gauss(0, 1) for _ in model.value]) / model.weight
    for part, values in true.items():
        x[model.at[part]] = model.size[model.at[part]] * values
    start, touches = x[:model.at["joints"].start].copy(), int((model.what == "plane").sum())
    x[len(start):] += [draw.gauss(0, 0.3 if number[2] == "mm" else 0.06) * size * number[4] for number, size in zip(model.numbers[len(start):], model.size[len(start):])]
    for step in range(80 if touches else 0):
        model.turns = model.turns.real + 1j * H * np.eye(6)[1 + step % 2]
        away = (model.calculated(x + 0j) - noise)[:touches]
        model.turns[:touches, 1 + step % 2] -= np.clip(away.real * H / away.imag, -0.1, 0.1)
    for row, turns in zip(setup["poses"]["rows"][:touches], model.turns.real / DEG):
        row[2:4] = round(turns[1] - 90, 4), round(turns[2], 4)
    values = iter([round(v, 4) for v in ((Readings(setup, joints).calculated(x) + noise) / MM).tolist()])
    for row, value in zip(setup["distances"]["rows"], values):
        row[4] = 0 if row[2] == "plane" else value
    for row in setup["positions"]["rows"]:
        row[2:] = [next(values) for _ in "xyz"]
    return start


def case(book, title, setup, true, pairs):
    joints, key = book.project["assets"][0]["setup"]["joints"], f"readings-{len(book.cases) + 1}"
    start = type_readings(setup, joints, draw := random.Random(key), true)
    entry = book.analysis(key, "robot-from-readings", title, {"nominal": "arm"} | {name: typed for name, typed in setup.items() if isinstance(typed, str) or typed.get("rows") or typed.get("value")})
    keys, y, u, r = Readings(setup, joints).solve(start)
    condition = [np.ones_like(y), np.ones_like(u), np.ones_like(r)]
    for _ in range(8):
        _, y_2, u_2, r_2 = Readings(changed(setup, draw), changed(joints, draw), draw).solve(start)
        condition = [np.maximum(old, abs(moved) / CHANGE) for old, moved in zip(condition, ((y_2 - y) / np.maximum(abs(y), 1), u_2 / u - 1, r_2 - r))]
    checks = [book.line(entry, *names, *map(mp.mpf, (y[i], u[i], mp.inf)), [mp.mpf(condition[0][i]), mp.mpf(condition[1][i]), mp.mpf(1)], least=1) for i, names in enumerate(keys)]
    for a, b in pairs:
        at = tuple([names[0] for names in keys].index(symbol) for symbol in (a, b))
        checks.append({"what": f"correlation of {a} and {b}", "analysis": key, "output": a, "with": b, "figure": "correlation", "reference": r[at], "condition": float(f"{condition[2][at]:.3g}"), "scale": 1.0})
    book.cases.append({"project": "resources/verification/arm-readings.covaria", "title": title, "source": "least squares in numpy, double precision; tests/reference/cases/arm_readings.py",
                       "clauses": ["JCGM 102:2011, 6.3"], "checks": checks})


def main():
    book = Book("arm-readings", "An arm identified without poses", "Simulated readings of an arm of six joints that is not as designed, invented figures. Reference values of least squares in numpy: see covaria verify.")
    book.asset({"id": "arm", "kind": "serial-robot", "name": "Arm", "setup": tables(joints=ARM)})

    def setup(n, distances=(), places=(), positions=(), targets=(("T1", 80, 60, 40),), base="known", u_scale=0):
        draw = random.Random(f"{n} poses {len(book.cases)}")
        poses = [[f"P{k}", *(draw.randint(*turns) for turns in RANGES)] for k in range(n)]
        return {"data": "measured", "base_place": base, "point_uncertainty": "typed", "u_point": {"value": 0.015 * bool(positions), "unit": "mm"}, "u_scale": {"value": u_scale, "unit": "ppm"}} | tables(
            targets=[[*t, "found"] for t in targets], places=list(places), poses=poses, distances=[[f"P{k}", "T1", what, to, 0, 0.005 if what == "plane" else 0.01, zero] for k, what, to, zero in distances],
            positions=[[f"P{k}", f"T{i}", 0, 0, 0] for k, i in positions])
    corners, ball = {"A": (1500, 800, 300), "B": (-400, 1600, 900), "C": (300, -1700, 150), "D": (1200, -600, 1900)}, [80.7, 59.2, 41.1]
    case(book, "Distances of an arm from four known points, which share a scale", setup(16, [(k, "point", c, None) for k in range(16) for c in corners], [[c, "point", *p, None, None, None, "known"] for c, p in corners.items()],
         u_scale=5), {"targets": ball}, [("a_2", "d_4"), ("theta_2", "theta_3"), ("a_1", "alpha_1")])
    case(book, "Distances of an arm from a point that is found, with a zero", setup(60, [(k, "point", "A", "wire") for k in range(60)], [["A", "point", *[None] * 6, "found"]]),
         {"places": [1503.1, 796.6, 302], "zeros": [1.7], "targets": ball}, [("a_2", "d_4"), ("d_3", "alpha_3")])
    touches = setup(51, [(k, "plane", "EFG"[k % 3], None) for k in range(45)] + [(45 + k, "pose", f"P{45 + (k + 1) % 6}", None) for k in range(6)],
                    [["E", "plane", 900, 90, 45, 1, 0.1, 0.05, "found"], ["F", "plane", -120, 800, 160, -0.15, 1, 0.2, "found"], ["G", "plane", 35, -70, 350, 0.1, -0.2, 1, "found"]])
    for k, row in enumerate(touches["poses"]["rows"][:45]):
        row[1] = (row[1] // 5, 90 + row[1] // 5, row[1])[k % 3]  # towards the plane
    case(book, "Touches of three planes that are found, and six distances between poses", touches, {"places": [907.2, 6.1, 2.6, 822.3, 98.1, 11.2, 360.9, -62, 77.6], "targets": ball}, [("a_2", "d_4"), ("theta_2", "theta_3")])
    case(book, "Positions of three reflectors on an arm whose base is far away", setup(15, positions=[(k, i) for k in range(15) for i in (1, 2, 3)], targets=[("T1", 80, 60, 40), ("T2", -70, 50, 30), ("T3", 10, -90, 60)], base="found"),
         {"base": [2600, -1500, -900, -0.8, 1.5, 150], "targets": [*ball, -69.4, 50.9, 29.3, 9.2, -90.7, 60.8]}, [("a_2", "d_4"), ("alpha_2", "alpha_3")])
    case(book, "Distances of a ball on an arm between poses", setup(30, [(k, "pose", f"P{(k + step) % 30}", None) for k in range(30) for step in (1, 7)]), {"targets": ball}, [("a_2", "d_4"), ("a_1", "a_3")])
    book.write("An arm identified without poses: least squares in numpy, made by tests/reference/cases/arm_readings.py")


if __name__ == "__main__":
    main()
