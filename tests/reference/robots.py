"""The model "robot pose" (Wen et al., Eq 5): T_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i) Ry(beta_i), the tool at T_1 ... T_n X_tool."""
import mpmath as mp

from dual import Dual, cos, sin
from equations import Inputs
from networks import table
from poses import angles_zyx, plus, product, rotation_zyx, times
from units import factor

IDENTITY = [[Dual(int(i == j)) for j in range(3)] for i in range(3)]


def turn(axis, angle):
    c, s, i, j = cos(angle), sin(angle), (axis + 1) % 3, (axis + 2) % 3
    r = [list(row) for row in IDENTITY]
    r[i][i], r[j][j], r[i][j], r[j][i] = c, c, -s, s
    return r


def chained(first, second):
    return product(first[0], second[0]), plus(first[1], times(first[0], second[1]))


def along(axis, value):
    return IDENTITY, [Dual.of(value) if i == axis else Dual(0) for i in range(3)]


def placement(pose):
    """A pose of the project file: position, then alpha, beta, gamma."""
    if pose is None:
        return IDENTITY, [Dual(0)] * 3
    angles = [mp.mpf(repr(v)) * factor(pose["angleUnit"]) for v in pose["angles"]]
    return rotation_zyx(*angles), [Dual(mp.mpf(repr(v)) * factor(pose["lengthUnit"])) for v in pose["position"]]


class Arm:
    """theta and d, or beta where an axis is parallel to the next one, a and alpha of each joint, with the deviations that the asset states."""

    def __init__(self, asset, inputs):
        setup = asset["setup"]
        if asset["kind"] != "serial-robot" or set(setup) - {"joints", "uncertainties", "tool"}:
            raise NotImplementedError(f"robot with {', '.join(sorted(set(setup) - {'joints', 'uncertainties', 'tool'}))}")
        self.tool, self.joints = placement(setup.get("tool")), []
        for number, row in enumerate(table(setup["joints"], None)):
            joint = {}
            for key in ("theta", "d", "a", "alpha", "beta"):
                joint[key] = Dual(row.get(key, 0))
                if key == "beta" and "beta" not in row or key == "d" and "beta" in row:
                    continue
                for source in table(setup.get("uncertainties", {"columns": [], "rows": []}), None):
                    if int(source.get("joint", number + 1)) == number + 1 and "u_" + key in source:
                        joint[key] = joint[key] + inputs.deviation((asset["id"], number, key, source.get("source")), source["u_" + key],
                                                                   mp.mpf(source.get("nu", "inf")))
            joint["zero"] = row.get("q_zero", mp.mpf(0))
            self.joints.append(joint)

    def at(self, readings):
        pose = IDENTITY, [Dual(0)] * 3
        for joint, q in zip(self.joints, readings):
            for step in ((turn(2, joint["theta"] + (q - joint["zero"])), [Dual(0)] * 3), along(2, joint["d"]), along(0, joint["a"]),
                         (turn(0, joint["alpha"]), [Dual(0)] * 3), (turn(1, joint["beta"]), [Dual(0)] * 3)):
                pose = chained(pose, step)
        return chained(pose, self.tool)


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    if setup["robot"] not in project.assets or setup.get("data", "readings") != "readings":
        raise NotImplementedError("a robot that an analysis identified, places by inverse kinematics")
    if setup.get("orientation", "zyx") not in ("none", "zyx"):
        raise NotImplementedError("other angles")
    arm = Arm(project.assets[setup["robot"]], inputs)
    for row in table(setup["poses"], project.folder):
        r, o = arm.at([row[f"q_{i + 1}"] for i in range(len(arm.joints))])
        results |= {(axis, row["name"]): value for axis, value in zip("xyz", o)}
        results |= {(name, row["name"]): value for name, value in angles_zyx(r).items()}
    return results, inputs
