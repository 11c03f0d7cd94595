"""A laid-out character for every test that may spoil it."""

import pytest


@pytest.fixture
def layer(folder):
    return folder / "char.rigui.usda"
