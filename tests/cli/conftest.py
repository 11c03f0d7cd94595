"""A laid-out character for every test that may spoil it."""

import shutil

import pytest


@pytest.fixture
def layer(laid_out, tmp_path):
    shutil.copytree(laid_out, tmp_path / "asset")
    return tmp_path / "asset" / "char.rigui.usda"
