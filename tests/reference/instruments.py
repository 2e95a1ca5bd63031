"""A point that a tracker or total station has measured: p = station + R (d cos e cos a, d cos e sin a, d sin e), every deviation an input."""
import mpmath as mp

from dual import cos, hypot, sin
from statements import DIVISOR
from units import quantity
from vectors import inside, outside, plus, rotation_zyx, stated

MEANING = {"standard": 1, "expanded-k2": 2} | {"limit-" + kind: DIVISOR[kind] for kind in ("rectangular", "triangular", "arcsine")}
EARTH = mp.mpf("6.371e6")


def point(asset, p, number, inputs):
    setup, name = asset["setup"], asset["id"]
    if asset["kind"] != "spherical-instrument" or setup.get("station_angles", "zyx") != "zyx" or setup.get("station_correlations"):
        raise NotImplementedError(f"points of {asset['kind']}")
    figure = lambda key: quantity(setup, key)
    shared = lambda key: inputs.deviation((name, key), figure("u_" + key))
    own = lambda kind, u: inputs.deviation((name, number, kind), u / MEANING[setup.get("meaning", "standard")])
    position, angles = stated(setup.get("station"))
    v = inside((rotation_zyx(*angles), position), p)
    x, y, z, d, level = (c.v for c in (*v, hypot(*v), hypot(*v[:2])))
    distance = d + own("d", figure("distance_constant") + figure("distance_scale") * d) + shared("scale") * d + shared("zero")
    azimuth = mp.atan2(y, x) + own("a", figure("angle_azimuth") + figure("across_constant") / level) + \
        shared("collimation") * (d / level) + shared("axis_tilt") * (z / level) + shared("beam_offset") * (1 / level)
    elevation = mp.atan2(z, level) + own("e", figure("angle_elevation") + figure("across_constant") / d) + \
        shared("index") + shared("refraction") * (d / (2 * EARTH))
    place = plus(position, [shared("station_" + axis) for axis in "xyz"])
    turned = rotation_zyx(*plus(angles, [shared("station_" + axis) for axis in ("omega", "phi", "kappa")]))
    level = distance * cos(elevation)
    return outside((turned, place), [level * cos(azimuth), level * sin(azimuth), distance * sin(elevation)])
