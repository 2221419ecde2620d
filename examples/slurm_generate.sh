#!/usr/bin/env bash
#SBATCH --job-name=corput
#SBATCH --array=0-7
#SBATCH --ntasks=1
#SBATCH --requeue
#
# Fills a Zarr store by a Slurm job array: task I makes shard I/N of it. Whatever follows the
# script goes to `corput generate`:
#
#   sbatch --parsable examples/slurm_generate.sh sobol --count 1073741824 --dims 2 --out store.zarr
#   sbatch --dependency=afterok:JOB --wrap 'corput merge store.zarr'
#
# Tasks may run in any order, at once, and again: chunks that are there and whole are kept. If the
# merge names shards that are missing, run those alone, which leaves N as it is:
#
#   sbatch --array=3,5 examples/slurm_generate.sh sobol --count 1073741824 --dims 2 --out store.zarr
#
# N is CORPUT_SHARDS, 8 by default; another one needs the array to match, as
# `CORPUT_SHARDS=64 sbatch --array=0-63 ...`. SLURM_ARRAY_TASK_COUNT would be wrong for a part of
# the array. The folder of the store must be on a file system that all nodes share. CORPUT is the
# program, CORPUT_DEVICE its device; with `--gres=gpu:1` in the lines above, each task sees one.
set -euo pipefail

: "${SLURM_ARRAY_TASK_ID:?run this by sbatch --array=0-7, or set it to the shard}"
exec "${CORPUT:-corput}" generate "$@" --shard "$SLURM_ARRAY_TASK_ID/${CORPUT_SHARDS:-8}"
