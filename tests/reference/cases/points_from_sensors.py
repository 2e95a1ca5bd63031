"""Points from trackers, total stations, cameras and distance meters: designs and given readings, all estimators and weights."""
import random

import mpmath as mp

from book import EVALUATORS, Book

import sensors
from dual import Dual
from vectors import inside, values

EVALUATORS["points-from-sensors"] = sensors.evaluate
MM, ARCSEC = "mm", "arcsec"
COMMON = {"u_scale": (0.4, "ppm"), "u_zero": (0.008, MM), "u_index": (1.2, ARCSEC), "u_collimation": (0.9, ARCSEC), "u_axis_tilt": (1.1, ARCSEC), "u_beam_offset": (0.004, MM),
          "u_refraction": (0.3, "1")}
STATION = {**{f"u_station_{axis}": (u, MM) for axis, u in zip("xyz", (0.03, 0.04, 0.05))}, **{f"u_station_{axis}": (u, ARCSEC) for axis, u in zip(("omega", "phi", "kappa"), (2, 3, 4))}}
CAMERA = {**{f"u_station_{axis}": (0.1, MM) for axis in "xyz"}, **{f"u_station_{axis}": (20, ARCSEC) for axis in ("omega", "phi", "kappa")}}
# name: kind, position in mm, angles in degrees or, photogrammetric, rad; figures
INSTRUMENTS = {
    "tracker": ("tracker", [-3000, -2600, 900], [0.4, -0.3, 30], {"distance_constant": (0.01, MM), "distance_scale": (1.5, "ppm"), "angle_azimuth": (2, ARCSEC),
                "angle_elevation": (2.4, ARCSEC), "across_constant": (0.015, MM), **COMMON, **STATION}, {"meaning": "limit-rectangular"}),
    "exact": ("tracker", [2900, -2700, 1100], [0, 0, 135], {"distance_constant": (0.02, MM), "angle_azimuth": (3, ARCSEC), "angle_elevation": (3.5, ARCSEC)}, {"meaning": "expanded-k2"}),
    "station": ("total-station", [2600, 3100, 700], [0.3, 0.5, -140], {"distance_constant": (0.3, MM), "distance_scale": (2, "ppm"), "angle_azimuth": (1.5, ARCSEC), "angle_elevation": (1.8, ARCSEC),
                "u_scale": (1.1, "ppm"), **STATION}, {"station_correlation": {"columns": ["first", "second", "r"], "rows": [["x_0", "y_0", 0.4], ["y_0", "kappa", -0.6], ["omega", "phi", 0.3]]}}),
    "camera-1": ("camera", [-3500, 300, 200], [0.02, -0.01, 0.05], {"angle_azimuth": (35, "urad"), "angle_elevation": (45, "urad"), **CAMERA}, {}),
    "camera-2": ("camera", [-3300, 1900, 0], [-0.03, 0.02, -0.35], {"angle_azimuth": (30, "urad"), "angle_elevation": (40, "urad"), **CAMERA}, {}),
    "meter-1": ("distance-meter", [-2800, 2400, 1500], [0, 0, 0], {"distance_constant": (0.05, MM), "u_zero": (0.02, MM), **STATION}, {}),
    "meter-2": ("generic", [300, -3300, -400], [0, 0, 0], {"distance_constant": (0.03, MM), "distance_scale": (4, "ppm"), "u_scale": (2, "ppm")}, {"reads_azimuth": False, "reads_elevation": False}),
    "theodolite": ("generic", [100, -4000, 500], [0.1, 0.2, 80], {"angle_azimuth": (1, ARCSEC), "angle_elevation": (1.3, ARCSEC), "across_constant": (0.02, MM), "u_index": (1, ARCSEC)}, {"reads_distance": False}),
    "azimuths": ("generic", [2000, -3000, 300], [0, 0, 110], {"angle_azimuth": (1.4, ARCSEC), "u_collimation": (2, ARCSEC)}, {"reads_distance": False, "reads_elevation": False})}
TARGETS = {"A": (-400, 250, 310), "B": (650, 420, -120), "C": (120, -730, 560), "D": (-210, -380, 905)}
DESIGN, GIVEN = "design", "given readings"
LEAST, PAPER, ORDINARY = {}, {"estimator": "linear", "weights": "observations"}, {"estimator": "linear-start", "weights": "observations"}
OWN = {"weights": "observations"}
CASES = [  # instruments, targets, evaluation, method, further tables
    (["tracker"], "ABC", DESIGN, LEAST, {"frames", "angles"}), (["tracker", "exact"], "ABC", DESIGN, LEAST, {"distances", "check"}), (["tracker", "station"], "ABC", DESIGN, LEAST, {"constraint"}),
    (["camera-1", "camera-2", "tracker"], "AB", DESIGN, PAPER, {"distances"}), (["camera-1", "camera-2", "theodolite"], "AB", DESIGN, LEAST, {"distances"}),
    (["meter-1", "meter-2", "azimuths", "theodolite"], "ABC", DESIGN, LEAST, {"angles"}), (["tracker", "meter-1", "meter-2"], "AB", DESIGN, OWN, set()),
    (["station", "exact"], "ABCD", DESIGN, LEAST, {"new", "distances"}), (["tracker", "exact"], "Z", DESIGN, LEAST, set()), (["tracker", "exact"], "Z", DESIGN, OWN, set()),
    (["camera-1", "tracker"], "AB", DESIGN, ORDINARY, set()),
    (["exact", "theodolite"], "AB", GIVEN, LEAST, {"distances"}), (["tracker", "exact"], "ABC", GIVEN, LEAST, {"constraint"}), (["tracker", "station", "meter-1"], "ABCD", GIVEN, LEAST, {"new", "check", "frames"}),
    (["tracker", "theodolite", "meter-2"], "AB", GIVEN, OWN, set()), (["camera-1", "camera-2", "tracker"], "AB", GIVEN, PAPER, {"distances"}), (["tracker", "theodolite", "azimuths"], "A", GIVEN, ORDINARY, set())]


def quantities(figures):
    return {key: {"value": value, "unit": unit} for key, (value, unit) in figures.items()}


def readings(names, used, draw):
    """Of targets near their nominal places, rounded as they are typed."""
    rows = []
    for target in names:
        p = [Dual(mp.mpf(c + draw.uniform(-0.5, 0.5)) / 1000) for c in TARGETS[target]]
        for name in used:
            kind, position, angles, figures, further = INSTRUMENTS[name]
            setup = {"kind": kind, **further, **station_of(name)}
            x, y, z = values(inside(sensors.pose(setup, [Dual(c) / 1000 for c in position] + [Dual(a) * (1 if kind == "camera" else mp.pi / 180) for a in angles]), p))
            read = {"d": mp.norm([x, y, z]) * 1000, "a": mp.atan2(y, x), "e": mp.atan2(z, mp.hypot(x, y))}
            noise = {"d": 0.01, "a": 8e-6, "e": 8e-6}
            rows.append([target, name] + [round(float(read[o]) + draw.gauss(0, noise[o]), 3 if o == "d" else 8) if o in sensors.reads(setup) else None for o in "dae"])
    return rows


def station_of(name):
    return {"station_angles": "xyz"} if INSTRUMENTS[name][0] == "camera" else {}


def main():
    book = Book("points-from-sensors", "Points from sensors",
                "Targets measured by trackers, a total station, cameras, theodolites and distance meters. Invented figures and simulated readings; the reference values are of a second evaluator: see covaria verify.")
    units = {**dict.fromkeys(("alpha", "beta", "gamma", "BAC"), "deg"), None: MM}
    for name, (kind, position, angles, figures, further) in INSTRUMENTS.items():
        book.asset({"id": name, "kind": "spherical-instrument", "name": name, "setup": {
            "kind": kind, "station": {"position": position, "lengthUnit": MM, "angles": angles, "angleUnit": "rad" if kind == "camera" else "deg"}, **station_of(name), **quantities(figures), **further}})
    for number, (used, names, evaluation, method, further) in enumerate(CASES, 1):
        draw = random.Random(f"sensors {number}")
        places = TARGETS | {"Z": (-3000, -2599, 2900)}
        setup = {"sensors": {"columns": ["sensor"], "rows": [[name] for name in used]},
                 "targets": {"columns": ["name", "x [mm]", "y [mm]", "z [mm]", "new_set_up"], "rows": [[name, *places[name], "new" in further and name == "C"] for name in names]}} | method
        if evaluation == GIVEN:
            setup |= {"evaluation": "a-posteriori", "readings": {"columns": ["target", "sensor", "distance [mm]", "azimuth [rad]", "elevation [rad]"], "rows": readings(names, used, draw)}}
        if "distances" in further:
            setup["distances"] = {"columns": ["from", "to"], "rows": [["A", "B"]] + [["B", "C"]] * ("C" in names)}
        if "angles" in further:
            setup["angles"] = {"columns": ["from", "at", "to"], "rows": [["B", "A", "C"]]}
        if "frames" in further:
            setup["frames"] = {"columns": ["name", "origin", "on_x", "in_xy"], "rows": [["plate", "A", "B", "C"]]}
        if further & {"check", "constraint"}:
            length = mp.norm([a - b for a, b in zip(TARGETS["A"], TARGETS["B"])])
            setup["scale_bars"] = {"columns": ["from", "to", "length [mm]", "u [mm]", "role"], "rows": [["A", "B", round(float(length), 2), 0.012, "constraint" if "constraint" in further else "check"]]}
        how = {"linear": "Eqs 1 to 4", "linear-start": "Eq 3"}.get(method.get("estimator"), "least squares, weights of the readings alone" if method else "least squares, all targets together")
        title = f"{' '.join(names)} by {', '.join(used)}: {how}, {evaluation}"
        entry = book.analysis(f"sensors-{number}", "points-from-sensors", title, setup)
        book.case(title, "second evaluator (tests/reference/sensors.py), 50 digits", entry, units, None, None, ["JCGM 102:2011, 6.2" if evaluation == DESIGN else "JCGM 102:2011, 6.3"], draws=4, size=5)
    book.write("Points from sensors: a second evaluator at 50 digits, made by tests/reference/cases/points_from_sensors.py")


if __name__ == "__main__":
    main()
