"""Chromium for the tests of the viewer.

A module at a time: while Playwright runs, its event loop counts as running for everything else in the process.
"""

import pytest
from browser_pages import Viewer, chromium, started


@pytest.fixture(scope="module")
def playwright():
    made = started()
    yield made
    made.stop()


@pytest.fixture(scope="module")
def browser(playwright):
    made = chromium(playwright)
    yield made
    made.close()


@pytest.fixture
def viewer(browser, page_path):
    """The page that a module's `page_path` makes; what goes wrong in it fails the test."""
    made = Viewer(browser, page_path)
    yield made
    assert made.trouble == []
    made.close()
