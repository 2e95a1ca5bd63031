#!/usr/bin/env python3
"""A pose from six measured points with NumPy: 18 normal coordinates, two frames, six outputs, 10^6 trials.

What a laboratory writes for one pose of the Stewart platform: draws, frames by cross products, relative pose, Euler
angles, mean, covariance and 95 % intervals. Needs NumPy (Debian: python3-numpy) and installs nothing. Prints processor
seconds, one thread, best of three.
"""
import os

os.environ["OMP_NUM_THREADS"] = "1"
import time

import numpy as np

TRIALS = 1_000_000
U = 2e-6
BASE = np.array([[0.2, 0.0, 0.0], [-0.1, 0.17, 0.0], [-0.1, -0.17, 0.0]])
PLATFORM = np.array([[0.12, 0.01, 0.3], [-0.05, 0.11, 0.31], [-0.06, -0.1, 0.3]])


def frame(p):
    """Origin in the middle of three points, x to the first, z along the normal; arrays of TRIALS x 3."""
    origin = p.mean(axis=0)
    x = p[0] - origin
    x /= np.linalg.norm(x, axis=1)[:, None]
    z = np.cross(p[1] - p[0], p[2] - p[0])
    z /= np.linalg.norm(z, axis=1)[:, None]
    return origin, np.stack([x, np.cross(z, x), z], axis=2)


def pose(rng):
    draw = lambda points: points[:, None, :] + rng.normal(0.0, U, (3, TRIALS, 3))
    o_b, r_b = frame(draw(BASE))
    o_p, r_p = frame(draw(PLATFORM))
    t = np.einsum("nji,nj->ni", r_b, o_p - o_b)
    r = np.einsum("nji,njk->nik", r_b, r_p)
    alpha = np.arctan2(r[:, 2, 1], r[:, 2, 2])
    beta = np.arcsin(-r[:, 2, 0])
    gamma = np.arctan2(r[:, 1, 0], r[:, 0, 0])
    return np.column_stack([t, alpha, beta, gamma])


def evaluated():
    y = pose(np.random.Generator(np.random.Philox(1)))
    return y.mean(axis=0), np.cov(y.T), np.quantile(y, [0.025, 0.975], axis=0)


best = min((lambda t: (evaluated(), time.process_time() - t)[1])(time.process_time()) for _ in range(3))
mean, covariance, interval = evaluated()
print(f"one pose: {best:.2f} s, u = {np.sqrt(np.diag(covariance))}")
