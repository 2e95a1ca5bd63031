"""The model "robot pose" (Wen et al., Eq 5): T_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i) Ry(beta_i), the tool at T_1 ... T_n X_tool."""
from dual import Dual
from first_order import Inputs
from tables import table
from units import exact
from vectors import IDENTITY, ZERO, angles_zyx, chained, placement, product, turn


class Arm:
    """theta and d, or beta where an axis is parallel to the next one, a and alpha of each joint, with the deviations that the asset states."""

    def __init__(self, asset, folder, inputs):
        setup, self.joints = asset["setup"], []
        if asset["kind"] != "serial-robot" or set(setup) - {"joints", "uncertainties", "tool"}:
            raise NotImplementedError(f"robot with {', '.join(sorted(set(setup) - {'joints', 'uncertainties', 'tool'}))}")
        self.tool, sources = placement(setup.get("tool")), table(setup.get("uncertainties"), folder)
        for number, row in enumerate(table(setup["joints"], folder), 1):
            joint = {key: Dual(row.get(key, 0)) for key in ("theta", "d", "a", "alpha", "beta", "q_zero")}
            for key in ("theta", "beta" if "beta" in row else "d", "a", "alpha"):
                for source in sources:
                    if int(source.get("joint", number)) == number and "u_" + key in source:
                        name = asset["id"], number, key, source.get("source")
                        joint[key] += inputs.deviation(name, source["u_" + key], exact(source.get("nu", "inf")))
            self.joints.append(joint)

    def at(self, readings):
        pose = IDENTITY, ZERO
        for joint, q in zip(self.joints, readings):
            pose = chained(pose, (turn(2, joint["theta"] + q - joint["q_zero"]), [Dual(0), Dual(0), joint["d"]]))
            pose = chained(pose, (product(turn(0, joint["alpha"]), turn(1, joint["beta"])), [joint["a"], Dual(0), Dual(0)]))
        return chained(pose, self.tool)


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    if setup["robot"] not in project.assets or setup.get("data", "readings") != "readings":
        raise NotImplementedError("a robot that an analysis identified, places by inverse kinematics")
    if setup.get("orientation", "zyx") not in ("none", "zyx"):
        raise NotImplementedError("other angles")
    arm = Arm(project.assets[setup["robot"]], project.folder, inputs)
    for row in table(setup["poses"], project.folder):
        r, o = arm.at([row[f"q_{i + 1}"] for i in range(len(arm.joints))])
        results |= {(symbol, row["name"]): value for symbol, value in (dict(zip("xyz", o)) | angles_zyx(r)).items()}
    return results, inputs
