"""A force/moment sensor of three axes by its readings, and Kim's of six by the figures printed: channels, and loads by the calibration matrix."""
import random

from book import EVALUATORS, Book

import forces

EVALUATORS |= {"force-moment-channels": forces.channels, "force-moment-loads": forces.loads}
RATED = {"Fx": (200, "N"), "Fz": (500, "N"), "My": (12, "N*m")}
SLOPES = {"Fx": (0.61, 0.012, -0.017), "Fz": (-0.008, 0.83, 0.011), "My": (0.021, -0.006, 0.72)}  # mV/V at rated loads
# Kim, Tables 1 to 3, in mV/V: rated output, zero error, u_A, hysteresis; the interference, with signs that are invented: the paper gives none
PRINTED = {"Fx": (0.52782, 0.00051, 0.00021, 0.00051), "Fy": (0.47948, 0.00078, 0.00018, 0.00046), "Fz": (0.4807, 0.00096, 0.00012, 0.00029), "Mx": (0.64724, 0.00102, 0.00031, 0.00089),
           "My": (0.65273, 0.00099, 0.00029, 0.00094), "Mz": (0.60874, 0.00121, 0.00024, 0.00078)}
INTERFERENCE = [["Fx", None, 0.0031, -0.00335, 0.00159, 0.00261, -0.00362], ["Fy", -0.00468, None, 0.00207, -0.00287, 0.00032, 0.00021], ["Fz", 0.00426, 0.00102, None, 0.00712, -0.001, 0.00263],
                ["Mx", 0.00516, -0.001, 0.00606, None, 0.00854, -0.00896], ["My", -0.01621, 0.00116, 0.00114, 0.00414, None, 0.00148], ["Mz", 0.00521, -0.00406, 0.00057, 0.00166, -0.00231, None]]


def readings():
    draw, rows = random.Random("force sensor"), []
    noise = lambda: draw.gauss(0, 0.0003)
    for i, (loaded, (rated, unit)) in enumerate(RATED.items()):
        for run in range(1, 4):
            zero = [draw.uniform(-0.02, 0.02) for _ in RATED]
            def read(part, loop):
                return [round(z + SLOPES[h][i] * (part + 0.002 * part * part) + loop * (h == loaded) + noise(), 5) for h, z in zip(RATED, zero)]
            rows.append([loaded, "calibration", run, "zero_before", 0, 0, unit, *read(0, 0)])
            rows += [[loaded, "calibration", run, "increasing", step, rated * step / 4, unit, *read(step / 4, 0)] for step in range(1, 5)]
            rows += [[loaded, "calibration", run, "decreasing", step, rated * step / 4, unit, *read(step / 4, 0.0012)] for step in range(3, 0, -1)]
            rows.append([loaded, "calibration", run, "zero_after", 0, 0, unit, *read(0, 0.0004)])
    return rows


def main():
    book = Book("force-sensors", "Force and moment sensors", "A sensor of three axes with simulated readings, and one of six axes by the printed figures of Kim. Reference values of a second evaluator: see covaria verify.")
    book.asset({"id": "machine", "kind": "force-calibrator", "name": "Machine", "setup": {"loads": {"columns": ["axis", "U", "k"], "rows": [
        ["Fx", 0.00086, 2], ["Fy", 0.00087, 2], ["Fz", 0.0004, 2.1], ["Mx", 0.00087, 2], ["My", 0.00086, None], ["Mz", 0.0017, 2]]}}})
    common = {"resolution": {"value": 1e-05, "unit": "mV/V"}, "calibrator": "machine"}
    channels = lambda axes: {"columns": ["axis", "rated_force [N]", "rated_moment [N*m]"], "rows": [[h, load if unit == "N" else None, load if unit != "N" else None] for h, (load, unit) in axes.items()]}
    book.asset({"id": "three", "kind": "force-sensor", "name": "Three axes", "setup": common | {"channels": channels(RATED), "data": "readings", "preloads": 0, "steps": 4, "readings": {
        "columns": ["loaded_axis", "series", "run", "phase", "step", "load", "load_unit"] + [f"{h} [mV/V]" for h in RATED], "rows": readings()}}})
    book.asset({"id": "six", "kind": "force-sensor", "name": "Six axes, printed", "setup": common | {
        "channels": channels({h: (100, "N") if h[0] == "F" else (1, "N*m") for h in PRINTED}), "data": "summary", "has_signs": True,
        "summary": {"columns": ["axis", "rated_output [mV/V]", "zero_error [mV/V]", "u_A [mV/V]", "hysteresis [mV/V]"], "rows": [[h, *figures] for h, figures in PRINTED.items()]},
        "interference": {"columns": ["axis"] + [f"{h} [mV/V]" for h in PRINTED], "rows": INTERFERENCE}}})
    mixed = {"given": "loads", "loads": {"columns": ["name", "Fx [N]", "Fz [N]", "My [N*m]"], "rows": [["mixed", 150, -320, 7]]}}
    read = {"given": "readings", "readings": {"columns": ["name", "Fx [mV/V]", "Fz [mV/V]", "My [mV/V]"], "rows": [["reading", 0.4127, -0.3391, 0.5208]]}}
    printed = {"given": "loads", "loads": {"columns": ["name"] + [f"{h} [{'N' if h[0] == 'F' else 'N*m'}]" for h in PRINTED], "rows": [["mixed", 50, -30, 80, 0.4, -0.6, 0.2]]}}
    for number, (sensor, model, setup) in enumerate([
            ("three", "channels", {}), ("three", "channels", {"other_loads": "largest", "repeatability": "pooled"}), ("six", "channels", {"other_loads": "none"}), ("three", "loads", mixed),
            ("three", "loads", mixed | {"matrix": "quadratic", "repeatability": "pooled"}), ("three", "loads", read | {"matrix": "quadratic", "hysteresis": "full"}), ("six", "loads", printed)], 1):
        title = f"{model.capitalize()} of the sensor of {sensor} axes: " + (", ".join(value if isinstance(value, str) else "a row" for key, value in setup.items() if key not in ("loads", "readings")) or "all others loaded")
        entry = book.analysis(f"force-{number}", "force-moment-" + model, title, {"sensor": sensor} | setup)
        units = {**dict.fromkeys((f"M_{axis}{end}" for axis in "xyz" for end in ("", ",0")), "N*m"), "V": "mV/V", "r": "%", None: "N"}
        book.case(title, "second evaluator (tests/reference/forces.py), 50 digits" + ("; Kim, Tables 1 to 3" if sensor == "six" else ""), entry, units, None, None, ["JCGM 100:2008, 5.1.2"], draws=6)
    book.write("Force sensors: a second evaluator at 50 digits, made by tests/reference/cases/force_sensors.py")


if __name__ == "__main__":
    main()
