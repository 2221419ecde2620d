"""Shards of a corput command as tasks of a Dask cluster: what dask_generate.py and dask_converge.py share."""

import argparse
import json
import logging
import os
import shutil
import subprocess
import sys
import time
from contextlib import nullcontext
from pathlib import Path

from dask.distributed import Client, LocalCluster, as_completed, get_worker

# Kinds of `corput devices`, the fastest first.
GPUS = ("discrete", "integrated", "virtual")

# Exit codes of arguments that cannot be or a folder that holds something else, and of no device.
REFUSED = (2, 3)


# Times, a second apart, that a task asks for a shard that another process holds.
WAITS = 600


def options(text):
    """The options of both, under the first line of a text."""
    parser = argparse.ArgumentParser(description=text.splitlines()[0])
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--scheduler", help="address of a cluster, in place of local processes")
    where.add_argument(
        "--device",
        action="append",
        help="of local worker 0, 1, ... in turn [default: GPUs, or else what runs on the CPU]",
    )
    parser.add_argument("--workers", type=int, default=2, help="local processes")
    parser.add_argument("--shards", type=int, help="tasks [default: four a worker]")
    parser.add_argument("--retries", type=int, default=3, help="of a task that fails")
    parser.add_argument("--no-single", action="store_true", help="compare with no single run")
    parser.add_argument("--corput", help="the program [default: in PATH, or target/release/corput]")
    parser.add_argument("--out", required=True, help="the folder")
    parser.add_argument("more", nargs="*", help="after --: further words for corput")
    return parser


def program(given):
    """The path of corput."""
    built = Path(__file__).resolve().parent.parent / "target/release/corput"
    found = given or shutil.which("corput") or (str(built) if built.exists() else None)
    if found is None:
        sys.exit("corput is not in PATH: build it with `cargo build --release`, or give --corput")
    return os.path.abspath(found)


def devices(corput, alike):
    """What local workers hold in turn: GPUs; without one a driver of the CPU, and `cpu`; without
    that `cpu`. Of them those that are like the first, where times are to be compared."""
    if os.environ.get("CORPUT_DEVICE"):
        return []
    asked = subprocess.run([corput, "devices", "--json"], capture_output=True, text=True)
    listed = json.loads(asked.stdout)["devices"] if asked.returncode == 0 else []
    # Points and estimates are tier I throughout: on others they may be other bits.
    exact = [device for device in listed if device["probe"].get("tier_i")]
    gpus = [device for kind in GPUS for device in exact if device["kind"] == kind]
    held = gpus or exact[:1]
    held = [one for one in held if not alike or one["name"] == held[0]["name"]]
    names = [str(one["index"]) for one in held]
    return names if gpus or (names and alike) else [*names, "cpu"]


def work(command, folder, shard, held):
    """One task: a shard on the device of this worker. That it is refused is a result, since no
    further try would change it."""
    worker = get_worker().name
    device = held[int(worker) % len(held)] if held else os.environ.get("CORPUT_DEVICE")
    line = [*command, "--shard", shard, *(["--device", device] if device else [])]
    for _ in range(WAITS):
        done = subprocess.run(line, cwd=folder, capture_output=True, text=True)
        # The process of a worker that was killed may live on, and holds the cells of its shard.
        if "another run is writing this file" not in done.stderr:
            break
        time.sleep(1)
    said = done.stderr.strip()
    if done.returncode not in (0, *REFUSED):
        raise RuntimeError(said or f"corput ended with {done.returncode}")
    name = f"shard {shard} by worker {worker} on device {device or 'of its choice'}"
    return name, said, done.returncode


def run(args, command, alike=False):
    """Runs all shards of a command, then the merge, which names what is missing."""
    corput, held = command[0], []
    if args.scheduler:
        local = nullcontext(args.scheduler)
    else:
        held = args.device or devices(corput, alike)
        local = LocalCluster(
            n_workers=args.workers,
            threads_per_worker=1,
            dashboard_address=None,
            # Warnings are of workers that end in the middle of a task.
            silence_logs=logging.ERROR,
        )
    with local as cluster, Client(cluster) as client:
        if args.scheduler:
            # Other machines have no copy of this file.
            client.upload_file(__file__)
        shards = args.shards or 4 * len(client.nthreads())
        tasks = {}
        for shard in (f"{index}/{shards}" for index in range(shards)):
            given = (command, os.getcwd(), shard, held)
            tasks[client.submit(work, *given, retries=args.retries, pure=False)] = shard
        for task in as_completed(tasks):
            try:
                name, said, code = task.result()
            # Whatever the last try met, or KilledWorker where each took its worker with it.
            except Exception as error:
                sys.exit(f"shard {tasks[task]} failed: {error}")
            if code != 0:
                sys.exit(f"{name} was refused: {said}")
            print("\n".join(filter(None, [name, said])), flush=True)
            # One that is done is not to run again where its worker dies later.
            task.release()
    merged = subprocess.run([corput, "merge", args.out, "--shards", str(shards)])
    if merged.returncode != 0:
        sys.exit(merged.returncode)


def compare(what, found, wanted):
    """Ends with an error where two hashes differ."""
    print(f"{what:<12}{found}\nsingle run  {wanted}")
    if found != wanted:
        sys.exit(f"the {what} is not what a single run makes")
    print("equal")
