"""Truth for tests/cpu/solid, in 60 digits.

Made by: python3 tests/data/solid_truth.py > tests/data/solid_truth.csv (mpmath 1.3.0)

A line is: row of the catalogue of extreme cases, map, parameters, fractions of 2^32,
quantity, its value. Parameters are exact: floats in full, or decimals taken as they stand.
"""

import struct

from mpmath import asin, atan2, cos, mp, mpf, pi, sin, sqrt

mp.dps = 60


def f32(x):
    """The float nearest to x, exactly."""
    return mpf(struct.unpack("f", struct.pack("f", x))[0])


def line(row, name, parameters, u, quantity, value):
    u = " ".join(str(k) for k in u)
    parameters = " ".join(p if isinstance(p, str) else mp.nstr(p, 30) for p in parameters)
    print(f"{row},{name},{parameters},{u},{quantity},{mp.nstr(value, 25)}")


def sphere():
    for k in [1, 2, 77, 4096, 2**31, 2**32 - 4096, 2**32 - 1]:
        u = mpf(k) / 2**32
        line(19, "uniform-sphere", [], [k, 0], "x", 2 * sqrt(u * (1 - u)))
        line(19, "uniform-sphere", [], [k, 0], "z", 1 - 2 * u)


def cone():
    for theta_max in ["1e-3", "3e-4", "2e-4", "1e-4", "1e-6", "1.5", "3", "3.14159265358979323846"]:
        row = 21 if theta_max.startswith("3.") else 20
        h = 2 * sin(mpf(theta_max) / 2) ** 2
        line(row, "cone", [theta_max], [0, 0], "pdf", 1 / (2 * pi * h))
        for k in [1, 2**31, 2**32 - 1]:
            x = h * k / 2**32
            line(row, "cone", [theta_max], [k, 0], "x", sqrt(x * (2 - x)))


sphere()
cone()
