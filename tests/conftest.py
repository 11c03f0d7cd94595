"""What tests of several folders share."""

import pytest
import skinned_stages

from usdrigui.cli import main


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    """Folder of a character with its layout, made once a module; to be copied by every test that may spoil it."""
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent
