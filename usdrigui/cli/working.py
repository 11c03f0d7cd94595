"""The worker of a command, ``python -P -m usdrigui.cli.working COMMAND ...``: see
`usdrigui.isolation.supervising`."""

from __future__ import annotations

import gc
import os
import sys
from typing import NoReturn

from usdrigui.errors import Exit
from usdrigui.isolation import worker

_ALLOCATIONS = 50_000
"""Between two collections of garbage: what is loaded to start would be looked through again and
again."""


def main() -> NoReturn:
    """Run the command of the command line, and close with its exit code.

    A request to stop that comes before the command has begun, or amid its last words, leaves the
    closing line to the supervisor.
    """
    try:
        worker.start()
        gc.set_threshold(_ALLOCATIONS)
        from usdrigui import cli

        worker.finish(cli.main(sys.argv[1:]))
    except KeyboardInterrupt:
        os._exit(int(Exit.LIMIT))


if __name__ == "__main__":
    main()
