"""Truth for the extreme rows of the scattering distributions, to 60 digits:
python3 scattering_truth.py > scattering_truth.csv

Formulas as the papers print them; every input is a float or an integer, exactly."""

import struct

from mpmath import cos, mp, mpf, pi, sin, sqrt

mp.dps = 60


def f32(x):
    """The nearest float, exactly."""
    return mpf(struct.unpack("f", struct.pack("f", x))[0])


def text(x):
    return mp.nstr(x, 24, min_fixed=1, max_fixed=0)


def normalized(v):
    length = sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def line(row, what, numbers, *truths):
    inputs = " ".join(repr(float(x)) for x in numbers)
    print(f"{row},{what},{inputs}," + " ".join(text(x) for x in truths))


def distribution(alpha, h):
    """Walter et al. 2007, eq. 33, isotropic: alpha^2 / (pi ((alpha^2 - 1) cos^2 + 1)^2)."""
    x, y, z = normalized(h)
    return alpha**2 / (pi * ((alpha**2 - 1) * z * z + 1) ** 2)


def cap(alpha, wo, u, v):
    """Dupuy and Benyoub 2023, listing 3: the reflected direction."""
    wo = normalized(wo)
    view = normalized([alpha * wo[0], alpha * wo[1], wo[2]])
    z = (1 - u) * (1 + view[2]) - view[2]
    radius = sqrt(max(0, 1 - z * z))
    c = [radius * cos(2 * pi * v), radius * sin(2 * pi * v), z]
    n = [a + b for a, b in zip(c, view)]
    h = normalized([alpha * n[0], alpha * n[1], n[2]])
    dot = sum(a * b for a, b in zip(wo, h))
    stretched = sqrt(alpha**2 * (wo[0] ** 2 + wo[1] ** 2) + wo[2] ** 2)
    pdf = distribution(alpha, h) / (2 * (wo[2] + stretched))
    return [2 * dot * a - b for a, b in zip(h, wo)] + [pdf]


def masking(alpha, w):
    """Smith's G1 by Lambda = (-1 + sqrt(1 + alpha^2 tan^2)) / 2."""
    x, y, z = normalized(w)
    tan_square = (x * x + y * y) / (z * z)
    return 1 / (1 + (sqrt(1 + alpha**2 * tan_square) - 1) / 2)


def phase(g, u, v):
    """Henyey and Greenstein's direction and pdf."""
    if g == 0:
        c = 2 * u - 1
    else:
        c = (1 + g * g - ((1 - g * g) / (1 - g + 2 * g * u)) ** 2) / (2 * g)
    pdf = (1 - g * g) / (4 * pi * (1 + g * g - 2 * g * c) ** mpf(1.5))
    radius = sqrt((1 - c) * (1 + c))
    return [radius * cos(2 * pi * v), radius * sin(2 * pi * v), c, pdf]


two = mpf(2) ** 32
for alpha in map(f32, (1e-3, 1e-4)):
    for slope in (0.25, 1, 4):
        h = [f32(float(alpha) * slope), mpf(0), f32(1)]
        line(30, "distribution", [alpha, *h], distribution(alpha, h))
for alpha in map(f32, (0.5, 1e-2, 1e-3)):
    for height in map(f32, (1e-2, 1e-4, 1e-6)):
        wo = [f32(1), mpf(0), height]
        for u in (1, 2**16, 2**31, 2**32 - 2**16):
            v = 2**29
            line(31, "cap", [alpha, *wo, u, v], *cap(alpha, wo, u / two, v / two))
for alpha in map(f32, (1, 0.1, 1e-3)):
    for height in map(f32, (1e-3, 1e-10, 1e-25)):
        w = [f32(1), mpf(0), height]
        line(32, "masking", [alpha, *w], masking(alpha, w))
for rest in map(f32, (1e-3, 1e-6)):
    for u in (1, 2**24, 2**31, 2**32 - 2**20, 2**32 - 1):
        v = 2**29
        line(33, "phase", [rest, u, v], *phase(1 - rest, u / two, v / two))
for u in (0, 2**30, 2**32 - 1):
    v = 2**29
    line(34, "phase", [f32(1), u, v], *phase(mpf(0), u / two, v / two))
