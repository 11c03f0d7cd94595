"""usdrigui: the USD pipeline step that gives any character its in-situ rig UI."""

__version__ = "0.1.0"
