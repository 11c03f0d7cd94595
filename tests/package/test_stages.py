"""Stages say what they read: no record of the layout that holds everything is passed around (decision 106)."""

import ast
from collections import Counter, defaultdict
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2] / "usdrigui"
FIELDS, FUNCTIONS = 5, 10


ONE_FIELD = 9
"""Functions at most that take such a record for one field: another meaning has the field's name, or
they are handed on as values."""
CHANGES = {"Budget"}
"""A solver's only object that changes: it counts the work, is no record of a stage, and goes to every search."""
SHARED = {"Face", "Requests"}
"""What is measured of a face and what is asked for, once each: what nearly every stage of placing reads."""
THINGS = {"Rig", "RigMesh", "Trajectories", "Motion", "Layout", "Element", "Settings", "ReadSettings"}
"""What the field has one word for: taken apart into records of a few fields it would only be read through one dot
more."""


def parsed(folders):
    for folder in folders:
        for path in sorted((PACKAGE / folder).rglob("*.py")):
            yield ast.parse(path.read_text(encoding="utf-8"))


def taken(trees):
    """(record, function, fields read) of the module functions that take a record with more than five fields; no fields
    where they pass it on or call it."""
    classes = {each.name: each for tree in trees for each in ast.walk(tree) if isinstance(each, ast.ClassDef)}
    large = {name for name, each in classes.items() if sum(isinstance(x, ast.AnnAssign) for x in each.body) > FIELDS}
    large -= CHANGES | SHARED | THINGS
    for function in (each for tree in trees for each in tree.body if isinstance(each, ast.FunctionDef)):
        for each in (*function.args.posonlyargs, *function.args.args, *function.args.kwonlyargs):
            words = {each.annotation, *(ast.walk(each.annotation) if isinstance(each.annotation, ast.BinOp) else ())}
            for record in {word.id for word in words if isinstance(word, ast.Name)} & large:
                yield record, function.name, fields_read(function, each.arg)


def fields_read(function, name):
    names = [each for each in ast.walk(function) if isinstance(each, ast.Name) and each.id == name]
    fields = [each for each in ast.walk(function) if isinstance(each, ast.Attribute) and each.value in names]
    return {each.attr for each in fields} if len(fields) == len(names) else set()


def test_no_large_record_goes_to_many_functions_and_few_functions_take_one_for_a_field():
    found = list(taken(list(parsed([""]))))
    counts = Counter(record for record, *_ in found)
    assert {record: count for record, count in counts.items() if count > FUNCTIONS} == {}
    assert len(single := [each for each in found if len(each[2]) == 1]) <= ONE_FIELD, single


def test_a_function_that_takes_a_record_for_one_field_is_found():
    fields = "\n".join(f"    f{i}: int" for i in range(FIELDS + 1))
    tree = ast.parse(f"class Bag:\n{fields}\ndef a(bag: Bag): return bag.f0\ndef b(bag: Bag | None): return a(bag)")
    assert list(taken([tree])) == [("Bag", "a", {"f0"}), ("Bag", "b", set())]


def test_tests_of_the_layout_stand_in_the_folders_of_its_packages():
    tests, packages = PACKAGE.parent / "tests" / "unit" / "layout", PACKAGE / "layout"
    folders = {path.parent.relative_to(tests) for path in tests.rglob("test_*.py")}
    assert len(folders) > 8
    assert [str(folder) for folder in folders if not (packages / folder / "__init__.py").is_file()] == []


PAIRS = ("model", None), ("cli", "pipeline"), ("stages", "pipeline"), ("character", "reading")
"""Where two modules of one name are about one thing: its record and what makes it, a command and its steps."""


def test_a_module_name_stands_for_one_thing():
    rooms = defaultdict(list)
    for path in PACKAGE.rglob("*.py"):
        rooms[path.stem].append(path.parent.relative_to(PACKAGE).parts[:1] or ("",))
    twice = {name: [room for (room,) in found] for name, found in rooms.items() if len(found) > 1}
    assert {name for name, found in twice.items() if not any(one_thing(found, *pair) for pair in PAIRS)} == {
        "__init__",
    }


def one_thing(rooms, first, second):
    return len(rooms) == 2 and first in rooms and (second is None or second in rooms)
