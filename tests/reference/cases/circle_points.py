"""Robots by joint trajectories: simulated circles, and measured ones with scatter."""
import math
import random

from book import EVALUATORS, Book

import circles

EVALUATORS["robot-circle-points"] = circles.evaluate
# theta, d, a, alpha, beta, direction: axes that are skew, parallel and opposite
ARMS = {"elbow": [(0, 400, 25, -90, None, "negative"), (-20, 0, 455, 0.2, 0.03, None), (5, 30, 35, 80, None, "negative"), (10, 420, 15, -70, None, None)],
        "scara": [(15, 0, 400, 0.1, -0.05, None), (-10, 0, 350, 179.9, 0.04, "negative"), (20, -150, 10, 75, None, None)]}


def main():
    book = Book("circle-points", "Robots by joint trajectories", "Points of a ball while one joint after the other turns, simulated and with scatter. Invented figures; the reference values are of a second evaluator: see covaria verify.")
    units = {"theta": "deg", "alpha": "deg", "beta": "deg", "d": "mm", "a": "mm", "R": "mm"}
    units = {f"{key}_{j}": unit for key, unit in units.items() for j in range(1, 5)}
    ball = {"position": [80, 60, 40], "lengthUnit": "mm", "angles": [0, 0, 0], "angleUnit": "deg"}
    for name, joints in ARMS.items():
        book.asset({"id": name, "kind": "serial-robot", "name": name, "setup": {"joints": {"columns": ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]", "beta [deg]", "direction"], "rows": [list(row) for row in joints]}}})
        draw, rows = random.Random(f"circles {name}"), []
        arm = circles.Arm(book.project["assets"][-1], None, circles.Inputs())
        for j, joint in enumerate(arm.joints, 1):
            for k in range(9):
                q = -50 + 12 * k
                p = circles.outside(arm.frames([math.radians(q) if i == j else 0 for i in range(1, len(joints) + 1)])[-1], [circles.Dual(c) / 1000 for c in ball["position"]])
                rows.append([j, q, *(round(float(c) * 1000 + draw.gauss(0, 0.01), 4) for c in circles.values(p))])
        measured = {"data": "measured", "points": {"columns": ["joint", "q [deg]", "x [mm]", "y [mm]", "z [mm]"], "rows": rows}, "u_point": {"value": 0.012, "unit": "mm"}}
        for how, setup in (("simulated", {"half_range": {"value": 50, "unit": "deg"}, "point_count": 7, "ball": ball}), ("measured", measured)):
            entry = book.analysis(f"{name}-{how}", "robot-circle-points", f"Arm {name} by circles, {how}", {"nominal": name} | setup)
            book.case(entry["name"], "second evaluator (tests/reference/circles.py), 50 digits", entry, units, None, None, ["JCGM 102:2011, 6.3"], draws=3, size=1)
    book.write("Joint trajectories: a second evaluator at 50 digits, made by tests/reference/cases/circle_points.py")


if __name__ == "__main__":
    main()
