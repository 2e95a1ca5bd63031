"""Units of the shipped projects: their factor to SI, and their zero for temperatures in degC."""
import re

import mpmath as mp

PREFIX = {"": 0, "p": -12, "n": -9, "u": -6, "µ": -6, "m": -3, "c": -2, "d": -1, "h": 2, "k": 3, "M": 6, "G": 9}
BASE = {"m": 1, "g": mp.mpf("1e-3"), "s": 1, "A": 1, "K": 1, "rad": 1, "N": 1, "V": 1, "ohm": 1, "Ω": 1, "W": 1, "Hz": 1,
        "Pa": 1, "J": 1, "C": 1, "H": 1, "F": 1, "l": mp.mpf("1e-3"), "L": mp.mpf("1e-3"), "mol": 1, "cd": 1}
OTHER = {"1": 1, "": 1, "%": mp.mpf("1e-2"), "ppm": mp.mpf("1e-6"), "deg": mp.pi / 180, "°": mp.pi / 180, "degC": 1,
         "°C": 1, "gon": mp.pi / 200, "mgon": mp.pi / 200000, "arcsec": mp.pi / 648000, "arcmin": mp.pi / 10800, "in": mp.mpf("0.0254"),
         "min": 60, "h": 3600, "cc": mp.pi / 2000000}


def one(name):
    if name in OTHER:
        return mp.mpf(OTHER[name])
    for prefix, power in PREFIX.items():
        if name.startswith(prefix) and name[len(prefix):] in BASE:
            return mp.mpf(10) ** power * BASE[name[len(prefix):]]
    raise ValueError(f"unit {name}")


def factor(text):
    """The factor to SI units of an expression such as "kg/m^3" or "nm/(m K)"."""
    tokens = re.findall(r"[A-Za-zµΩ°%]+|\d+|[*/^()·]|-", (text or "1").replace("²", "^2").replace("³", "^3"))
    at = 0

    def power():
        nonlocal at
        token = tokens[at]
        at += 1
        if token == "(":
            value = product()
            at += 1
        else:
            value = one(token)
        if at < len(tokens) and tokens[at] == "^":
            at += 1
            sign = 1
            if tokens[at] == "-":
                sign, at = -1, at + 1
            value **= sign * int(tokens[at])
            at += 1
        return value

    def product():
        nonlocal at
        value = power()
        while at < len(tokens) and tokens[at] != ")":
            if tokens[at] == "/":
                at += 1
                value /= power()
            else:
                at += tokens[at] in "*·"
                value *= power()
        return value

    return product()


def zero(text):
    return mp.mpf("273.15") if text in ("degC", "°C") else mp.mpf(0)


def exact(value):
    """The number as it is typed, with all its digits."""
    return mp.mpf(repr(value) if isinstance(value, float) else value)


def number(value):
    """The number in a cell, as a program reads it."""
    return mp.mpf(float(value))


def si(value, unit):
    return exact(value) * factor(unit) + zero(unit)


def quantity(setup, key, default=0):
    """The quantity that a set-up states under this key, in SI units."""
    return si(setup[key]["value"], setup[key]["unit"]) if setup.get(key) else exact(default)
