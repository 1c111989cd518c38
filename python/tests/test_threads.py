"""Is the lock of the interpreter released while the program works?"""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import crankstar
from crankstar import Engine


def test_another_thread_goes_on_while_one_searches():
    took = []

    def work():
        start = time.perf_counter()
        crankstar.search(9, "two-stroke", threads=1)
        took.append(time.perf_counter() - start)

    worker = threading.Thread(target=work)
    longest, last = 0.0, time.perf_counter()
    worker.start()
    while worker.is_alive():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    worker.join()
    # Were the lock held, this thread would stand still as long as the search takes.
    assert took[0] > 0.1, "too short to tell"
    assert longest < took[0] / 2


def test_one_engine_is_asked_from_many_threads():
    engine = Engine.named("V8-crossplane")
    alone = engine.classify(range(1, 41)).json
    with ThreadPoolExecutor(8) as pool:
        answers = list(pool.map(lambda _: engine.classify(range(1, 41)).json, range(32)))
    assert answers == [alone] * 32
