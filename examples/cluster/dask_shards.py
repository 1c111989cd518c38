"""A sweep or a search in shards on the workers of Dask, into a folder that all of them see.

    dask scheduler &  dask worker tcp://127.0.0.1:8786 --nworkers 2 --nthreads 1 &
    python dask_shards.py tcp://127.0.0.1:8786 shards points.csv 24 sweep V8-crossplane --bank-angle 0..179.9982:0.0018

A worker that dies loses the piece at work: its program dies with it (on Linux), Dask gives its shard to another one, which goes on with the file.
Where the program of a dead worker still writes the file, the next one waits for it. A worker has as many programs as it has threads, and each
program runs on one thread.
"""

import ctypes
import os
import signal
import subprocess
import sys
import time

from dask.distributed import Client, as_completed

PROGRAM = os.environ.get("CRANKSTAR", "crankstar")
HELD = "is being written by another process"


def die_with(parent):
    """Has the program killed when its parent ends, however that ends. Runs in the program before it is one."""
    set_parent_death_signal = 1
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)
        if os.getppid() != parent:
            os.kill(os.getpid(), signal.SIGKILL)


def compute(number, of, folder, ask):
    """Computes one shard, and says who did."""
    file = os.path.join(folder, f"{number}.shard")
    command = [PROGRAM, *ask, "--threads", "1", "--shard", f"{number}/{of}", "--output", file]
    worker = os.getpid()
    while True:
        done = subprocess.run(command, capture_output=True, text=True, preexec_fn=lambda: die_with(worker))
        if done.returncode == 0:
            return file, worker
        if HELD not in done.stderr:
            raise RuntimeError(done.stderr.strip())
        time.sleep(1)


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
