#!/usr/bin/env python3
"""Measures a study by the workers of a Dask cluster, and checks it against a single run.

    pip install dask distributed
    cargo build --release
    python3 examples/dask_converge.py --workers 2 --out study -- --integrand x-squared --max-count 4096
    python3 examples/dask_converge.py --workers 4 --out study --no-single -- --study docs/study.toml

Each task is one `corput converge --shard I/N`; words after `--` go to `corput converge`, and without
any its default study is measured. A task that runs again goes on from the cells that were kept.
`corput merge` then writes the report. Errors, slopes and their intervals are exact, and are compared
with those of a single run on the CPU, by a hash; times are each worker's own.

Workers and devices are as in dask_generate.py, but that local workers hold devices of one name
alone, since a report compares no times of others. Workers that share a device slow each other down:
where times matter, let there be one worker for each.
"""

import hashlib
import json
import subprocess
import sys
from pathlib import Path

import cluster

# Members of results.json that tell of machines, and of how the study was run.
OWN = ("command", "device", "files", "shards", "standings")
TIMES = ("setup_ms", "first_dispatch_ms", "seconds", "host_seconds")


def errors(value):
    """What of a document is the same on all machines."""
    if isinstance(value, dict):
        kept = (name for name in value if name not in OWN + TIMES)
        return {name: errors(value[name]) for name in kept}
    return [errors(one) for one in value] if isinstance(value, list) else value


def digest(text):
    """SHA-256 of that."""
    text = json.dumps(errors(json.loads(text)), sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def single(command):
    """The document of the same study by one process on the CPU."""
    done = subprocess.run([*command, "--device", "cpu", "--json"], stdout=subprocess.PIPE)
    if done.returncode != 0:
        sys.exit(f"the single run ended with {done.returncode}")
    return done.stdout


def main():
    args = cluster.options(__doc__).parse_args()
    command = [cluster.program(args.corput), "converge", *args.more]
    cluster.run(args, [*command, "--report", args.out], alike=True)
    if not args.no_single:
        found = Path(args.out, "results.json").read_text()
        cluster.compare("study", digest(found), digest(single(command)))


if __name__ == "__main__":
    main()
