"""Whatever call fails, a command ends with a documented code and every file is whole (failing.py)."""

import sys

import failing
import pytest

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="commands are forked")


def test_the_first_call_of_every_kind_fails():
    assert failing.campaign(1 << 20, ["attach"])["faults"] == []


@pytest.mark.slow
@pytest.mark.parametrize("every", [1021, 127])
@pytest.mark.parametrize("command", ["detach", "attach", "process"])
def test_one_call_in_so_many_fails(command, every):
    assert failing.campaign(every, [command])["faults"] == []
