"""Arms identified from measured positions of a ball: figures of the second evaluator."""
import math
import random

from book import Book

ARMS = {"planar": [(300, 0, 0), (250, 0, 0)], "elbow": [(25, 90, 400), (455, 10, 0), (420, -80, 30)], "wrist": [(25, 90, 400), (455, -8, 12), (35, 90, 20), (20, -85, 420)]}


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def link(theta, d, a, alpha):
    ct, st, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return [[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [0, sa, ca, d], [0, 0, 0, 1]]


def main():
    book = Book("identified", "Arms identified from measured positions", "Simulated positions of a ball on arms of two, three and four joints: base, ball and the parameters that the positions tell. Reference values of a second evaluator: see covaria verify.")
    units = {**dict.fromkeys("xyz", "mm"), **dict.fromkeys(("alpha", "beta", "gamma"), "deg")}
    for name, joints in ARMS.items():
        book.asset({"id": name, "kind": "serial-robot", "name": name, "setup": {"joints": {"columns": ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]"], "rows": [[0, d, a, alpha] for a, alpha, d in joints]}}})
        for i in range(1, len(joints) + 1):
            units |= {f"theta_{i}": "deg", f"alpha_{i}": "deg", f"d_{i}": "mm", f"a_{i}": "mm"}
        for number in range(3):
            draw, rows = random.Random(f"{name} {number}"), []
            true = [(math.radians(draw.gauss(0, 0.02)), d + draw.gauss(0, 0.1), a + draw.gauss(0, 0.1), math.radians(alpha + draw.gauss(0, 0.02))) for a, alpha, d in joints]
            for k in range(14 + 3 * number):
                q, pose = [draw.randrange(-80, 81) for _ in joints], [[float(i == j) for j in range(4)] for i in range(4)]
                for reading, (theta, d, a, alpha) in zip(q, true):
                    pose = product(pose, link(theta + math.radians(reading), d, a, alpha))
                ball = [sum(x * y for x, y in zip(row, (80, 60, 40, 1))) for row in pose[:3]]
                rows.append([f"p{k + 1}", *q, *(round(v + draw.gauss(0, 0.01), 4) for v in ball)])
            setup = {"nominal": name, "data": "measured", "poses": {"columns": ["name"] + [f"q_{i + 1} [deg]" for i in range(len(joints))] + ["x [mm]", "y [mm]", "z [mm]"], "rows": rows},
                     "u_point": {"value": (0.01, 0.02, 0.05)[number], "unit": "mm"}, "ball": {"position": [80, 60, 40], "lengthUnit": "mm", "angles": [0, 0, 0], "angleUnit": "deg"}}
            entry = book.analysis(f"{name}-{number + 1}", "robot-calibration", f"Arm {name}, {len(rows)} positions", setup)
            book.case(f"Identification of arm {name} from {len(rows)} positions", "second evaluator (tests/reference/identification.py), 50 digits", entry, units, None, None, ["JCGM 102:2011, 6.3"], draws=3, size=1)
    book.write("Identification: a second evaluator at 50 digits, made by tests/reference/cases/identified.py")


if __name__ == "__main__":
    main()
