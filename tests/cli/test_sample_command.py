"""`usdrigui sample DIR`: the character that the documents work on."""

from usdrigui.cli import main
from usdrigui.reading.character import read_rigs
from usdrigui.settings import Settings


def test_the_sample_is_written_and_again_and_takes_no_place_of_another_file(tmp_path, capsys):
    folder = tmp_path / "new" / "first"
    assert main(["sample", str(folder)]) == 0
    assert [len(read_rigs(folder / name, Settings())) for name in ("char.usda", "hero.usda")] == [1, 1]
    before = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert main(["sample", str(folder)]) == 0
    assert "unchanged" in capsys.readouterr().out
    assert {path.name: path.read_bytes() for path in folder.iterdir()} == before
    for path in folder.iterdir():
        path.unlink()
    (folder / "char.usda").write_text("#usda 1.0\n")
    assert main(["sample", str(folder)]) == 3
    assert "FILE_TARGET" in capsys.readouterr().err
    assert [(path.name, path.read_text()) for path in folder.iterdir()] == [("char.usda", "#usda 1.0\n")]
