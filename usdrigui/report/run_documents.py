"""The JSON documents of a run, a review and a difference, described in docs/internals/report.md."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from usdrigui.errors import Issue
from usdrigui.model import Assignment, Element, Legibility
from usdrigui.report.documents import document, plain
from usdrigui.report.run_report import CharacterReport, PartRow, Report


def to_json(report: Report) -> str:
    """The report as a JSON document."""
    return document(
        "report",
        asset=report.asset,
        output=report.output,
        outcome=report.outcome,
        exit=0,
        characters=[_character(each) for each in report.characters],
        issues=report.issues,
        settings=report.settings,
        sources=report.sources,
        seconds=dict(report.seconds),
    )


def review_json(layer: str, characters: Sequence[tuple[str, Any]], issues: Sequence[Issue]) -> str:
    """The outcome of `usdrigui check` as a JSON document; `characters` are (prim path, review)
    pairs."""
    reviews = [
        {
            "root": root,
            "cost": review.cost,
            "legibility": _legibility(review.legibility),
            "posing": review.posing,
            "elements": review.elements,
        }
        for root, review in characters
    ]
    return document("review", layer=layer, characters=reviews, issues=issues)


def difference_json(found: Any) -> str:
    """The outcome of `usdrigui diff`, a `usdrigui.pipeline.LayerDifference`, as a JSON document."""
    return document(
        "difference",
        before=found.before,
        after=found.after,
        characters=[_difference(each) for each in found.characters],
        only_in_one=found.only_in_one,
        issues=found.issues,
    )


def _difference(found: Any) -> dict[str, Any]:
    return {
        "root": found.root,
        "shared": found.shared,
        "displaced": found.changed,
        "renamed": found.renamed,
        "changes": found.changes,
    }


def _character(character: CharacterReport) -> dict[str, Any]:
    layout, assignment = character.layout, character.assignment
    return {
        "root": character.root,
        "variant_path": layout.variant_path,
        "points": int(character.rig.body.starts[-1]),
        "meshes": len(character.rig.body.meshes),
        "controls": character.rows,
        "counts": {place: character.count(place) for place in ("face", "board", "left off")},
        "displacement_kept": character.kept,
        "legibility": _legibility(character.legibility),
        "elements": [
            _element(element, element.name not in character.added) for element in layout.elements
        ],
        "handle_width": layout.frame.handle_width,
        "symmetry_plane": {
            "origin": layout.frame.plane.origin,
            "normal": layout.frame.plane.normal,
        },
        "view": layout.frame.view,
        "parts": [_part(part) for part in character.parts],
        "difference": character.difference and _difference(character.difference),
        "matchings": character.matchings,
        "solution": {
            **_proof(assignment),
            "weights": dict(layout.proof.weights),
            "steps": [{**plain(step), "figures": dict(step.figures)} for step in assignment.steps],
        },
    }


def _legibility(found: Legibility) -> dict[str, Any]:
    return {"elements": found.elements, "clear": found.clear, "unclear": dict(found.unclear)}


def _part(part: PartRow) -> dict[str, Any]:
    names = ("name", "controls", "on_it", "handle_width", "view")
    return {name: getattr(part, name) for name in names} | {"solution": _proof(part.assignment)}


def _proof(assignment: Assignment) -> dict[str, Any]:
    names = ("method", "closed_by", "status", "cost", "bound")
    return {
        name: getattr(assignment, name) for name in (*names, "penalty", "gap", "above_unary_bound")
    }


def _element(element: Element, existing: bool) -> dict[str, Any]:
    anchor = element.anchor
    return {
        "name": element.name,
        "kind": element.kind,
        "controls": [member.control for member in element.members],
        "opposed": element.opposed,
        "side": element.side,
        "mirror": element.mirror,
        "on_board": anchor.on_board,
        "category": element.category,
        "mesh": anchor.mesh,
        "point": anchor.point,
        "position": anchor.position,
        "gains": [member.magnification for member in element.members],
        "reason": element.reason,
        "existing": existing,
        "members": element.inner,
    }
