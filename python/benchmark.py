"""How long do 10,000 V8s take: crankstar's sweep, and a sum of phasors in NumPy over the same angles, in one run?

Both are asked for the rotating vectors of force and moment of orders 1, 2, 4 and 6 of a cross-plane V8, at 10,000 bank angles.
The sum has the length of each vector in floats, and no more; the sweep decides of each whether it is exactly zero, finds the exact angles at
which it is, and has ellipses, firing intervals, counterweights and envelope besides.
"""

import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

import crankstar

COUNT = 10_000
STEP = "0.018"  # of 180 degrees
ORDERS = (1, 2, 4, 6)
THROWS = np.radians([0, 90, 270, 180])
ARMS = np.array([1.5, 0.5, -0.5, -1.5])


def with_numpy() -> dict[str, NDArray[np.float64]]:
    """The lengths ½|P| of the direct and the reverse vectors."""
    half = np.radians(np.arange(COUNT) * float(STEP))[:, None] / 2
    lengths = {}
    for order in ORDERS:
        for name, sense in (("direct", 1), ("reverse", -1)):
            # Of cylinder j: k β − (k − 1) α turning with the crank, −k β + (k + 1) α against it.
            vectors = np.zeros((COUNT, len(THROWS)), dtype=complex)
            for side in (-1, 1):
                vectors += np.exp(1j * (sense * order * THROWS + (1 - sense * order) * side * half))
            lengths[f"force_{order}_{name}"] = np.abs(vectors.sum(axis=1)) / 2
            lengths[f"moment_{order}_{name}"] = np.abs((vectors * ARMS).sum(axis=1)) / 2
    return lengths


def with_crankstar() -> crankstar.Answer:
    engine = crankstar.Engine("V8", vee={"bank_angle": 90, "throws": [0, 90, 270, 180]})
    last = f"{(COUNT - 1) * float(STEP):.3f}"
    return engine.sweep(bank_angle=f"0..{last}:{STEP}", orders=ORDERS)


def best_of(runs: int, work: Callable[[], object]) -> float:
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def main() -> None:
    lengths, sweep = with_numpy(), with_crankstar()
    columns = sweep.columns
    apart = max(float(np.abs(lengths[name] - columns[name]).max()) for name in lengths)
    proved = sum(int(np.sum(columns[f"{name}_vanishes"])) for name in lengths)
    below = {size: sum(int((values < size).sum()) for values in lengths.values()) for size in (1e-9, 1e-15)}
    print(f"{COUNT} V8s, {len(lengths)} vectors each; the lengths differ by {apart:.1e} at most")
    print(f"crankstar proves {proved} of them to be zero; NumPy has {below[1e-9]} below 1e-9, {below[1e-15]} below 1e-15")
    print(f"NumPy, a sum of phasors   {best_of(5, with_numpy) * 1000:8.0f} ms")
    print(f"crankstar, the sweep      {best_of(5, with_crankstar) * 1000:8.0f} ms")
    print(f"its columns as arrays     {best_of(5, lambda: sweep.columns) * 1000:8.0f} ms")


if __name__ == "__main__":
    main()
