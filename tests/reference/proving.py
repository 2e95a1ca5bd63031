"""The model "force-proving instrument" (ISO 376, EURAMET cg-4): deflections with their parts, and the coefficients of the interpolation."""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from linear import fitted
from tables import table
from units import exact, quantity


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    rows = sorted(table(setup["steps"], project.folder), key=lambda row: row["force"])
    zero = {row["series"]: row for row in table(setup.get("unloaded"), project.folder)}
    of = {"X1": "X1", "X2": "X2", "X3": "X3", "X4": "X3", "X5": "X5", "X6": "X5"}
    for row in rows:
        for key in of:
            if key in row and zero:
                row[key] -= zero[of[key]]["before"]
    mean = [(row["X1"] + row["X3"] + row["X5"]) / 3 for row in rows]
    relative = common(setup, inputs, zero, mean[-1])
    x = [deflection(i, row, m, setup, project, inputs, relative) for i, (row, m) in enumerate(zip(rows, mean))]
    first, degree = int(not setup.get("constant", True)), int(setup.get("degree", 3))
    design = mp.matrix([[row["force"] ** k for k in range(first, degree + 1)] for row in rows])
    solution, gain, s, nu = fitted(design, mean)
    results = {}
    for i, (row, m) in enumerate(zip(rows, mean)):
        u = s if setup.get("interpolation", "largest") == "each" else s * abs(m / mean[-1])
        residual = inputs.deviation(("residual", i), u, nu, "interpolation")
        results["X_a", f"force {mp.nstr(row['force'] / 1000, 6).removesuffix('.0')} kN"] = x[i] + (design[i, :] * solution)[0] - m + residual
    for k in range(design.cols):
        results[f"A_{first + k}"] = sum((value * gain[k, i] for i, value in enumerate(x)), Dual(0))
    return results, inputs


def common(setup, inputs, zero, largest):
    """What acts at all forces alike, but for the machine."""
    f_0 = max((abs((row["after"] - row["before"]) / largest) for row in zero.values()), default=mp.mpf(0))
    c = abs((quantity(setup, "creep_300") - quantity(setup, "creep_30")) / largest)
    t = quantity(setup, "temperature_coefficient") * quantity(setup, "temperature_half_width")
    return inputs.deviation("creep", c / mp.sqrt(3)) + inputs.deviation("zero", f_0) + inputs.deviation("temperature", t / mp.sqrt(3))


def deflection(i, row, mean, setup, project, inputs, relative):
    u = row["U_force"] / 2 if "U_force" in row else of_machine(setup, project)
    value = relative + inputs.deviation("machine", mp.mpf(1)) * u
    value += inputs.deviation(("repeatability", i), abs(row["X2"] - row["X1"]) / (row["X1"] + row["X2"]) * 2 / mp.sqrt(3))
    value += inputs.deviation(("resolution", i), quantity(setup, "resolution") / mean / mp.sqrt(6))
    if setup.get("used") == "both":
        v = [abs(row[back] / row[there] - 1) for back, there in (("X4", "X3"), ("X6", "X5")) if back in row]
        value += inputs.deviation(("reversibility", i), mp.fsum(v) / max(len(v), 1) / quantity(setup, "reversibility_divisor", 3))
    turned = [inputs.deviation(("rotation", k), mp.mpf(1), mp.mpf(2), "rotations") * ((row[k] - mean) / mp.sqrt(6)) for k in ("X1", "X3", "X5")]
    return Dual(mean) + value * mean + sum(turned, Dual(0))


def of_machine(setup, project):
    loads = table(project.assets[setup["machine"]]["setup"]["loads"], project.folder)
    load = next(load for load in loads if load["axis"] == setup.get("axis", "Fz"))
    return exact(load["U"]) / exact(load.get("k", 2))
