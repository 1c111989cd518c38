#!/bin/bash
# Does an array job of Slurm lose a shard when a node is killed? Three nodes on this machine, one of which is killed while it works.
#
#   CRANKSTAR=target/release/crankstar examples/cluster/test-slurm.sh
#
# Needs root and Debian's slurmctld, slurmd, slurm-client and munge; where they are missing it says so and ends with 0.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
CRANKSTAR=$(command -v "${CRANKSTAR:-crankstar}") || { echo "skipped: no crankstar; name it by CRANKSTAR=…"; exit 0; }
CRANKSTAR=$(realpath "$CRANKSTAR")
for program in slurmctld slurmd munged sbatch squeue scancel; do
    command -v "$program" > /dev/null || { echo "skipped: $program is not installed (apt-get install slurmctld slurmd slurm-client munge)"; exit 0; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: Slurm's daemons are started by root"; exit 0; }
work=$(mktemp -d)
pids=()
clean() {
    [ -n "${job:-}" ] && scancel "$job" 2> /dev/null || true
    for pid in "${pids[@]}"; do kill "$pid" 2> /dev/null || true; done
    wait 2> /dev/null || true
    rm -rf "$work"
}
trap clean EXIT
mkdir -p "$work/state" "$work/job" /run/munge
sed -e "s|@WORK@|$work|; s|@HOST@|$(hostname -s)|; s|@CPUS@|$(nproc)|" "$here/slurm.conf.in" > "$work/slurm.conf"
export SLURM_CONF="$work/slurm.conf"
if ! munge -n > /dev/null 2>&1; then
    chown munge: /run/munge
    # In the foreground, so that it ends with this script.
    setpriv --reuid munge --regid munge --clear-groups munged --foreground > "$work/munged.log" 2>&1 &
    pids+=($!)
    sleep 1
fi
slurmctld -D > "$work/ctld.out" 2>&1 &
pids+=($!)
declare -A node
for name in n1 n2 n3; do
    slurmd -D -N "$name" > "$work/$name.out" 2>&1 &
    node[$name]=$!
    pids+=($!)
done
for _ in $(seq 60); do
    [ "$(sinfo -h -t idle -o %D 2> /dev/null || true)" = 3 ] && break
    sleep 1
done
[ "$(sinfo -h -t idle -o %D)" = 3 ] || { echo "the nodes do not come up:"; tail -5 "$work"/*.log "$work"/*.out; exit 1; }
cd "$work/job"
export CRANKSTAR SHARDS=12 ASK="sweep V8-crossplane --bank-angle 0..${LAST:-179.9982}:0.0018 --orders 1,2,4,6"
job=$(sbatch --parsable --array=1-12 "$here/slurm-array.sh")
killed=
while [ -n "$(squeue -h -j "$job" -o %i)" ]; do
    if [ -z "$killed" ]; then
        busy=$(squeue -h -j "$job" -t R -o "%N" | grep -m 1 -E '^n[123]$' || true)
        if [ -n "$busy" ] && ls shards/*.shard > /dev/null 2>&1; then
            # The node, the keepers of its tasks and the tasks, at once, as a machine whose power fails: processes of this test alone,
            # known by its folder in their surroundings.
            tasks=() keepers=()
            for surroundings in /proc/[0-9]*/environ; do
                text=$(tr '\0' '\n' < "$surroundings" 2> /dev/null || true)
                grep -qx "SLURM_CONF=$SLURM_CONF" <<< "$text" && grep -qx "SLURMD_NODENAME=$busy" <<< "$text" || continue
                task=${surroundings#/proc/} task=${task%/environ}
                tasks+=("$task")
                parent=$(ps -o ppid= -p "$task" | tr -d ' ' || true)
                [ "$(cat "/proc/$parent/comm" 2> /dev/null)" = slurmstepd ] && keepers+=("$parent")
            done
            [ ${#tasks[@]} -gt 0 ] || continue
            kill -KILL "${node[$busy]}" "${keepers[@]}" "${tasks[@]}" 2> /dev/null || true
            killed=$busy
            echo "killed node $busy"
        fi
    fi
    sleep 0.2
done
[ -n "$killed" ] || { echo "no node was killed: the job was over too soon"; tail -n 3 log-*.txt; exit 1; }
restarts=$(cat log-*.txt | grep -c "restart [1-9]" || true)
# shellcheck disable=SC2086 # several words on purpose
"$CRANKSTAR" $ASK --format csv --output merged.csv --merge shards/*.shard
# shellcheck disable=SC2086
"$CRANKSTAR" $ASK --format csv --output one.csv
cmp merged.csv one.csv
echo "nothing is lost: 12 shards, $(wc -l < merged.csv) lines, node $killed killed, $restarts shards started again; byte for byte what one run gives"
