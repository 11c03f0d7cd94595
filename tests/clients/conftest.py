"""One Chromium for all tests of the viewer; every test has a page of its own."""

import pytest
from browser_pages import launched


@pytest.fixture(scope="session")
def browser():
    playwright, made = launched()
    yield made
    made.close()
    playwright.stop()
