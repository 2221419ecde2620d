"""Truth for tests/cpu/solid, in 80 digits.

Made by: python3 tests/data/solid_truth.py > tests/data/solid_truth.csv (mpmath 1.3.0)

A line is: row of the catalogue of extreme cases, map, parameters, fractions of 2^32,
quantity, its value. Parameters are exact: floats in full, or decimals taken as they stand.
"""

import struct

from mpmath import acos, cos, mp, mpf, pi, sin, sqrt

mp.dps = 80


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


def dot(v, w):
    return sum(a * b for a, b in zip(v, w))


def scaled(v, a):
    return [x * a for x in v]


def plus(v, w):
    return [a + b for a, b in zip(v, w)]


def cross(v, w):
    return [v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2] for i in range(3)]


def unit(v):
    return scaled(v, 1 / sqrt(dot(v, v)))


def solid_angle(a, b, c):
    """Girard's theorem, which loses its digits, of which there are enough."""
    na, nb, nc = unit(cross(b, c)), unit(cross(c, a)), unit(cross(a, b))
    return sum(acos(-dot(*pair)) for pair in [(na, nb), (nb, nc), (nc, na)]) - pi


def arvo(a, b, c, u, v):
    """Arvo 1995, as written."""
    a, b, c = unit(a), unit(b), unit(c)
    area = u * solid_angle(a, b, c)
    alpha = acos(-dot(unit(cross(c, a)), unit(cross(a, b))))
    s, t = sin(area - alpha), cos(area - alpha)
    p, q = t - cos(alpha), s + sin(alpha) * dot(a, b)
    q = ((q * t - p * s) * cos(alpha) - q) / ((q * s + p * t) * sin(alpha))
    moving = plus(scaled(a, q), scaled(unit(plus(c, scaled(a, -dot(c, a)))), sqrt(1 - q * q)))
    z = 1 - v * (1 - dot(moving, b))
    side = unit(plus(moving, scaled(b, -dot(moving, b))))
    return plus(scaled(b, z), scaled(side, sqrt(1 - z * z)))


TRIANGLES = [
    (23, [0, 0, 1, 1e-2, 0, 1, 0, 1e-2, 1]),
    (23, [0, 0, 1, 1e-3, 0, 1, 0, 1e-3, 1]),
    (23, [0, 0, 1, 1e-5, 0, 1, 0, 1e-5, 1]),
    (23, [0, 0, 1, 0, 1e-5, 1, 1e-5, 0, 1]),
    (23, [1e-9, 0, 1, 0, 1e-9, 1, -1e-9, -1e-9, 1]),
    (24, [0.3, 0.4, 0.8, 0.30001, 0.4, 0.8, 0.3, 0.40001, 0.8]),
    (24, [30, 40, 80, 30.02, 40.01, 79.99, 29.99, 40.02, 80.01]),
    (25, [1, 0, 1e-4, -0.5, 0.8660254, 1e-4, -0.5, -0.8660254, 1e-4]),
    (25, [1, 0, 1e-7, -0.5, 0.8660254, 1e-7, -0.5, -0.8660254, 1e-7]),
    (25, [1, 0, 1e-6, -1, 1e-6, 2e-6, 0.3, 1, 1e-6]),
    (23, [1, 0, 0, 0, 1, 0, 0, 0, 1]),
    (23, [1, 0, 0, 0, 0, 1, 0, 1, 0]),
    (23, [1, 0.2, 0.1, 1.00001, 0.2, 0.1, -1, 0.3, 0.2]),
    (23, [1, 0.2, 0.1, -1, 0.3, 0.2, 1.00001, 0.2, 0.1]),
    (23, [100, 0.3, 1, 1, 0.3, 1, 1, 0.30001, 1]),
    (23, [-7, 1, 1, 1e-3, 2e-3, 4e-3, 900, -30, 800]),
    (25, [1, 0, 1e-5, -1, 0.1, 1e-5, -1, -0.1, 1e-5]),
]


def triangle():
    for row, numbers in TRIANGLES:
        numbers = [f32(x) for x in numbers]
        a, b, c = numbers[:3], numbers[3:6], numbers[6:]
        line(row, "spherical-triangle", numbers, [0, 0], "area", solid_angle(a, b, c))
        for u in [(1, 1), (2**31, 2**31), (2**30, 2**32 - 1), (2**32 - 1, 2**29), (2**32 - 4096, 4096), (7, 2**31)]:
            d = arvo(a, b, c, mpf(u[0]) / 2**32, mpf(u[1]) / 2**32)
            for axis, x in zip("xyz", d):
                line(row, "spherical-triangle", numbers, u, axis, x)


sphere()
cone()
triangle()
