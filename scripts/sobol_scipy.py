#!/usr/bin/env python3
"""Writes tests/data/sobol_scipy.bin, points of SciPy's Sobol sequence to compare with.

    pip install numpy scipy && python3 scripts/sobol_scipy.py

u32 little-endian, fractions of 2^32, in SciPy's order (Gray code), unscrambled:
1,024 points of 10 dimensions, then 40 points of dimensions 0, 97, 194, ... 21,146 and
21,200 (from 0).
"""

import pathlib

import numpy
from scipy.stats import qmc

few = qmc.Sobol(10, scramble=False, bits=32).random(1024)
many = qmc.Sobol(21201, scramble=False, bits=32).random(40)
columns = [*range(0, 21201, 97), 21200]
data = numpy.concatenate([few.ravel(), many[:, columns].ravel()]) * 2.0**32
words = data.astype("<u4")
assert (words == data).all()
path = pathlib.Path(__file__).parent.parent / "tests/data/sobol_scipy.bin"
path.write_bytes(words.tobytes())
print(path.name, words.size, "words")
