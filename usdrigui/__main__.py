"""``python -m usdrigui`` and the command `usdrigui`: signals are heeded before anything else is loaded."""

from __future__ import annotations

import os
import signal
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any


def main() -> int:
    """Run the command line of this process; returns the exit code."""
    early: list[Any] = []
    tell = early.append
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:  # as under nohup
            signal.signal(number, lambda *_: tell("stop"))
    _keep_standard_streams()
    from queue import SimpleQueue

    events: SimpleQueue[Any] = SimpleQueue()
    tell = events.put
    for each in early:
        tell(each)
    from usdrigui.cli.supervised import run

    return run(sys.argv[1:], events)


def _keep_standard_streams() -> None:
    """A stream that the shell has closed leaves its number to the next file that is opened: take it first."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


if __name__ == "__main__":
    sys.exit(main())
