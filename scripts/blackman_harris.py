"""Polynomials of shaders/corput/filter_blackman_harris.glsl (mpmath 1.3.0).

The 4-term window of Harris 1978, over its integral a0, at the distance x <= 1/2 from the
middle or from the edge, and its integral, by interpolation in Chebyshev nodes of
z = 4 x^2: integral = x (end + z Q(z)), density = end + z D(z).
"""

from mpmath import chebyfit, cos, mp, mpf, pi, sin, sqrt

mp.dps = 40
A = [mpf("0.35875"), mpf("0.48829"), mpf("0.14128"), mpf("0.01168")]


def side(edge):
    """Signs of the cosines, the density at the end, and both functions of z."""
    a = [x * (-1) ** k if edge else x for k, x in enumerate(A)]
    end = sum(a) / a[0]

    def integral(z):
        x = sqrt(z) / 2
        total = x + sum(a[k] * sin(k * pi * x) / (k * pi * a[0]) for k in (1, 2, 3))
        return (total / x - end) / z

    def density(z):
        x = sqrt(z) / 2
        return (sum(a[k] * cos(k * pi * x) for k in range(4)) / a[0] - end) / z

    return end, integral, density


def horner(name, f, degree, bits):
    """Steps p = c +- z p of nested sums that keep their signs, in units of 2^-bits."""
    c = chebyfit(lambda z: f(z), [mpf(10) ** -9, 1], degree + 1)[::-1]
    nested = [lambda z, k=k: sum(x * z**j for j, x in enumerate(c[k:])) for k in range(degree + 1)]
    signs = []
    for k, p in enumerate(nested):
        values = [p(mpf(i) / 64) for i in range(65)]
        assert all(v * values[0] > 0 for v in values), (name, k)
        assert all(abs(v) * 2**bits < 2**32 - 8 for v in values), (name, k)
        signs.append(1 if values[0] > 0 else -1)
    worst = max(abs(nested[0](mpf(i) / 999) - f(mpf(i) / 999)) for i in range(1, 1000))
    print(name, "sign", signs[0], "error 2^", mp.nstr(mp.log(worst, 2), 4))
    for k in range(degree, -1, -1):
        own = "+" if c[k] * signs[k] > 0 else "-"
        step = "" if k == degree else " + " if signs[k] == signs[k + 1] else " - "
        print(f"  {own}{int(mp.nint(abs(c[k]) * 2**bits))}{step}z p")


for edge in (False, True):
    end, integral, density = side(edge)
    exponent = int(mp.floor(mp.log(end, 2))) - 31
    print("edge" if edge else "middle", "end", int(mp.nint(end / mpf(2) ** exponent)), exponent)
    horner("  integral", integral, 7, 33 if edge else 30)
    horner("  density", density, 8, 32 if edge else 30)
end, integral, density = side(False)
print("share of the middle", int(mp.nint((end + integral(mpf(1))) / 2 * 2**32)))
