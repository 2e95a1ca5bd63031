"""The model "robot from measured poses" with typed u and positions: weighted least squares of base, ball and the parameters of the joints.

Each unknown whose column of the Jacobian is a combination of those before it (base, ball, joint by joint) stays nominal.
"""
import mpmath as mp

from dual import Dual
from first_order import Inputs
from robots import Arm
from tables import table
from units import quantity
from vectors import chained, outside, placement, rotation_zyx, values

PARAMETERS = ("theta", "d", "a", "alpha", "beta")


def unknowns_of(arm, joints):
    names = [(axis, "base") for axis in ("x", "y", "z", "alpha", "beta", "gamma")] + [(axis, "tool") for axis in "xyz"]
    for number, row in enumerate(joints, 1):
        names += [(f"{key}_{number}", f"joint {number}") for key in PARAMETERS if key in ("theta", "a", "alpha") or (key == "beta") == ("beta" in row)]
    return names


def computed(arm, at, row):
    """Where the ball is, of unknowns `at`."""
    place = rotation_zyx(*(at[angle, "base"] for angle in ("alpha", "beta", "gamma"))), [at[axis, "base"] for axis in "xyz"]
    for number, joint in enumerate(arm.joints, 1):
        for key in PARAMETERS:
            joint[key] = at.get((f"{key}_{number}", f"joint {number}"), joint[key])
    arm.tool = placement(None)
    return outside(chained(place, arm.at([row.get(f"q_{i + 1}", joint["q_zero"]) for i, joint in enumerate(arm.joints)])), [at[axis, "tool"] for axis in "xyz"])


def jacobian(arm, names, at, rows, typed):
    seeded = {name: Dual(at[name], {name: mp.mpf(1)} if name in names else {}) for name in typed}
    points = [coordinate for row in rows for coordinate in computed(arm, seeded, row)]
    return points, mp.matrix([[p.g.get(name, mp.mpf(0)) for name in names] for p in points])


def told(names, columns):
    """Names whose columns are no combination of those before (Gram and Schmidt, twice)."""
    basis, kept = [], []
    for name, column in zip(names, columns):
        rest = column.copy()
        for _ in range(2):
            for b in basis:
                rest -= b * mp.fdot(b, rest)
        if mp.norm(rest) > mp.mpf(10) ** -12 * mp.norm(column):
            basis.append(rest / mp.norm(rest))
            kept.append(name)
    return kept


def evaluate(entry, project):
    setup, inputs = entry["setup"], Inputs()
    if setup.get("data") != "measured" or setup.get("quantity", "positions") != "positions" or setup.get("point_uncertainty", "typed") != "typed" or \
            setup.get("uncertainties", "stated") != "stated" or any(setup.get(key) for key in ("held", "tool_place", "base_place")):
        raise NotImplementedError("simulated or whole poses, an instrument, uncertainties as seen, held parameters")
    asset = project.assets[setup["nominal"]]
    if set(asset["setup"]) - {"joints"}:
        raise NotImplementedError("a robot with uncertain readings")
    arm, joints, rows = Arm(asset, project.folder, inputs), table(asset["setup"]["joints"], project.folder), table(setup["poses"], project.folder)
    if any(row.get("use", "fit") != "fit" for row in rows):
        raise NotImplementedError("poses that are held back")
    names = unknowns_of(arm, joints)
    ball = values(placement(setup.get("ball"))[1])
    at = {name: mp.mpf(0) for name in names} | {(axis, "tool"): v for axis, v in zip("xyz", ball)}
    at |= {(f"{key}_{n}", f"joint {n}"): joint[key].v for n, joint in enumerate(arm.joints, 1) for key in PARAMETERS if (f"{key}_{n}", f"joint {n}") in at}
    measured = mp.matrix([row[axis] for row in rows for axis in "xyz"])
    _, slopes = jacobian(arm, names, at, rows, names)
    found = told(names, [slopes[:, i] for i in range(len(names))])
    for _ in range(7):
        points, slopes = jacobian(arm, found, at, rows, names)
        gain = (slopes.T * slopes) ** -1 * slopes.T
        step = gain * (measured - mp.matrix(values(points)))
        for name, change in zip(found, step):
            at[name] += change
    u = quantity(setup, "u_point", "15e-6")
    deviations = [inputs.deviation(i, u) for i in range(len(measured))]
    return {name: Dual(at[name], {i: gain[k, i] for i in range(len(deviations))}) for k, name in enumerate(found)}, inputs
