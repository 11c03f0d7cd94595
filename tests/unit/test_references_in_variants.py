"""The edit of an asset's root layer: its text and its specs say the same, and nothing stays behind."""

from __future__ import annotations

import pytest
from pxr import Sdf

from usdrigui.clients.attaching.layer_text import ReferenceOf, with_references, without_references
from usdrigui.clients.attaching.layout_reference import add as add_to_specs, references_of, remove as remove_from_specs

HEAD = ReferenceOf("/Char/Head", "./head.rigui.usda")
BODY = ReferenceOf("/Char/Body", "./body.rigui.usda")
BARE = '    def "Head"\n    {\n    }\n'
TWIN = BARE.replace("Head", "Body")
TEXTS = {
    "empty": "#usda 1.0\n",
    "without metadata": '#usda 1.0\n\ndef Xform "Char"\n{\n    def SkelRoot "Head"\n    {\n    }\n}\n',
    "with metadata": '#usda 1.0\n(\n    doc = "{"\n)\n\ndef Xform "Char" (\n    kind = "component"\n)\n{\n'
    '    def SkelRoot "Head" (\n        doc = """)("""\n    )\n    {\n        int a = 1\n    }\n}\n',
    "only its parent": '#usda 1.0\n\nover "Char"\n{\n    int a = 1\n}\n',
    "others of its name": f'#usda 1.0\n\ndef "Head"\n{{\n    def "Char"\n    {{\n{BARE}    }}\n}}\ndef "Char"\n'
    f'{{\n    def "Hat"\n    {{\n{BARE}    }}\n{BARE}}}\n',
    "words in values": '#usda 1.0\n\n# def "Char" {\ndef "Char" (\n    customData = {\n        string def = "Head"\n'
    f'    }}\n)\n{{\n    token over = "Head" # {{\n    asset def = @a{{.usd@\n{BARE}}}\n',
}  # fmt: skip


def layer(text):
    found = Sdf.Layer.CreateAnonymous(".usda")
    assert found.ImportFromString(text)
    return found


@pytest.mark.parametrize("references", [(HEAD,), (HEAD, BODY)], ids=["one", "two"])
@pytest.mark.parametrize("name", TEXTS)
def test_the_text_gets_what_the_specs_get_and_loses_it_again(name, references):
    text, specs = TEXTS[name], layer(TEXTS[name])
    add_to_specs(specs, references)
    edited = with_references(text, references)
    assert layer(edited).ExportToString() == specs.ExportToString()
    assert set(references_of(specs, lambda path: path.startswith("./"))) == set(references)
    assert references_of(specs, lambda path: path == BODY.path) == references[1:]
    assert without_references(edited, references[::-1]) == text
    remove_from_specs(specs, references)
    assert specs.ExportToString() == layer(text).ExportToString()


def test_what_else_stands_in_the_variants_stays():
    """Another opinion in the variant, and another reference."""
    specs = layer('#usda 1.0\ndef "Char"\n{\n    def "Head"\n    {\n    }\n}\n')
    add_to_specs(specs, [HEAD])
    inside = specs.GetPrimAtPath("/Char/Head{rigUI=ui}")
    inside.referenceList.Append(Sdf.Reference("./other.usda", "/Other"))
    remove_from_specs(specs, [HEAD])
    assert [each.assetPath for each in inside.referenceList.GetAddedOrExplicitItems()] == ["./other.usda"]
    assert specs.GetPrimAtPath("/Char/Head").variantSelections["rigUI"] == "none"


@pytest.mark.parametrize("name", TEXTS)
def test_of_two_references_the_other_stays_with_all_that_it_needs(name):
    """What two SkelRoots get as their metadata is the same text."""
    text = TEXTS[name] if name != "without metadata" else TEXTS[name].replace("    }\n", f"    }}\n{TWIN}", 1)
    both, specs = with_references(text, [HEAD, BODY]), layer(text)
    assert without_references(both, [BODY]) == with_references(text, [HEAD])
    add_to_specs(specs, [HEAD, BODY])
    remove_from_specs(specs, [HEAD])
    assert layer(without_references(both, [HEAD])).ExportToString() == specs.ExportToString()


def test_what_somebody_changed_is_left_alone():
    text = with_references(TEXTS["without metadata"], [HEAD])
    changed = text.replace('rigUI = "none"', 'rigUI = "ui"').replace('"none" {', '"none" {  # mine')
    assert without_references(changed, [HEAD]) == changed
    for name in ("only its parent", "without metadata", "with metadata"):
        assert without_references(TEXTS[name], [HEAD]) == TEXTS[name]


def test_the_overs_of_a_prim_that_the_text_lacks_read_as_usd_writes_them():
    assert (
        with_references("#usda 1.0\n", [HEAD])
        == """#usda 1.0

over "Char"
{
    over "Head" (
        variants = {
            string rigUI = "none"
        }
        prepend variantSets = "rigUI"
    )
    {
        variantSet "rigUI" = {
            "none" {
            }
            "ui" (
                prepend references = @./head.rigui.usda@</Char/Head>
            ) {
            }
        }
    }
}
"""
    )
