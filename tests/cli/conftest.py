"""A laid-out character, made once a module and copied for every test that may spoil it."""

import shutil

import pytest
import skinned_stages

from usdrigui.cli import main


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent


@pytest.fixture
def layer(laid_out, tmp_path):
    shutil.copytree(laid_out, tmp_path / "asset")
    return tmp_path / "asset" / "char.rigui.usda"
