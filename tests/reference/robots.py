"""The model "robot pose" (Wen et al., Eq 5): T_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i) Ry(beta_i), the tool at T_1 ... T_n X_tool. Craig's convention has
Rx(alpha_i) Tx(a_i) Rz(theta_i) Tz(d_i); a reading adds to theta, or to d of a joint that slides, with its direction."""
from dual import Dual
from first_order import Inputs
from tables import table
from units import exact, quantity
from vectors import IDENTITY, ZERO, angles_zyx, chained, placement, product, rotation_zyx, turn


class Arm:
    """theta and d, or beta where an axis is parallel to the next one, a and alpha of each joint, with the deviations that the asset states."""

    def __init__(self, asset, folder, inputs):
        setup, self.joints, self.inputs, self.id = asset["setup"], [], inputs, asset["id"]
        known = {"joints", "uncertainties", "tool", "base", "convention", "u_tool_position", "u_tool_angle"}
        if asset["kind"] != "serial-robot" or set(setup) - known:
            raise NotImplementedError(f"robot with {', '.join(sorted(set(setup) - known))}")
        sources, self.craig, self.base = table(setup.get("uncertainties"), folder), setup.get("convention") == "craig", placement(setup.get("base"))
        moved = [inputs.deviation((self.id, "tool", i), quantity(setup, "u_tool_" + ("position" if i < 3 else "angle"))) for i in range(6)]
        self.tool = chained(placement(setup.get("tool")), (rotation_zyx(*moved[3:]), moved[:3]))
        for number, row in enumerate(table(setup["joints"], folder), 1):
            letter = "s" if row.get("type") == "sliding" else "q"
            joint = {key: Dual(row.get(key, 0)) for key in ("theta", "d", "a", "alpha", "beta")} | {
                "letter": letter, "q_zero": Dual(row.get(letter + "_zero", 0)), "sign": -1 if row.get("direction") == "negative" else 1,
                "u": [row.get(("u_s_" if letter == "s" else "u_") + source, exact(0)) for source in ("encoder", "repeatability")]}
            for key in ("theta", "beta" if "beta" in row else "d", "a", "alpha"):
                for source in sources:
                    if int(source.get("joint", number)) == number and "u_" + key in source:
                        name = asset["id"], number, key, source.get("source")
                        joint[key] += inputs.deviation(name, source["u_" + key], exact(source.get("dof", source.get("nu", "inf"))))
            self.joints.append(joint)

    def at(self, readings, pose=None):
        """`pose`: its name, where readings are uncertain in it."""
        return chained(self.frames(readings, pose)[-1], self.tool)

    def frames(self, readings, pose=None):
        places = [(IDENTITY, ZERO)]
        for number, (joint, q) in enumerate(zip(self.joints, readings)):
            q = sum((self.inputs.deviation((self.id, pose, number, i), u) for i, u in enumerate(joint["u"])), Dual.of(q))
            travel, slides = (q - joint["q_zero"]) * joint["sign"], joint["letter"] == "s"
            own = turn(2, joint["theta"] + (0 if slides else travel)), [Dual(0), Dual(0), joint["d"] + (travel if slides else 0)]
            link = product(turn(0, joint["alpha"]), turn(1, joint["beta"])), [joint["a"], Dual(0), Dual(0)]
            places.append(chained(chained(places[-1], link), own) if self.craig else chained(chained(places[-1], own), link))
        return places


def evaluate(entry, project):
    setup, inputs, results = entry["setup"], Inputs(), {}
    if setup["robot"] not in project.assets or setup.get("data", "readings") != "readings":
        raise NotImplementedError("a robot that an analysis identified, places by inverse kinematics")
    if setup.get("orientation", "zyx") not in ("none", "zyx"):
        raise NotImplementedError("other angles")
    arm = Arm(project.assets[setup["robot"]], project.folder, inputs)
    for row in table(setup["poses"], project.folder):
        r, o = arm.at([row.get(f"{joint['letter']}_{i + 1}", joint["q_zero"]) for i, joint in enumerate(arm.joints)], row["name"])
        r, o = chained(arm.base, (r, o)) if setup.get("frame") == "world" else (r, o)
        results |= {(symbol, row["name"]): value for symbol, value in (dict(zip("xyz", o)) | angles_zyx(r)).items()}
    return results, inputs
