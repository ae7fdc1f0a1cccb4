#!/bin/sh
# Draws a scenario in shards by GNU parallel and joins them. From the root of the repository:
#   docs/shards/parallel.sh scenarios/first-light.toml 7 2
# draws seven shards, two at a time, one thread each, and joins them in runs/first-light. A shard that fails is tried three times;
# the same command again goes on where it was interrupted. LUNOID names the program if it is not on the path.
set -eu
scenario=$1
shards=$2
at_once=$3
lunoid=${LUNOID:-lunoid}
out=runs/$(basename "$scenario" .toml)

seq "$shards" | parallel --will-cite --halt soon,fail=1 --retries 3 --jobs "$at_once" \
    "$lunoid" replay "$scenario" --shard "{}/$shards" --out "$out-shard-{}-of-$shards" --jobs 1 --quiet
"$lunoid" merge "$out"-shard-*-of-"$shards" --out "$out"
