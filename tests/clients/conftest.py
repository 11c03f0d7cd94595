"""Chromium for the tests of the viewer.

A module at a time: while Playwright runs, its event loop counts as running for everything else in the process.
"""

import pytest
from browser_pages import chromium, started


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
