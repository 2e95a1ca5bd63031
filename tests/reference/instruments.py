"""What a tracker, total station, camera or distance meter reads, every deviation an input, and a point that it measured by itself:
p = station + R (d cos e cos a, d cos e sin a, d sin e)."""
import mpmath as mp

from dual import Dual, cos, hypot, sin
from statements import DIVISOR
from units import exact, quantity
from vectors import inside, outside, plus, product, rotation_zyx, stated, turn

MEANING = {"standard": 1, "expanded-k2": 2} | {"limit-" + kind: DIVISOR[kind] for kind in ("rectangular", "triangular", "arcsine")}
EARTH = mp.mpf("6.371e6")
READS = {"camera": "ae", "distance-meter": "d"}
STATION = ("x", "y", "z", "omega", "phi", "kappa")


def rotation(setup, angles):
    omega, phi, kappa = angles
    if setup.get("station_angles", "zyx") == "zyx":
        return rotation_zyx(omega, phi, kappa)
    return product(turn(0, omega), product(turn(1, phi), turn(2, kappa)))


def reads(setup):
    if setup.get("kind") == "generic":
        return "".join(o for o, key in zip("dae", ("distance", "azimuth", "elevation")) if setup.get("reads_" + key, True))
    return READS.get(setup.get("kind"), "dae")


def figures(setup, v):
    """Standard uncertainty of each reading of a target at v, independent of all others."""
    d, level = mp.norm(v), max(mp.norm(v[:2]), mp.norm(v) / 1000)
    figure = lambda key: quantity(setup, key) / MEANING[setup.get("meaning", "standard")]
    return {"d": figure("distance_constant") + figure("distance_scale") * d, "a": figure("angle_azimuth") + figure("across_constant") / level,
            "e": figure("angle_elevation") + figure("across_constant") / d}


def shared(setup, v, overhead=False):
    """For each reading, what all readings of the instrument share: name -> change by a deviation of one. Overhead an azimuth counts as a displacement."""
    d, level = mp.norm(v), mp.mpf(1) if overhead else mp.norm(v[:2])
    return {"d": {"scale": d, "zero": 1}, "e": {"index": 1, "refraction": d / (2 * EARTH)},
            "a": {"collimation": d / level, "axis_tilt": v[2] / level, "beam_offset": 1 / level}}


def station_deviations(setup, name, inputs):
    """Of the six coordinates; `name` tells a station from the same one located anew."""
    own = {axis: inputs.deviation((name, "station", axis), quantity(setup, "u_station_" + axis)) for axis in STATION}
    correlation = setup.get("station_correlation")
    for first, second, r in correlation["rows"] if correlation else []:
        symbols = dict(zip(("x_0", "y_0", "z_0"), STATION)) | dict(zip(STATION, STATION))
        i, j = (inputs.of_symbol((name, "station", symbols[symbol]))[0] for symbol in (first, second))
        inputs.correlate(i, j, exact(r))
    return list(own.values())


def point(asset, p, number, inputs):
    setup, name = asset["setup"], asset["id"]
    if asset["kind"] != "spherical-instrument" or setup.get("station_angles", "zyx") != "zyx" or setup.get("station_correlation"):
        raise NotImplementedError(f"points of {asset['kind']}")
    position, angles = stated(setup.get("station"))
    v = [c.v for c in inside((rotation(setup, angles), position), p)]
    read = {"d": Dual(mp.norm(v)), "a": Dual(mp.atan2(v[1], v[0])), "e": Dual(mp.atan2(v[2], mp.norm(v[:2])))}
    for kind, u in figures(setup, v).items():
        read[kind] += inputs.deviation((name, number, kind), u)
        for key, effect in shared(setup, v)[kind].items():
            read[kind] += inputs.deviation((name, key), quantity(setup, "u_" + key)) * effect
    moved = station_deviations(setup, name, inputs)
    level = read["d"] * cos(read["e"])
    return outside((rotation(setup, plus(angles, moved[3:])), plus(position, moved[:3])),
                   [level * cos(read["a"]), level * sin(read["a"]), read["d"] * sin(read["e"])])
