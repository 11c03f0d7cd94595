"""`usdrigui sample DIR`: the character that the documents work on."""

from commands import contents

from usdrigui.cli import main
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings


def test_the_sample_is_written_and_again_and_takes_no_place_of_another_file(tmp_path, capsys):
    folder = tmp_path / "new" / "first"
    assert main(["sample", str(folder)]) == 0
    assert [len(read_rigs(folder / name, Settings())) for name in ("char.usda", "hero.usda")] == [1, 1]
    before = contents(folder)
    assert main(["sample", str(folder)]) == 0
    assert "unchanged" in capsys.readouterr().out
    assert contents(folder) == before
    other = folder.with_name("char.usda")
    other.write_text("#usda 1.0\n")
    assert main(["sample", str(other.parent)]) == 3
    told = capsys.readouterr().err
    assert f"FILE_TARGET {other}: " in told
    assert f"refused {other.parent}; " in told
    assert sorted(other.parent.iterdir()) == [other, folder]
    assert other.read_text() == "#usda 1.0\n"
