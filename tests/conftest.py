"""What tests of several folders share."""

import os
import shutil
import signal
from dataclasses import replace

import failures_at_once
import pytest
import skinned_stages
import suites
from hypothesis import settings

from usdrigui.cli import main
from usdrigui.view import picture, sheet

# Every run draws the same examples, so that a change is judged by itself; `--hypothesis-profile=default` draws others.
settings.register_profile("same", derandomize=True)
settings.load_profile("same")


@pytest.fixture(scope="session", autouse=True)
def small_pictures():
    """Commands draw a tenth of the pixels, in a fraction of the time; what pictures look like is told where they are
    drawn without a command."""
    draw, size = sheet.render, (480, 320)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sheet, "render", lambda *given: draw(*given[:3], replace(given[3], size=size)))
        patch.setattr(picture, "FILM", size)
        yield


@pytest.fixture(scope="module")
def laid_out(tmp_path_factory):
    """Folder of a character with its layout, made once a module; to be copied by every test that may spoil it."""
    character = skinned_stages.character(tmp_path_factory.mktemp("once") / "char.usda")
    assert main(["process", str(character), "--quiet"]) == 0
    return character.parent


@pytest.fixture(scope="module")
def made(laid_out):
    """Folder that a module has made, by default a character with its layout."""
    return laid_out


@pytest.fixture
def folder(made, tmp_path):
    """A copy of it for a test that may spoil it."""
    return shutil.copytree(made, tmp_path / "asset")


def pytest_addoption(parser):
    parser.addoption(
        "--suite",
        choices=suites.SUITES,
        help="the tests to run (tests/suites.py); quick, or all of the files, folders or markers that are named",
    )


def pytest_configure(config):
    failures_at_once.pytest_configure(config)
    # readline, which pytest loads, sets it behind Python's back: what is printed here goes to no terminal.
    os.environ.pop("COLUMNS", None)
    os.unsetenv("COLUMNS")
    # A shell lets what it runs in the background ignore it, and so would every command that a test interrupts.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    # Files that meet programs have few tests and take long: they come first, in the order of their folders.
    config.option.loadscopereorder = False
    if config.option.suite is None:
        named = config.args_source is pytest.Config.ArgsSource.ARGS or config.option.markexpr
        config.option.suite = "all" if named else "quick"


@pytest.hookimpl(tryfirst=True)
def pytest_fixture_setup():
    """pytest names the test and its phase in the environment.  The process that reads is started anew when that
    changes, which takes half of the time of all tests."""
    os.environ["PYTEST_CURRENT_TEST"] = "a test of usdrigui"


pytest_pyfunc_call = pytest_fixture_setup


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config, items):
    kept = suites.taken(items, config.option.suite)
    config.hook.pytest_deselected(items=[*set(items) - set(kept)])
    items[:] = kept


def pytest_terminal_summary(terminalreporter, config):
    """What was left out is said; with pytest-xdist, pytest itself does not."""
    said = {"quick": "slow tests were left out", "sample": "of the slow tests the first of every file was run"}
    if config.option.suite in said:
        terminalreporter.write_line(f"{said[config.option.suite]}: --suite slow runs them all")
