"""Is the lock of the interpreter released while the program works?"""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import crankstar
from crankstar import Engine


def timed_search(cylinders: int) -> float:
    start = time.perf_counter()
    crankstar.search(cylinders, "two-stroke", threads=1)
    return time.perf_counter() - start


def test_another_thread_goes_on_while_one_searches():
    # The smallest search that takes long enough to tell, whichever machine this is.
    cylinders = next(count for count in range(10, 17) if timed_search(count) > 0.3)
    took: list[float] = []
    worker = threading.Thread(target=lambda: took.append(timed_search(cylinders)))
    longest, last = 0.0, time.perf_counter()
    worker.start()
    while worker.is_alive():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    worker.join()
    # Were the lock held, this thread would stand still as long as the search takes.
    assert longest < took[0] / 2


def test_one_engine_is_asked_from_many_threads():
    engine = Engine.named("V8-crossplane")
    alone = engine.classify(range(1, 41)).json
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda _: engine.classify(range(1, 41)).json, range(32)))
    assert answers == [alone] * 32
