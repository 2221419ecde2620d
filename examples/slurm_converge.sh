#!/usr/bin/env bash
#SBATCH --job-name=corput-study
#SBATCH --array=0-7
#SBATCH --ntasks=1
#SBATCH --exclusive
#SBATCH --requeue
#
# Measures a study by a Slurm job array: task I measures the cells I, I + N, I + 2 N, ... of it.
# Whatever follows the script goes to `corput converge`:
#
#   sbatch --parsable examples/slurm_converge.sh --study docs/study.toml --report study
#   sbatch --dependency=afterok:JOB --wrap 'corput merge study'
#
# Tasks may run in any order, at once, and again: they go on from the cells that they kept. If the
# merge names shards that are missing, run those alone, with all else as it was:
#
#   sbatch --array=3,5 examples/slurm_converge.sh --study docs/study.toml --report study
#
# N is CORPUT_SHARDS, 8 by default; another one needs the array to match, as
# `CORPUT_SHARDS=64 sbatch --array=0-63 ...`. The folder must be on a file system that all nodes
# share, and paths count from where sbatch runs. CORPUT is the program, CORPUT_DEVICE its device;
# `cpu` is the reference, without which a node needs a Vulkan driver. Errors do not depend on it.
# Times do: the report compares those of one device's name and driver alone, and `--exclusive`
# keeps others off the node meanwhile.
set -euo pipefail

: "${SLURM_ARRAY_TASK_ID:?run this by sbatch --array=0-7, or set it to the shard}"
exec "${CORPUT:-corput}" converge "$@" --shard "$SLURM_ARRAY_TASK_ID/${CORPUT_SHARDS:-8}"
