"""Controls of given rigs and of made copies are recognised, whatever they are called and however they are sculpted.

With ``-s`` each comparison prints a row: how many of the shared controls are matched for sure, and how many wrongly.
"""

import tomllib

import pytest
from laid_out_again import SETTINGS, lay_out, read
from names_of_two_makers import ALSO, APART, NAMES
from rig_copies import box_of, numbers, other_head, renamed, reordered, resculpted, spelt_otherwise

from usdrigui.layout.motion.trajectory import trajectories
from usdrigui.layout.reuse.identity import SURE, match_layout, match_rigs, names_draft

pytestmark = pytest.mark.real

RIGS = [
    *("facecap_blender.usdc", "mh_expr34.usdc", "godette.usdc"),
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("ict_face57.usdc", "vitruvian.usdc")),
]


def with_motions(rig):
    return rig, trajectories(rig, SETTINGS.trajectories)


def known(names, rig):
    """The names of the controls that move anything."""
    motions = with_motions(rig)[1].motions
    return {rig.controls[each.control].name: names[rig.controls[each.control].name] for each in motions}


def judged(matching, truth, pair):
    """The share of `truth` that is matched for sure, and what is sure and wrong; the draft says the same as written."""
    drafted = tomllib.loads(names_draft(matching))["like"]["names"]
    assert drafted == matching.renamed
    right = [name for name, after in truth.items() if matching.names.get(name) == after]
    wrong = {name: after for name, after in matching.names.items() if truth.get(name, after) != after}
    print(f"\n{pair:<60} {len(right):>4} of {len(truth):<4} {len(right) / len(truth):>4.0%} sure, {len(wrong)} wrong")
    return len(right) / len(truth), wrong


@pytest.mark.parametrize(
    ("one", "other"),
    [("ict_face57.usdc", "ict_parts17.usdc"), ("ict_face57.usdc", "facecap_blender.usdc")],
)
def test_heads_that_share_names_share_controls(one, other):
    first, second = read(one), read(other)
    shared = {*first.control_names} & {*second.control_names}
    for rigs, pair in (((first, second), f"{one} {other}"), ((second, first), f"{other} {one}")):
        share, wrong = judged(match_rigs(*map(with_motions, rigs)), {name: name for name in shared}, pair)
        assert share >= 0.98
        assert not wrong


@pytest.mark.parametrize("name", RIGS)
def test_copies_with_other_names_are_recognised(name):
    """By another convention on another mesh, and by names that say nothing where the shapes stayed."""
    rig = read(name)
    spelt, names = renamed(rig, spelt_otherwise)
    coarse = other_head(spelt, 110, box_of(rig))
    silent, silent_names = renamed(rig, numbers())
    copies = {
        "respelt, coarser, reshaped": (coarse, names),
        "the same, reordered, sculpted again": (resculpted(reordered(coarse, 1), 2), names),
        "names without meaning, reordered": (reordered(silent, 3), silent_names),
    }
    for kind, (copy, truth) in copies.items():
        found = match_rigs(with_motions(rig), with_motions(copy))
        share, wrong = judged(found, known(truth, rig), f"{name} {kind}")
        assert share >= 0.98
        assert not wrong


@pytest.mark.parametrize("name", RIGS)
def test_what_is_not_sure_is_said_to_be(name):
    """Names that say nothing, on a coarser, reshaped head with other shapes: few are sure, none is wrong."""
    rig = read(name)
    silent, names = renamed(rig, numbers())
    copy = resculpted(reordered(other_head(silent, 110, box_of(rig)), 1), 2)
    found = match_rigs(with_motions(rig), with_motions(copy))
    _, wrong = judged(found, names, f"{name} names without meaning on another head")
    assert not wrong


@pytest.mark.slow
@pytest.mark.parametrize("arkit", ["ict_face57.usdc", "facecap_blender.usdc"])
def test_two_makers_with_words_of_their_own(arkit):
    """All are found, sides that the one names by the viewer too; two thirds are sure, and none of those wrong."""
    one, other = with_motions(read(arkit)), with_motions(read("vitruvian.usdc"))
    truth = counterparts({*one[0].control_names})
    count = 0
    for rigs, order in (((one, other), 1), ((other, one), -1)):
        found = {(m.before, m.after)[::order]: m.confidence for m in match_rigs(*rigs).matches}
        right = [pair for pair in found if pair[1] in truth.get(pair[0], ())]
        sure = [pair for pair in right if found[pair] >= SURE]
        wrong = [pair for pair in found if found[pair] >= SURE and pair[0] in truth and pair not in right]
        pair = f"{arkit} {'to' if order > 0 else 'from'} vitruvian"
        print(f"\n{pair}: {len(right)} of {len(truth)}, {len(sure)} sure, {len(wrong)} wrong")
        assert len(sure) >= 0.66 * len(truth)
        assert not wrong
        count += len(right)
    assert count >= 0.98 * 2 * len(truth)


def counterparts(names):
    """What each shared control of an ARKit rig may be called by the other maker."""
    called = {"cheekRaiser_L": "cheekSquint_L", "cheekRaiser_R": "cheekSquint_R"}  # FACS 6; ICT's rig has either
    shared = {name: theirs for name, theirs in NAMES.items() if name not in APART}
    pairs = {name if name in names else called.get(name, ""): theirs for name, theirs in shared.items()}
    return {name: {theirs, ALSO.get(name, theirs)} for name, theirs in pairs.items() if name in names}


@pytest.mark.parametrize("name", ["facecap_blender.usdc", "mh_expr34.usdc"])
def test_a_layout_knows_its_controls_by_their_motion(name):
    rig = read(name)
    _, _, layout = lay_out(rig)
    on_face = {m.control for e in layout.elements if not e.anchor.on_board for m in e.members}
    copy, names = renamed(rig, numbers())
    found = match_layout(layout, *with_motions(reordered(copy, 4)))
    share, wrong = judged(found, {each: names[each] for each in on_face}, f"{name} its layout, names without meaning")
    assert share >= 0.98
    assert not wrong
