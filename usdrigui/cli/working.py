"""The worker of a command, ``python -P -m usdrigui.cli.working``: see
`usdrigui.isolation.supervising`."""

from __future__ import annotations

import gc
import importlib
import os
import sys
from typing import NoReturn

from usdrigui.errors import Exit
from usdrigui.isolation import worker
from usdrigui.isolation.forking import serve

_ALLOCATIONS = 50_000
"""Between two collections of garbage: what is loaded to start would be looked through again and
again."""
_LOADED = ("cli.layouts", "pipeline.laying_out", "reader.reader_main", "solve.exact", "solve.milp")
"""What a character laid out needs: loaded once, before the workers of a batch are forked."""


def main() -> NoReturn:
    """A worker, or with ``warm`` the parent of many."""
    if sys.argv[1:] == ["warm"]:
        for each in _LOADED:
            importlib.import_module(f"usdrigui.{each}")
        serve(work)
    work()


def work() -> NoReturn:
    """Run the command that the supervisor asks for, and close with its exit code.

    A request to stop that comes before the command has begun, or amid its last words, leaves the
    closing line to the supervisor.
    """
    try:
        arguments = worker.start()
        gc.set_threshold(_ALLOCATIONS)
        from usdrigui import cli

        worker.finish(cli.main(arguments))
    except KeyboardInterrupt:
        os._exit(int(Exit.LIMIT))


if __name__ == "__main__":
    main()
