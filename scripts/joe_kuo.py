#!/usr/bin/env python3
"""Writes assets/sobol/joe_kuo.bin, the compact table of Joe and Kuo's direction numbers.

    pip install numpy scipy && python3 scripts/joe_kuo.py

SciPy ships new-joe-kuo-6.21201 as arrays: `poly`, the primitive polynomial of each
dimension with its leading and constant coefficients, and `vinit`, the initial numbers
m_1 ... m_s. assets/sobol/README.md describes the file that is written.
"""

import hashlib
import pathlib

import numpy
import scipy.stats

source = pathlib.Path(scipy.stats.__file__).parent / "_sobol_direction_numbers.npz"
table = numpy.load(source)
polynomials, initial = table["poly"], table["vinit"]
assert len(polynomials) == 21201

out = bytearray()
for polynomial, numbers in zip(polynomials[1:], initial[1:]):
    polynomial = int(polynomial)
    out += polynomial.to_bytes(3, "little")
    bits, width = 0, 0
    for i in range(polynomial.bit_length() - 1):
        m = int(numbers[i])
        assert m % 2 == 1 and m < 2 << i
        bits |= (m >> 1) << width
        width += i
    out += bits.to_bytes((width + 7) // 8, "little")

path = pathlib.Path(__file__).parent.parent / "assets/sobol/joe_kuo.bin"
path.write_bytes(out)
print(path.name, len(out), "bytes, SHA-256", hashlib.sha256(out).hexdigest())
