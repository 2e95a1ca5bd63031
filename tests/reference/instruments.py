"""A point that a tracker or total station has measured: p = station + R (d cos e cos a, d cos e sin a, d sin e), every deviation an input."""
import mpmath as mp

from dual import Dual, atan2, cos, hypot, sin
from poses import minus, plus, rotation_zyx, times, transposed
from units import factor

MEANING = {"standard": 1, "expanded-k2": 2, "limit-rectangular": mp.sqrt(3), "limit-triangular": mp.sqrt(6), "limit-arcsine": mp.sqrt(2)}
EARTH = mp.mpf("6.371e6")


def point(asset, p, number, inputs):
    setup, name = asset["setup"], asset["id"]
    if asset["kind"] != "spherical-instrument" or setup.get("station_angles", "zyx") != "zyx" or setup.get("station_correlations"):
        raise NotImplementedError(f"points of {asset['kind']}")
    figure = lambda key: mp.mpf(repr(setup[key]["value"])) * factor(setup[key]["unit"]) if key in setup else mp.mpf(0)
    station = setup.get("station", {"position": [0, 0, 0], "lengthUnit": "m", "angles": [0, 0, 0], "angleUnit": "rad"})
    shared = lambda key: inputs.deviation((name, key), figure("u_" + key))
    position = [mp.mpf(repr(v)) * factor(station["lengthUnit"]) for v in station["position"]]
    angles = [mp.mpf(repr(v)) * factor(station["angleUnit"]) for v in station["angles"]]
    v = times(transposed(rotation_zyx(*angles)), minus(p, [Dual(c) for c in position]))
    d, level = hypot(*v).v, hypot(v[0], v[1]).v
    own = lambda kind, u: inputs.deviation((name, number, kind), u / MEANING[setup.get("meaning", "standard")])
    distance = Dual(d) + own("d", figure("distance_constant") + figure("distance_scale") * d) + shared("scale") * d + shared("zero")
    azimuth = Dual(atan2(v[1], v[0]).v) + own("a", figure("angle_azimuth") + figure("across_constant") / level) + \
        shared("collimation") * (d / level) + shared("axis_tilt") * (v[2].v / level) + shared("beam_offset") * (1 / level)
    elevation = Dual(atan2(v[2], hypot(v[0], v[1])).v) + own("e", figure("angle_elevation") + figure("across_constant") / d) + \
        shared("index") + shared("refraction") * (d / (2 * EARTH))
    place = [Dual(c) + shared("station_" + axis) for c, axis in zip(position, "xyz")]
    turn = rotation_zyx(*(Dual(a) + shared("station_" + axis) for a, axis in zip(angles, ("omega", "phi", "kappa"))))
    level = distance * cos(elevation)
    return plus(place, times(turn, [level * cos(azimuth), level * sin(azimuth), distance * sin(elevation)]))
