"""Poses by 3-2-1 and by least squares, and poses of robots with stated parameters."""
import random

import mpmath as mp

from book import Book

EVALUATED = "second evaluator (tests/reference/{}), 50 digits"


def moving(book):
    units = {**dict.fromkeys("xyz", "mm"), **dict.fromkeys(("alpha", "beta", "gamma"), "deg")}
    base = {"columns": ["name", "x [mm]", "y [mm]", "z [mm]"], "rows": [["b1", 0, 0, 0], ["b2", 600, 0, 0], ["b3", 0, -400, 0]]}
    for number in range(26):
        draw = random.Random(f"pose {number}")
        least = number % 2
        plate = [["p1", 0, 0, 0], ["p2", draw.choice((150, 220, 300)), 0, 0], ["p3", draw.choice((0, 40, 90)), draw.choice((130, 180, 260)), 0]]
        if least:
            plate += [[f"p{i}", draw.randrange(-90, 260), draw.randrange(-90, 260), draw.randrange(-60, 90)] for i in range(4, 4 + number % 5)]
        pose = ["pose", *(draw.randrange(-300, 300) for _ in range(3)), *(draw.randrange(-60, 61, 5) for _ in range(3))]
        if number < 4:
            pose = ["pose", 0, 0, (500, 1000)[number // 2], 0, 0, 0]
        value = lambda: {"value": draw.choice((0.01, 0.025, 0.04, 0.066, 0.11)), "unit": "mm"}
        setup = {"base_points": base, "base_third_point": "negative-y", "moving_points": {"columns": base["columns"], "rows": plate},
                 "poses": {"columns": ["name", "x [mm]", "y [mm]", "z [mm]", "alpha [deg]", "beta [deg]", "gamma [deg]"], "rows": [pose]},
                 "moving_fit": "least-squares" if least else "three-two-one", "base_fit": "three-two-one",
                 **{f"{frame}_u_{axis}": value() for frame in ("base", "moving") for axis in "xyz"}}
        how = f"least squares on {len(plate)} points" if least else "3-2-1"
        entry = book.analysis(f"pose-{number + 1}", "pose-from-points", f"Pose {number + 1} by {how}", setup)
        expected = {}
        if number in (0, 2):  # no turn: the origins differ, and the turns of the axes act by the lever z
            u = {key: mp.mpf(str(setup[key]["value"])) / 1000 for key in setup if "_u_" in key}
            gamma = mp.hypot(u["base_u_y"], u["base_u_y"]) / mp.mpf("0.6"), mp.sqrt(2) * u["moving_u_y"] / (mp.mpf(plate[1][1]) / 1000)
            expected = {("gamma", "pose"): (0, mp.hypot(*gamma))}
        book.case(f"Pose {number + 1} by {how}", EVALUATED.format("poses.py") + (", closed form of u(gamma)" if expected else ""), entry, units, None, expected,
                  ["JCGM 102:2011, 6.2"], size=1)


def arms(book):
    units = {**dict.fromkeys("xyz", "mm"), **dict.fromkeys(("alpha", "beta", "gamma"), "deg")}
    lengths = {"planar": [(300, 0, 0), (250, 0, 0)], "scara": [(400, 0, 200), (350, 180, 0), (0, 0, -150)],
               "elbow": [(25, 90, 400), (455, 0, 0), (35, 90, 0), (0, -90, 420), (0, 90, 0), (0, 0, 80)]}
    for name, joints in lengths.items():
        rows = [[0, d, a, alpha] for a, alpha, d in joints]
        robot = book.asset({"id": name, "kind": "serial-robot", "name": name, "setup": {
            "joints": {"columns": ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]"], "rows": rows},
            "uncertainties": {"columns": ["source", "u_theta [deg]", "u_d [mm]", "u_a [mm]", "u_alpha [deg]", "nu"],
                              "rows": [["machining", 0.004, 0.02, 0.015, 0.006, None], ["encoder", 0.002, None, None, None, 12 if name == "scara" else None]]},
            "tool": {"position": [12, -5, 90], "lengthUnit": "mm", "angles": [0, 0, 0], "angleUnit": "deg"}}})
        for number in range(5):
            draw = random.Random(f"{name} {number}")
            angles = [draw.randrange(-80, 81, 5) for _ in joints]
            if name == "planar" and number == 0:
                angles = [90, 0]
            if name == "scara":  # its hand points down, where alpha is next to 180 degrees
                angles[-1] = draw.randrange(-40, 41, 5)
            setup = {"robot": robot["id"], "poses": {"columns": ["name"] + [f"q_{i + 1} [deg]" for i in range(len(joints))], "rows": [["place", *angles]]}}
            entry = book.analysis(f"{name}-{number + 1}", "robot-pose", f"Arm {name}, place {number + 1}", setup)
            expected = {}
            if name == "planar":  # of a turn about the vertical, every deviation of an angle counts
                u = mp.sqrt(2 * (mp.mpf("0.004") ** 2 + mp.mpf("0.002") ** 2)) * mp.pi / 180
                expected = {("gamma", "place"): (None, u)}
            book.case(f"Arm {name}, place {number + 1}", EVALUATED.format("robots.py") + (", closed form of u(gamma)" if expected else ""), entry, units, None, expected, ["JCGM 102:2011, 6.2"], size=1)


def reversed_arms(book):
    """Joints that turn or slide against their readings, by both conventions, with readings and a tool that are uncertain, in the world."""
    units = {**dict.fromkeys("xyz", "mm"), **dict.fromkeys(("alpha", "beta", "gamma"), "deg")}
    columns = ["theta [deg]", "d [mm]", "a [mm]", "alpha [deg]", "q_zero [deg]", "s_zero [mm]", "direction", "type", "u_encoder [deg]", "u_repeatability [deg]", "u_s_encoder [mm]"]
    pose = lambda position, angles: {"position": position, "lengthUnit": "mm", "angles": angles, "angleUnit": "deg"}
    for convention in ("standard", "craig"):
        rows = [[10, 400, 25, 90, 5, None, "negative", "turning", 0.003, 0.002, None], [-30, 20, 455, 12, -10, None, "positive", "turning", None, 0.004, None],
                [5, 150, 35, -85, None, 40, "negative", "sliding", None, None, 0.03], [0, 420, 10, 70, None, None, "negative", "turning", 0.002, None, None]]
        book.asset({"id": "reversed-" + convention, "kind": "serial-robot", "name": "reversed, " + convention, "setup": {
            "convention": convention, "joints": {"columns": columns, "rows": rows}, "base": pose([120, -340, 75], [3, -8, 40]), "tool": pose([12, -5, 90], [20, -10, 35]),
            "u_tool_position": {"value": 0.02, "unit": "mm"}, "u_tool_angle": {"value": 0.005, "unit": "deg"},
            "uncertainties": {"columns": ["source", "joint", "u_theta [deg]", "u_d [mm]", "u_a [mm]", "u_alpha [deg]", "nu"],
                              "rows": [["certificate", None, 0.004, 0.02, 0.015, 0.006, 9], ["assembly", 2, 0.003, 0.05, None, None, None]]}}})
        for number, readings in enumerate([[25, -40, 95, 30], [-70, 15, -20, -60]], 1):
            setup = {"robot": "reversed-" + convention, "frame": ("base", "world")[number - 1],
                     "poses": {"columns": ["name", "q_1 [deg]", "q_2 [deg]", "s_3 [mm]", "q_4 [deg]"], "rows": [["place", *readings]]}}
            title = f"Arm with reversed joints, {convention} convention, place {number}"
            entry = book.analysis(f"reversed-{convention}-{number}", "robot-pose", title, setup)
            book.case(title, EVALUATED.format("robots.py"), entry, units, None, None, ["JCGM 102:2011, 6.2"], size=1)


def main():
    book = Book("poses-and-robots", "Poses from points, and poses of robots",
                "Frames by three points and by least squares, against a base of three points; arms of two, three and six joints with the uncertainty of their parameters. Invented figures; the reference values are of a second evaluator: see covaria verify.")
    moving(book)
    arms(book)
    reversed_arms(book)
    book.write("Poses: a second evaluator at 50 digits, made by tests/reference/cases/poses_and_robots.py")


if __name__ == "__main__":
    main()
