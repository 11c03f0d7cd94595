"""The edit of an asset's root layer: nothing stays behind."""

import pytest
from pxr import Sdf

from usdrigui.clients.attaching.layout_reference import (
    ReferenceOf,
    add as add_to_specs,
    references_of,
    remove as remove_from_specs,
)

HEAD = ReferenceOf("/Char/Head", "./head.rigui.usda")
BODY = ReferenceOf("/Char/Body", "./body.rigui.usda")
TEXTS = {
    "empty": "#usda 1.0\n",
    "without metadata": '#usda 1.0\n\ndef Xform "Char"\n{\n    def SkelRoot "Head"\n    {\n    }\n}\n',
    "with metadata": '#usda 1.0\n(\n    doc = "{"\n)\n\ndef Xform "Char" (\n    kind = "component"\n)\n{\n'
    '    def SkelRoot "Head" (\n        doc = """)("""\n    )\n    {\n        int a = 1\n    }\n}\n',
    "only its parent": '#usda 1.0\n\nover "Char"\n{\n    int a = 1\n}\n',
}  # fmt: skip


def layer(text):
    found = Sdf.Layer.CreateAnonymous(".usda")
    assert found.ImportFromString(text)
    return found


@pytest.mark.parametrize("references", [(HEAD,), (HEAD, BODY)], ids=["one", "two"])
@pytest.mark.parametrize("name", TEXTS)
def test_a_layer_gets_references_and_loses_them_again(name, references):
    text, specs = TEXTS[name], layer(TEXTS[name])
    add_to_specs(specs, references)
    assert set(references_of(specs, lambda path: path.startswith("./"))) == set(references)
    assert references_of(specs, lambda path: path == BODY.path) == references[1:]
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
