"""A killed run leaves the old or the new file, and no save is lost.

The long versions are commands, ends.py, killing.py and saving.py, with the last figures in docs/reliability.md.
"""

import sys
from pathlib import Path

import pytest
from programs import figures

HERE = Path(__file__).parent

pytestmark = pytest.mark.slow


def test_kills_around_the_write_never_tear_a_file():
    found = figures(HERE / "killing.py", "--commits", 150)
    assert found["faults"] == []
    states = found["states"]
    assert sum(states.values()) == 150
    assert any(state.startswith("old") for state in states), "the kills came too late to tell anything"
    assert any(state.startswith("new") for state in states), "the kills came too early to tell anything"
    assert any("temporary left" in state for state in states), "no kill met the middle of a write"


def test_no_save_is_lost_to_an_edit():
    found = figures(HERE / "saving.py", "--replacements", 60)
    assert found["lost"] == []
    assert {"written", "SOURCE_CHANGED"} <= found["ends"].keys(), "the saves came all too early or all too late"


@pytest.mark.skipif(sys.platform != "linux", reason="looks for processes in /proc")
def test_kills_and_signals_end_commands_with_a_documented_code_and_nothing_torn():
    found = figures(HERE / "ends.py", "--count", 6, "--only", "process", "batch")
    assert found["faults"] == []
