"""A sweep or a search in shards on the workers of Dask, into a folder that all of them see.

    dask scheduler &  dask worker tcp://127.0.0.1:8786 --nworkers 2 --nthreads 1 &
    python dask_shards.py tcp://127.0.0.1:8786 shards points.csv 24 sweep V8-crossplane --bank-angle 0..179.9982:0.0018

A worker that dies loses the piece at work: Dask gives its shard to another one, which goes on with the file.
"""

import os
import subprocess
import sys

from dask.distributed import Client, as_completed

PROGRAM = os.environ.get("CRANKSTAR", "crankstar")


def compute(number, of, folder, ask):
    """Computes one shard, and tells who did."""
    file = os.path.join(folder, f"{number}.shard")
    command = [PROGRAM, *ask, "--shard", f"{number}/{of}", "--output", file]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stderr.strip())
    return file, os.getpid()


def main():
    scheduler, folder, table, of, *ask = sys.argv[1:]
    folder = os.path.abspath(folder)
    os.makedirs(folder, exist_ok=True)
    with Client(scheduler) as client:
        tasks = [
            client.submit(compute, number, int(of), folder, ask, pure=False, retries=3)
            for number in range(1, int(of) + 1)
        ]
        files = []
        for _, (file, worker) in as_completed(tasks, with_results=True):
            files.append(file)
            print(f"{len(files)} of {of}: {os.path.basename(file)} by process {worker}", flush=True)
    command = [PROGRAM, *ask, "--format", "csv", "--output", table, "--merge", *files]
    subprocess.run(command, check=True)


if __name__ == "__main__":
    main()
