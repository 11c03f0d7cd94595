"""``python -m usdrigui`` and the command `usdrigui`: signals are handled before anything else is
loaded."""

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
    named = (getattr(signal, name, None) for name in ("SIGINT", "SIGTERM", "SIGHUP"))
    handled = [
        each for each in named if each is not None and signal.getsignal(each) is not signal.SIG_IGN
    ]  # nohup
    for number in handled:
        signal.signal(number, lambda *_: tell("stop"))
    _keep_standard_streams()
    from queue import SimpleQueue

    events: SimpleQueue[Any] = SimpleQueue()
    tell = events.put
    for each in early:
        tell(each)
    from usdrigui.cli.supervised import run

    code = run(sys.argv[1:], events)
    # The closing line is out: Python puts the default actions back before it has ended, and must
    # not die of a signal then.
    for number in handled:
        signal.signal(number, signal.SIG_IGN)
    return code


def _keep_standard_streams() -> None:
    """A stream that the shell has closed leaves its number to the next file that is opened: take it
    first."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)


if __name__ == "__main__":
    sys.exit(main())
