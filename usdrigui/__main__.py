"""``python -m usdrigui``."""

import sys

from usdrigui.cli import main

if __name__ == "__main__":
    sys.exit(main())
