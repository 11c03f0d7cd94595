"""What several laws ask for."""

import pytest

from usdrigui.layer import drawn


@pytest.fixture
def every_point_drawn(monkeypatch):
    """Tracks drawn with all their points, each of which can then be compared with where it must be."""
    monkeypatch.setattr(drawn, "_BEND", -1.0)
    monkeypatch.setattr(drawn, "_LONG_BEND", -1.0)
