"""Doors to other programs: publish frameworks, DCCs, batch runs."""
