#!/usr/bin/env python3
"""Coefficients of logarithm, exponential, normal_quantile and its native form, lowest first.

    python3 scripts/elementary_polynomials.py        # needs mpmath

Each line is a polynomial by interpolation in Chebyshev nodes at 60 digits, in units of
2^-bits, and the logarithm of its relative error before rounding.
"""

from mpmath import chebyfit, erfc, exp, findroot, log, mp, mpf, npdf, pi, sqrt

mp.dps = 60


def fit(name, f, low, high, degree, bits, alternating=False):
    """`bits` holds one number for all coefficients, or that of the first and of the others."""
    coefficients, _ = chebyfit(f, [low, high], degree + 1, error=True)
    coefficients = coefficients[::-1]
    points = [low + (high - low) * mpf(i) / 997 for i in range(998)]
    values = [(sum(c * x**k for k, c in enumerate(coefficients)), f(x)) for x in points]
    error = max(abs(p / t - 1) for p, t in values)
    first, rest = bits if isinstance(bits, tuple) else (bits, bits)
    scaled = [int(mp.nint(c * 2 ** (rest if k else first))) for k, c in enumerate(coefficients)]
    if alternating:
        scaled = [-c if k % 2 else c for k, c in enumerate(scaled)]
    print(f"{name}: 2^{float(log(error, 2)):.1f}\n  {scaled}")


def floats(name, f, low, high, degree):
    """Of the native profile: as decimal floats."""
    coefficients, error = chebyfit(f, [low, high], degree + 1, error=True)
    print(f"{name}: {float(error):.1e}\n  {[f'{float(c):.9g}' for c in coefficients[::-1]]}")


def log1p_over(f):
    return log(1 + f) / f if abs(f) > mpf(10) ** -30 else 1 - f / 2


def exp2m1_over(r):
    return (2**r - 1) / r if abs(r) > mpf(10) ** -30 else log(2)


def tail(z):
    """The normal distribution's mass above z."""
    return erfc(z / sqrt(2)) / 2


def quantile(q):
    """z with tail(z) = q <= 1/2."""
    start = sqrt(max(-2 * log(q) - log(2 * pi * max(-2 * log(q), 1)), mpf(1) / 10**6))
    return findroot(lambda z: log(tail(z) / q), start)


def centre(w):
    """z / (2 x), x = 1/2 - tail(z), w = 8 x^2."""
    x = sqrt(w / 8)
    return quantile(mpf(1) / 2 - x) / (2 * x) if w > mpf(10) ** -30 else sqrt(pi / 2)


if __name__ == "__main__":
    root = sqrt(mpf(1) / 2)
    fit("ln(1 + f) / f, f in [sqrt(1/2) - 1, sqrt(2) - 1]", log1p_over, root - 1, 2 * root - 1, 12, (31, 32), True)
    fit("(2^r - 1) / r, r in [0, 1]", exp2m1_over, mpf(0), mpf(1), 7, 32)
    fit("z / (2 x) by 8 x^2 in [0, 1], x = 1/2 - q", centre, mpf(0), mpf(1), 11, 31)
    for low, scale, high, bits, degree in ((1.9375, 2, 3.75, 30, 11), (3.75, 4, 6.8125, 29, 10)):
        low = mpf(low)
        fit(f"z by (t - {low}) / {scale}, t = sqrt(-2 ln q) from {low} to {high}",
            lambda s: quantile(exp(-((low + s * scale) ** 2) / 2)),
            mpf(0), (high - low) / scale, degree, (bits, bits - 1))
    fit("(1/2 - q) / z by z^2 / 2 in [0, 1]", lambda w: (mpf(1) / 2 - tail(sqrt(2 * w))) / sqrt(2 * w) if w > 0 else npdf(0),
        mpf(0), mpf(1), 7, 32, True)
    fit("q e^(z^2 / 2) by 4 / (4 + z), z from 1.4 to 7", lambda u: tail(4 / u - 4) * exp((4 / u - 4) ** 2 / 2),
        mpf(4) / 11, mpf(4) / mpf("5.4"), 8, 32)

    floats("native: z / (2 x) by 8 x^2", centre, mpf(0), mpf(1), 7)
    floats("native: z by t - 2.8", lambda s: quantile(exp(-((s + mpf("2.8")) ** 2) / 2)),
           mpf("-0.87"), mpf("0.95"), 7)
    floats("native: z by t - 5.25", lambda s: quantile(exp(-((s + mpf("5.25")) ** 2) / 2)),
           mpf("-1.5"), mpf("1.57"), 6)
    floats("native: (1/2 - q) / z by z^2 / 2", lambda w: (mpf(1) / 2 - tail(sqrt(2 * w))) / sqrt(2 * w) if w > 0 else npdf(0),
           mpf(0), mpf(1), 5)
    floats("native: q e^(z^2 / 2) by 4 / (4 + z)", lambda u: tail(4 / u - 4) * exp((4 / u - 4) ** 2 / 2),
           mpf(4) / 11, mpf(4) / mpf("5.4"), 6)
