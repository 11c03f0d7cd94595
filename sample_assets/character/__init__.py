"""Procedural model of the sample character; `make_char.py` beside this package runs it."""
