"""The gallery says of every rig that it shows what its row says, and what is still wrong on it."""

from pathlib import Path

from scripts import loaded

DOCS = Path(__file__).parents[2] / "docs"


def test_the_page_has_a_row_a_picture_and_a_remark_of_every_rig_that_was_laid_out():
    with loaded(DOCS / "gallery.py") as gallery:
        now = gallery.Result("face, body", "7/9", "5/6", "95%", "9.0e-05", "6/7")
        page = gallery.page({"godette": vars(now)})
        assert "| godette | face, body | 7/9 | 5/6 | 95% | 9.0e-05 | 6/7 |" in page
        assert page.rstrip().endswith(gallery.REMARKS["godette"].strip())
        assert page.count("images/gallery/") == 1
        assert (DOCS / "internals" / "gallery.md").read_text("utf-8").startswith(page.partition("|")[0])
        shown = [name for name in gallery.REMARKS if (gallery.IMAGES / f"{name}.jpg").is_file()]
        assert all(gallery.REMARKS[name] for name in shown)
