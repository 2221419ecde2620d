"""Writes discrepancy.json, the judge of the discrepancies of src/stats/l2.rs.

Run as `python3 discrepancy.py > discrepancy.json` with SciPy 1.9 or later. Points are
fractions of 2^32. CD, WD, MD and L2-star are SciPy's; the modified one, which SciPy lacks,
is the sum of the squares of L2-star over all projections. Each "exact" value is the square
of the discrepancy, in exact rationals and then rounded.
"""

import itertools
import json
from fractions import Fraction
from math import prod

import numpy
from scipy.stats import qmc

ONE = 2**32


HALF = Fraction(1, 2)


def centre(x):
    return abs(x - HALF)


def apart(x, y):
    return abs(x - y)


# The mean of the kernel, its mean over one argument, the kernel.
FORMS = {
    "l2_star": (
        Fraction(1, 3),
        lambda x: (1 - x * x) / 2,
        lambda x, y: 1 - max(x, y),
    ),
    "centred": (
        Fraction(13, 12),
        lambda x: 1 + (centre(x) - centre(x) ** 2) / 2,
        lambda x, y: 1 + (centre(x) + centre(y) - apart(x, y)) / 2,
    ),
    "wrap_around": (
        Fraction(4, 3),
        lambda x: Fraction(4, 3),
        lambda x, y: Fraction(3, 2) - apart(x, y) * (1 - apart(x, y)),
    ),
    "mixture": (
        Fraction(19, 12),
        lambda x: Fraction(5, 3) - (centre(x) + centre(x) ** 2) / 4,
        lambda x, y: Fraction(15, 8)
        - (centre(x) + centre(y) + 3 * apart(x, y)) / 4
        + apart(x, y) ** 2 / 2,
    ),
}


def square(name, points):
    """The square of a discrepancy, by its closed form."""
    mean, single, pair = FORMS[name]
    n, d = len(points), len(points[0])
    singles = sum(prod(map(single, p)) for p in points)
    pairs = sum(prod(map(pair, p, q)) for p in points for q in points)
    return mean**d - 2 * singles / n + pairs / n**2


def modified(points):
    """The sum of the squares of L2-star over the projections to some dimensions."""
    d = len(points[0])
    subsets = [s for k in range(d) for s in itertools.combinations(range(d), k + 1)]
    project = lambda s: [[p[i] for i in s] for p in points]
    return sum(square("l2_star", project(s)) for s in subsets)


def sets():
    random = numpy.random.default_rng(20)
    draw = lambda n, d: random.integers(0, ONE, (n, d)).tolist()
    sobol = qmc.Sobol(2, scramble=False).random(8) * ONE
    halton = numpy.floor(qmc.Halton(4, scramble=False).random(60) * ONE)
    yield "gray sobol 8 x 2", sobol.astype(int).tolist()
    yield "halton 60 x 4", halton.astype(int).tolist()
    yield "random 1 x 1", draw(1, 1)
    yield "random 1 x 6", draw(1, 6)
    yield "random 37 x 1", draw(37, 1)
    yield "random 90 x 2", draw(90, 2)
    yield "random 40 x 5", draw(40, 5)
    yield "origin twice", [[0, 0, 0], [0, 0, 0]]
    yield "top corner", [[ONE - 1] * 3]


def main():
    rows = []
    for name, words in sets():
        x = numpy.array(words) / ONE
        exact = [[Fraction(v, ONE) for v in p] for p in words]
        rows.append(
            {
                "name": name,
                "points": words,
                "centred": float(qmc.discrepancy(x, method="CD")),
                "wrap_around": float(qmc.discrepancy(x, method="WD")),
                "mixture": float(qmc.discrepancy(x, method="MD")),
                "l2_star": float(qmc.discrepancy(x, method="L2-star")),
                "exact_modified_l2": float(modified(exact)),
            }
            | {f"exact_{form}": float(square(form, exact)) for form in FORMS}
        )
    print(json.dumps(rows, separators=(",", ":")).replace("},{", "},\n{"))


if __name__ == "__main__":
    main()
