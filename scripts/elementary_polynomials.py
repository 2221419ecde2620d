#!/usr/bin/env python3
"""Coefficients of logarithm.glsl, exponential.glsl and normal_quantile.glsl, lowest first.

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


if __name__ == "__main__":
    root = sqrt(mpf(1) / 2)
    fit("ln(1 + f) / f, f in [sqrt(1/2) - 1, sqrt(2) - 1]", log1p_over, root - 1, 2 * root - 1, 12, (31, 32), True)
    fit("(2^r - 1) / r, r in [0, 1]", exp2m1_over, mpf(0), mpf(1), 7, 32)
