"""A layout proven optimal has no better place, though one side of a pair alone could gain."""

from laid_out_again import lay_out, read

from usdrigui.layout.review import rating
from usdrigui.layout.review.review import review
from usdrigui.settings import load

EXACT = load({"solve": {"gap": 1e-4}})


def test_a_pair_is_judged_as_one(monkeypatch):
    ready, _, made = lay_out(read("godette.usdc"), EXACT)

    def named():
        found = review(ready.measured, ready.candidates, made).issues
        return {each.path for each in found if each.code == "LAYOUT_BETTER_PLACE"}

    assert named() == set()
    monkeypatch.setattr(rating, "_mates", lambda *given: [-1] * len(given[-1]))
    assert named(), "without looking at pairs the layout would be doubted"
