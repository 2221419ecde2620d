#!/usr/bin/env python3
"""Fills a Zarr store by the workers of a Dask cluster, and checks it against a single run.

    pip install dask distributed zarr
    cargo build --release
    python3 examples/dask_generate.py --workers 2 --count 16777216 --out store.zarr
    python3 examples/dask_generate.py --workers 4 --device 0 --device 1 --count 1073741824 \\
        --out store.zarr -- --scramble owen --seed 3

Each task is one `corput generate --shard I/N` on one worker, which holds one device; tasks of
workers that die, and tasks that fail, run again, which is safe. What corput refuses ends all.
Words after `--` go to `corput generate`.

Local workers hold the GPUs in turn, the fastest kind first. Where there is none, worker 0 has the
first driver that runs on the CPU, as lavapipe, worker 1 the reference (`cpu`), and so on: the
bytes are the same. CORPUT_DEVICE is the device of all, and --device names others.

With --scheduler the workers are those of a cluster that runs already, of one thread each. All of
its machines need corput and this folder at the same paths, and CORPUT_DEVICE of each worker is
its device.
"""

import hashlib
import subprocess
import sys

import cluster
import zarr


def single(command):
    """SHA-256 of the same points by one process on the CPU, which keeps no file of them."""
    command = [*command, "--device", "cpu", "--format", "raw", "--out", "-"]
    digest = hashlib.sha256()
    with subprocess.Popen(command, stdout=subprocess.PIPE) as process:
        while block := process.stdout.read(1 << 22):
            digest.update(block)
    if process.returncode != 0:
        sys.exit(f"the single run ended with {process.returncode}")
    return digest.hexdigest()


def stored(path):
    """SHA-256 of the array as zarr-python reads it, chunk after chunk."""
    array = zarr.open_array(path, mode="r")
    digest = hashlib.sha256()
    rows = array.chunks[0]
    for first in range(0, array.shape[0], rows):
        digest.update(array[first : first + rows].tobytes())
    print(f"{path}: {array.shape} {array.dtype}, chunks of {array.chunks}")
    return digest.hexdigest()


def main():
    parser = cluster.options(__doc__)
    parser.add_argument("--sequence", default="sobol")
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--dims", type=int, default=2)
    args = parser.parse_args()
    command = [cluster.program(args.corput), "generate", args.sequence]
    command += ["--count", str(args.count), "--dims", str(args.dims), *args.more]
    cluster.run(args, [*command, "--out", args.out])
    found = stored(args.out)
    if not args.no_single:
        cluster.compare("store", found, single(command))


if __name__ == "__main__":
    main()
