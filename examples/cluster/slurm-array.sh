#!/bin/bash
# A sweep or a search in 24 shards, as an array job of Slurm. Submit it from a folder that all nodes see:
#
#   sbatch slurm-array.sh
#
# A shard whose node dies is put into the queue again and goes on with the pieces that its file holds; a shard that is
# called a second time computes what is missing, and nothing else. When all have ended:
#
#   crankstar $ASK --format csv --output points.csv --merge shards/*.shard
#
#SBATCH --job-name=crankstar
#SBATCH --array=1-24
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=log-%a.txt
set -euo pipefail
: "${CRANKSTAR:=crankstar}" "${SHARDS:=24}"
# What is asked, with its command; a search too: "search --cylinders 18 --cycle two-stroke".
: "${ASK:=sweep V8-crossplane --bank-angle 0..179.99982:0.00018 --orders 1,2,4,6}"
mkdir -p shards
echo "shard $SLURM_ARRAY_TASK_ID on ${SLURMD_NODENAME:-?}, restart ${SLURM_RESTART_COUNT:-0}"
# shellcheck disable=SC2086 # several words on purpose
exec "$CRANKSTAR" $ASK --threads "${SLURM_CPUS_PER_TASK:-1}" --shard "$SLURM_ARRAY_TASK_ID/$SHARDS" --output "shards/$SLURM_ARRAY_TASK_ID.shard"
