#!/bin/sh
#SBATCH --job-name=lunoid
#SBATCH --array=1-7
#SBATCH --cpus-per-task=1
#SBATCH --requeue
# Draws a scenario in a Slurm array, one shard a task. From the root of the repository, on a file system that all nodes see:
#   sbatch docs/shards/slurm.sh scenarios/first-light.toml
# Another number of shards, and the third of them alone once more:
#   sbatch --array=1-40 docs/shards/slurm.sh scenarios/first-light.toml
#   LUNOID_SHARDS=40 sbatch --array=3 docs/shards/slurm.sh scenarios/first-light.toml
# Afterwards docs/shards/slurm-merge.sh joins them. A task that is queued again goes on where it was interrupted. LUNOID names the
# program if it is not on the path.
set -eu
exec "${LUNOID:-lunoid}" replay "$1" --shard auto --jobs "${SLURM_CPUS_PER_TASK:-1}" --no-progress
