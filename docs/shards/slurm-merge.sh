#!/bin/sh
#SBATCH --job-name=lunoid-merge
# Joins what docs/shards/slurm.sh drew. 123 is the number of its job:
#   sbatch --dependency=afterok:123 docs/shards/slurm-merge.sh scenarios/first-light.toml 7
set -eu
out=runs/$(basename "$1" .toml)
exec "${LUNOID:-lunoid}" merge "$out"-shard-*-of-"$2" --out "$out" --no-progress
