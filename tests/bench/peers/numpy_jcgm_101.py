#!/usr/bin/env python3
"""JCGM 101 9.3, 9.4 and 9.5 with NumPy: 10^6 trials, mean, u and 95 % (9.5: 99 %) symmetric interval.

Needs NumPy (Debian: python3-numpy) and installs nothing. Prints processor seconds, one thread, best of three.
"""
import os

os.environ["OMP_NUM_THREADS"] = "1"
import time

import numpy as np

TRIALS = 1_000_000


def curvilinear(rng, low, high, d):
    a = low - d + 2 * d * rng.random(TRIALS)
    b = low + high - a
    return a + (b - a) * rng.random(TRIALS)


def mass(rng):
    m_r = rng.normal(100_000.0, 0.050, TRIALS)
    dm_r = rng.normal(1.234, 0.020, TRIALS)
    rho_a = rng.uniform(1.10, 1.30, TRIALS)
    rho_w = rng.uniform(7000.0, 9000.0, TRIALS)
    rho_r = rng.uniform(7950.0, 8050.0, TRIALS)
    return (m_r + dm_r) * (1 + (rho_a - 1.2) * (1 / rho_w - 1 / rho_r)) - 100_000.0


def power_meter(rng):
    x1, x2 = rng.normal(0.0, 0.005, TRIALS), rng.normal(0.0, 0.005, TRIALS)
    return x1 * x1 + x2 * x2


def gauge_block(rng):
    l_s = 50_000_623.0 + 25.0 * rng.standard_t(18, TRIALS)
    d = 215.0 + 6.0 * rng.standard_t(24, TRIALS)
    d1, d2 = 4.0 * rng.standard_t(5, TRIALS), 7.0 * rng.standard_t(8, TRIALS)
    alpha_s = rng.uniform(9.5e-6, 13.5e-6, TRIALS)
    theta_0 = rng.normal(-0.1, 0.2, TRIALS)
    delta = 0.5 * np.sin(rng.uniform(0.0, 2 * np.pi, TRIALS))
    d_alpha = curvilinear(rng, -1.0e-6, 1.0e-6, 0.1e-6)
    d_theta = curvilinear(rng, -0.050, 0.050, 0.025)
    return l_s + d + d1 + d2 - l_s * (d_alpha * (theta_0 + delta) + alpha_s * d_theta) - 50_000_000.0


def evaluated(model, probability):
    y = model(np.random.Generator(np.random.Philox(1)))
    low, high = np.quantile(y, [(1 - probability) / 2, (1 + probability) / 2])
    return y.mean(), y.std(ddof=1), low, high


for title, model, probability in (
    ("9.3 mass / mg", mass, 0.95),
    ("9.4 x1 = 0", power_meter, 0.95),
    ("9.5 gauge block / nm", gauge_block, 0.99),
):
    best = min(
        (lambda t: (evaluated(model, probability), time.process_time() - t)[1])(time.process_time()) for _ in range(3)
    )
    mean, u, low, high = evaluated(model, probability)
    print(f"{title}: {best:.3f} s, y = {mean:.6g}, u = {u:.4g}, [{low:.6g}, {high:.6g}]")
