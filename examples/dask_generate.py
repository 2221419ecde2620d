#!/usr/bin/env python3
"""Fills a Zarr store by the workers of a Dask cluster, and checks it against a single run.

    pip install dask distributed zarr
    cargo build --release
    python3 examples/dask_generate.py --workers 2 --count 16777216 --out store.zarr
    python3 examples/dask_generate.py --workers 4 --device 0 --device 1 --count 1073741824 \\
        --out store.zarr -- --scramble owen --seed 3

Each task is one `corput generate --shard I/N` on one worker, which holds one device; tasks of
workers that die run again elsewhere, which is safe. Words after `--` go to `corput generate`.

With --scheduler the workers are those of a cluster that runs already. All of its machines need
corput and the store's folder at the same paths, and CORPUT_DEVICE of each worker is its device.
"""

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

from dask.distributed import Client, LocalCluster, as_completed, get_worker
import zarr


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--workers", type=int, default=2, help="local processes")
    parser.add_argument("--scheduler", help="address of a cluster, in place of local processes")
    parser.add_argument("--shards", type=int, help="tasks [default: four a worker]")
    parser.add_argument("--retries", type=int, default=3, help="of a task that fails")
    parser.add_argument("--sequence", default="sobol")
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--dims", type=int, default=2)
    parser.add_argument("--device", action="append", help="of local worker 0, 1, ... in turn [default: cpu]")
    parser.add_argument("--corput", help="the program [default: in PATH, or target/release/corput]")
    parser.add_argument("--out", required=True, help="the store's folder")
    parser.add_argument("more", nargs="*", help="after --: further words for corput generate")
    return parser.parse_args()


def program(given):
    """The path of corput."""
    built = Path(__file__).resolve().parent.parent / "target/release/corput"
    found = given or shutil.which("corput") or (str(built) if built.exists() else None)
    if found is None:
        sys.exit("corput is not in PATH: build it with `cargo build --release`, or give --corput")
    return os.path.abspath(found)


def fill(command, store, shard, devices):
    """One task: makes the chunks of a shard on this worker's device."""
    name = get_worker().name
    device = ["--device", devices[int(name) % len(devices)]] if devices else []
    done = subprocess.run(
        [*command, *device, "--out", store, "--shard", shard],
        capture_output=True,
        text=True,
    )
    if done.returncode != 0:
        raise RuntimeError(f"shard {shard}: {done.stderr.strip()}")
    return shard, name


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
    args = arguments()
    corput = program(args.corput)
    store = os.path.abspath(args.out)
    shards = args.shards or 4 * args.workers
    command = [corput, "generate", args.sequence, "--count", str(args.count)]
    command += ["--dims", str(args.dims), *args.more]

    if args.scheduler:
        cluster, devices = args.scheduler, []
    else:
        devices = args.device or ["cpu"]
        cluster = LocalCluster(
            n_workers=args.workers, threads_per_worker=1, dashboard_address=None
        )
    with Client(cluster) as client:
        tasks = [
            client.submit(
                fill,
                command,
                store,
                f"{index}/{shards}",
                devices,
                retries=args.retries,
                pure=False,
            )
            for index in range(shards)
        ]
        for done in as_completed(tasks):
            shard, worker = done.result()
            print(f"shard {shard} by worker {worker}")
    if not args.scheduler:
        cluster.close()

    # Exits with 1, and names the shards that are missing, where any are.
    subprocess.run([corput, "merge", store, "--shards", str(shards)], check=True)
    found, wanted = stored(store), single(command)
    print(f"store       {found}\nsingle run  {wanted}")
    if found != wanted:
        sys.exit("the store is not what a single run makes")
    print("equal")


if __name__ == "__main__":
    main()
