#!/bin/bash
# A sweep or a search in shards by GNU parallel, on one machine or on several that share a folder (--sshloginfile names them).
# Called again after a stop it goes on: shards that are finished take no time.
#
#   ASK="sweep V8-crossplane --bank-angle 0..179.9982:0.0018" ./parallel.sh points.csv
#   ASK="search --cylinders 18 --cycle two-stroke" ./parallel.sh front.csv
set -euo pipefail
: "${CRANKSTAR:=crankstar}" "${SHARDS:=24}" "${JOBS:=100%}"
# What is asked, with its command.
: "${ASK:=sweep V8-crossplane --bank-angle 0..179.9982:0.0018 --orders 1,2,4,6}"
mkdir -p shards
# A process for each core, and a thread for each process. A shard that fails, or is killed, is tried three times.
seq "$SHARDS" | parallel --jobs "$JOBS" --retries 3 --halt soon,fail=1 \
    "$CRANKSTAR $ASK --threads 1 --shard {}/$SHARDS --output shards/{}.shard"
# shellcheck disable=SC2086 # several words on purpose
exec "$CRANKSTAR" $ASK --format csv --output "$1" --merge shards/*.shard
