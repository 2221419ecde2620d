"""Makes points with SciPy, NumPy and Torch, and says how many seconds that took.

The argument is how many threads there are. The first line names the libraries that there are; of
others standard error has why they are not. Each line of input is a library, what to make,
dimensions and rows; each line of output the seconds, or what is wrong with the values.
"""

import sys
import time

makers = {}
versions = []
cores = int(sys.argv[1])


def without(library, error):
    print(f"without {library}: {error}", file=sys.stderr)


try:
    import scipy
    from scipy.stats import qmc

    versions.append(f"scipy-{scipy.__version__}")
    makers["scipy", "halton"] = lambda d, n: qmc.Halton(d, scramble=False).random(n, workers=cores)
    makers["scipy", "sobol"] = lambda d, n: qmc.Sobol(d, scramble=False).random(n)
    makers["scipy", "sobol-scrambled"] = lambda d, n: qmc.Sobol(d, scramble=True, seed=1).random(n)
except ImportError as error:
    without("SciPy", error)

try:
    import numpy

    versions.append(f"numpy-{numpy.__version__}")
    generator = numpy.random.Generator(numpy.random.SFC64(1))
    makers["numpy", "random"] = lambda d, n: generator.random((n, d), dtype=numpy.float32)
except ImportError as error:
    without("NumPy", error)

try:
    import torch

    versions.append(f"torch-{torch.__version__}")
    engine = torch.quasirandom.SobolEngine
    makers["torch", "sobol"] = lambda d, n: engine(d).draw(n)
    makers["torch", "sobol-scrambled"] = lambda d, n: engine(d, scramble=True, seed=1).draw(n)
    makers["torch", "random"] = lambda d, n: torch.rand(n, d)
except ImportError as error:
    without("Torch", error)

print(*versions, flush=True)
for line in sys.stdin:
    library, what, dimensions, rows = line.split()
    begun = time.perf_counter()
    values = makers[library, what](int(dimensions), int(rows))
    seconds = time.perf_counter() - begun
    first = values[:4096]
    if not (0.0 <= float(first.min()) and float(first.max()) <= 1.0):
        print("values outside [0, 1]", flush=True)
    elif abs(float(first.mean()) - 0.5) > 0.02:
        print("a mean that is not 1/2", flush=True)
    else:
        print(seconds, flush=True)
