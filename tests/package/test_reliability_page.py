"""The page of promises names tests and commands that exist."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "reliability.md").read_text(encoding="utf-8")


def test_every_path_on_it_exists():
    paths = set(re.findall(r"\b((?:tests|usdrigui)/[\w./]+?)(?=[`\s.,)]*(?:`|\s|$))", PAGE))
    assert len(paths) > 8
    assert not {path for path in paths if not (ROOT / path.rstrip(".")).exists()}


def test_every_link_on_it_exists():
    links = re.findall(r"\]\(([^)]+)\)", PAGE)
    assert links
    assert not {link for link in links if not (ROOT / "docs" / link).exists()}
