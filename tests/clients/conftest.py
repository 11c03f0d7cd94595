"""Chromium for the tests of the viewer.

A module at a time: while Playwright runs, its event loop counts as running for everything else in the process.
"""

import makers
import pytest
from browser_pages import Viewer, chromium, started
from viewer_layouts import peak_layout

from usdrigui.view.web.page import page_html


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


@pytest.fixture(scope="module")
def page_path(request, tmp_path_factory):
    """The page of a module's `characters`, of the mask where it has none."""
    rig = makers.face()
    made = getattr(request.module, "characters", lambda: [(rig, peak_layout(rig))])
    path = tmp_path_factory.mktemp("viewer") / "page.html"
    path.write_text(page_html(made(), "face"))
    return path


@pytest.fixture
def opened(browser):
    """Opens pages; what goes wrong in one fails the test."""
    made = []

    def at(path, *size, **how):
        made.append(Viewer(browser, path, *size, **how))
        return made[-1]

    yield at
    for each in made:
        assert each.trouble == []
        each.close()


@pytest.fixture
def viewer(opened, page_path):
    """The page that a module's `page_path` makes."""
    return opened(page_path)
