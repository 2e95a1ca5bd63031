"""Vectors, rotations and poses of dual numbers. A pose is a pair (rotation, origin)."""
import mpmath as mp

from dual import Dual, atan2, cos, sin, sqrt
from units import exact, factor

ZERO = [Dual(0)] * 3
IDENTITY = [[Dual(int(i == j)) for j in range(3)] for i in range(3)]
NORMAL = ("n_x", "n_y", "n_z")


def values(vector):
    return [x.v for x in vector]


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Dual(0))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def plus(*vectors):
    return [sum(parts[1:], parts[0]) for parts in zip(*vectors)]


def scaled(a, factor_):
    return [x * factor_ for x in a]


def unit(a):
    return scaled(a, 1 / sqrt(dot(a, a)))


def mean(vectors):
    return scaled(plus(*vectors), mp.mpf(1) / len(vectors))


def without(d, n):
    """The part of d across the unit vector n."""
    return minus(d, scaled(n, dot(n, d)))


def across(n):
    """Two directions that complete n to a frame."""
    a = unit(cross(n, IDENTITY[min(range(3), key=lambda j: abs(n[j].v))]))
    return a, cross(n, a)


def times(m, v):
    return [dot(row, v) for row in m]


def transposed(m):
    return [list(column) for column in zip(*m)]


def product(a, b):
    return transposed([times(a, column) for column in transposed(b)])


def turn(axis, angle):
    """Rotation about x, y or z."""
    c, s, i, j = cos(angle), sin(angle), (axis + 1) % 3, (axis + 2) % 3
    r = [list(row) for row in IDENTITY]
    r[i][i], r[j][j], r[i][j], r[j][i] = c, c, -s, s
    return r


def rotation_zyx(alpha, beta, gamma):
    return product(turn(2, gamma), product(turn(1, beta), turn(0, alpha)))


def angles_zyx(r):
    return {"alpha": atan2(r[2][1], r[2][2]), "beta": atan2(-r[2][0], sqrt(r[0][0] ** 2 + r[1][0] ** 2)), "gamma": atan2(r[1][0], r[0][0])}


def stated(pose):
    """Position and angles alpha, beta, gamma of a pose of the project file."""
    if pose is None:
        return ZERO, ZERO
    return ([Dual(exact(v) * factor(pose[unit_])) for v in pose[key]] for key, unit_ in (("position", "lengthUnit"), ("angles", "angleUnit")))


def placement(pose):
    position, angles = stated(pose)
    return rotation_zyx(*angles), position


def outside(pose, p):
    """The place p of a frame, seen from where the frame stands."""
    return plus(pose[1], times(pose[0], p))


def inside(pose, p):
    """The place p in the frame that stands there."""
    return times(transposed(pose[0]), minus(p, pose[1]))


def chained(first, second):
    return product(first[0], second[0]), outside(first, second[1])
