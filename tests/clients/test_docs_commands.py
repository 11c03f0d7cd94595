"""Every command in docs/ that is marked to be run, run: each page in a folder of its own, its blocks in order."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import skinned_stages
import studio_assets
from folders import ROOT

from usdrigui.layer.read_layout import read_layout

DOCS = ROOT / "docs"
BLOCK = re.compile(r"^<!-- run(?:: (?P<needs>\S+))? -->\n```sh\n(?P<text>.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = ("hosts.md", "internals/assets.md", "animator.md", "pipeline.md", "rigger.md")


def blocks(page):
    return [(match["needs"], match["text"]) for match in BLOCK.finditer((DOCS / page).read_text(encoding="utf-8"))]


def headings(page):
    """The anchors of a page's headings, as GitHub and others make them."""
    titles = re.findall(r"^#+ (.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", title).strip().lower().replace(" ", "-") for title in titles}


def test_every_link_leads_somewhere():
    """Of all pages: to files of this repository, and to headings where one is named."""
    root = DOCS.parent
    pages = [*root.glob("*.md"), *DOCS.rglob("*.md"), *root.glob("schemas/*.md"), *root.glob("viewer/*.md")]
    lost = []
    for page in pages:
        text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
        for link in re.findall(r"\]\(([^)\s]+)\)", text):
            path, _, heading = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            if "://" in link or (target.exists() and (not heading or heading in headings(target))):
                continue
            lost.append(f"{page.relative_to(root)}: {link}")
    assert not lost
    entry = (root / "README.md").read_text(encoding="utf-8")
    assert all(f"(docs/{role}.md)" in entry for role in ("animator", "rigger", "pipeline"))


def test_the_ten_settings_are_those_that_riggers_are_shown():
    """In the same order, each with its number."""
    _, _, table = (DOCS / "settings.md").read_text(encoding="utf-8").partition("## The ten\n")
    keys = re.findall(r"^\| `([^`]+)`", table.partition("## The rest")[0], re.MULTILINE)
    shown = re.findall(r"^(\w+) = .*# +(\d+)", (DOCS / "rigger.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert [int(number) for _, number in shown] == list(range(1, 11))
    names = [key.rpartition(".")[2] for key in keys]
    assert [name if name != "eyeAim_L" else "groups" for name, _ in shown] == names


def test_every_page_with_commands_to_run_is_listed():
    pages = [*DOCS.glob("*.md"), *DOCS.glob("internals/*.md")]
    marked = {str(page.relative_to(DOCS)) for page in pages if "<!-- run" in page.read_text(encoding="utf-8")}
    assert marked == set(PAGES)
    assert all(len(blocks(page)) == (DOCS / page).read_text(encoding="utf-8").count("<!-- run") for page in PAGES), (
        "a mark must stand right above its block"
    )


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("bash") is None, reason="needs bash")
@pytest.mark.parametrize("page", PAGES)
def test_the_commands_of_a_page(page, tmp_path):
    if page == "internals/assets.md":
        studio_assets.asset(tmp_path)
    elif page == "hosts.md":
        skinned_stages.character(tmp_path / "char.usda")
    for name in ("one", "two"):
        (tmp_path / "assets" / name).mkdir(parents=True)
        skinned_stages.character(tmp_path / "assets" / name / "char.usda")
    programs = Path(sys.executable).parent
    # How good the layouts are is of no interest here.
    quick = {"USDRIGUI_SOLVE_GAP": "0.05", "USDRIGUI_SOLVE_WORK_LIMIT": "1"}
    environment = {**os.environ, **quick, "PATH": f"{programs}{os.pathsep}{os.environ['PATH']}"}
    for needs, text in blocks(page):
        if needs is not None and not (programs / needs).exists():
            continue
        command = ["bash", "-euo", "pipefail", "-c", text]
        done = subprocess.run(
            command, cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=300, check=False
        )
        assert done.returncode == 0, f"{text}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}"
    if page == "rigger.md":
        _corrections_hold(tmp_path)


def _corrections_hold(folder):
    """What the page decides by hand is so in the layout that it makes then."""
    (layout,) = read_layout(folder / "corrected.rigui.usda")
    at = {member.control: each for each in layout.elements for member in each.members}
    assert at["mouthPucker"].anchor.on_board
    assert at["browInnerUp"].label == "brows"
    assert {at[name].pinned for name in ("cheekPuff", "jawOpen")} == {("anchor",)}
    points = {each.anchor.point for each in layout.elements if "cheekPuff" in each.controls}
    assert 523 in points
