#!/bin/bash
# Does a sweep on Dask lose a run when a worker is killed at work? Two workers on this machine, one of which is killed with its nanny.
#
#   CRANKSTAR=target/release/crankstar examples/cluster/test-dask.sh
#
# Needs Python with dask[distributed]; where that or the program is missing it says so and ends with 0.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
CRANKSTAR=$(command -v "${CRANKSTAR:-crankstar}") || { echo "skipped: no crankstar; name it by CRANKSTAR=…"; exit 0; }
CRANKSTAR=$(realpath "$CRANKSTAR")
export CRANKSTAR
: "${PYTHON:=python3}" "${LAST:=179.9982}" "${SHARDS:=6}"
"$PYTHON" -c 'import dask.distributed' 2> /dev/null || { echo "skipped: no dask (pip install 'dask[distributed]')"; exit 0; }
work=$(mktemp -d)
pids=()
clean() {
    for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
    wait 2> /dev/null || true
    rm -rf "$work"
}
trap clean EXIT
cd "$work"
"$PYTHON" -m distributed.cli.dask_scheduler --host 127.0.0.1 --port 0 --no-dashboard --scheduler-file scheduler.json > scheduler.log 2>&1 &
pids+=($!)
for _ in $(seq 120); do [ -s scheduler.json ] && break; sleep 0.5; done
address=$("$PYTHON" -c 'import json; print(json.load(open("scheduler.json"))["address"])')
workers=()
for name in 1 2; do
    "$PYTHON" -m distributed.cli.dask_worker "$address" --nthreads 1 --no-nanny --no-dashboard > "worker-$name.log" 2>&1 &
    workers+=($!)
    pids+=($!)
done
ask=(sweep V8-crossplane --bank-angle "0..$LAST:0.0018" --orders "1,2,4,6")
"$PYTHON" "$here/dask_shards.py" "$address" shards merged.csv "$SHARDS" "${ask[@]}" > run.log 2>&1 &
run=$!
pids+=($run)
killed=
for _ in $(seq 1200); do
    for worker in "${workers[@]}"; do
        child=$(ps -o pid= --ppid "$worker" 2> /dev/null | tr -d ' ' | head -n 1 || true)
        [ -n "$child" ] || continue
        grep -q -- "--shard" "/proc/$child/cmdline" 2> /dev/null || continue
        threads=$(find "/proc/$child/task" -mindepth 1 -maxdepth 1 2> /dev/null | wc -l)
        # One thread computes, beside the one that takes.
        [ "$threads" -le 2 ] || { echo "the program of one worker runs $threads threads"; exit 1; }
        kill -KILL "$worker"
        killed=$worker
        break 2
    done
    sleep 0.1
done
[ -n "$killed" ] || { echo "no worker was killed: the job was over too soon"; cat run.log; exit 1; }
for _ in $(seq 50); do
    [ ! -e "/proc/$child" ] || grep -q "^State:.*Z" "/proc/$child/status" 2> /dev/null && break
    sleep 0.1
done
if [ -e "/proc/$child" ] && ! grep -q "^State:.*Z" "/proc/$child/status"; then echo "the program outlived its worker"; exit 1; fi
wait "$run" || { cat run.log; exit 1; }
"$CRANKSTAR" "${ask[@]}" --format csv --output one.csv > one.log
cmp merged.csv one.csv
echo "nothing is lost: $SHARDS shards, $(wc -l < merged.csv) lines, a worker killed at work; byte for byte what one run gives"
