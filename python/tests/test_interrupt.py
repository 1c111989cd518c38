"""Does an interrupt from the keyboard stop what takes long, at once?"""

import os
import signal
import subprocess
import sys
import time

import pytest

LONG = {
    "search": "crankstar.search(18, 'two-stroke', threads=1)",
    "sweep": "crankstar.Engine.named('V8-crossplane').sweep(bank_angle='0..179.998:0.002', orders=range(1, 41))",
}

SCRIPT = """
import sys, threading, time
import crankstar
told = threading.Timer(0.5, lambda: print("works", flush=True))
told.daemon = True
told.start()
try:
    {call}
except KeyboardInterrupt:
    print("stopped", time.time(), flush=True)
    sys.exit(3)
print("ended")
"""


@pytest.mark.skipif(os.name != "posix", reason="signals")
@pytest.mark.parametrize("what", LONG)
def test_an_interrupt_is_raised_within_half_a_second(what: str):
    script = SCRIPT.format(call=LONG[what])
    with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "works\n"
        sent = time.time()
        child.send_signal(signal.SIGINT)
        word, at = child.stdout.readline().split()
        assert word == "stopped" and float(at) - sent < 0.5
        assert child.wait(timeout=30) == 3
