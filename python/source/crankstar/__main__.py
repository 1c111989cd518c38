"""The command `crankstar`, and `python -m crankstar`: the program, which is in the module, answers in this process."""

import signal
import sys

from ._crankstar import _program  # type: ignore[import-not-found]


def main() -> int:
    """Answers the command line; returns the exit status."""
    if sys.stdout is None:
        if sys.stderr is not None:
            print("error: cannot write to standard output: it is closed", file=sys.stderr)
        return 1
    # Ctrl-C ends it at once, as it ends the program without Python.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _program(["crankstar", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
