"""Save an asset while it is being edited, at random moments, and see that no save is lost.

    python tests/faults/saving.py --replacements 1000   # the replacement alone, some milliseconds around the exchange
    python tests/faults/saving.py --attaches 100        # the whole of attach, at any moment

Every other save renames a new file over the asset, every other writes into the file in place.  Prints one JSON
document: how many replacements were done and refused, and the saves that are gone.
"""

from __future__ import annotations

import argparse
import collections
import contextlib
import json
import os
import random
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from usdrigui.errors import RigUIError
from usdrigui.isolation.foreign_file import hashed
from usdrigui.replacing.exchange import Original, replace_source

OLD, EDITED, SAVED = b"old\n" * 20_000, b"edited\n" * 20_000, b"mine\n" * 16_000


def save_during_replacements(count: int, folder: Path, seed: int = 0) -> dict[str, object]:
    """Saves around `replace_source`."""
    asset = folder / "char.usda"

    def edit() -> None:
        replace_source(asset, Original(before, OLD), EDITED, lambda _: True)

    asset.write_bytes(OLD)
    before = hashed(asset)
    return _trials(count, asset, lambda: asset.write_bytes(OLD), edit, SAVED, random.Random(seed))


def save_during_attaches(count: int, folder: Path, seed: int = 0) -> dict[str, object]:
    """Saves around `attach`, reading and checking included."""
    sys.path.append(str(Path(__file__).parents[1]))
    import skel_stages

    from usdrigui.cli import main
    from usdrigui.clients.attaching.attach import attach
    from usdrigui.settings import Settings

    asset = skel_stages.head(folder / "char.usda")
    layer = folder / "char.rigui.usda"
    with contextlib.redirect_stdout(sys.stderr):
        assert main(["process", str(asset), "--bare", "--quiet", "-o", str(layer)]) == 0
    old = asset.read_bytes()
    saved = old + b"# somebody's save\n"
    return _trials(
        count,
        asset,
        lambda: asset.write_bytes(old),
        lambda: attach(asset, layer, Settings()),
        saved,
        random.Random(seed),
    )


def _trials(
    count: int,
    asset: Path,
    restore: Callable[[], object],
    edit: Callable[[], object],
    saved: bytes,
    chance: random.Random,
) -> dict[str, object]:
    seen: collections.Counter[str] = collections.Counter()
    lost = []
    names = {each.name for each in asset.parent.iterdir()}
    restore()
    start = time.monotonic()
    edit()
    usual = time.monotonic() - start
    for number in range(count):
        restore()
        pid = os.fork()
        if not pid:
            _save(asset, saved, in_place=bool(number % 2), pauses=(chance.uniform(0, 1.2 * usual), usual / 10))
            os._exit(0)
        try:
            edit()
            seen["written"] += 1
        except RigUIError as error:
            seen[error.issue.code] += 1
        os.waitpid(pid, 0)
        chance.random()  # as the child has
        if saved.splitlines()[-1] not in asset.read_bytes():
            lost.append(number)
        if {each.name for each in asset.parent.iterdir()} != names:
            lost.append(-number)
    return {"saves": count, "ends": dict(sorted(seen.items())), "lost": lost}


def _save(asset: Path, content: bytes, *, in_place: bool, pauses: tuple[float, float]) -> None:
    """Save the asset as an application does that has it open for a moment."""
    time.sleep(pauses[0])
    if in_place:
        with asset.open("r+b") as stream:
            time.sleep(pauses[1])
            stream.write(content)
            stream.truncate()
    else:
        beside = asset.with_name("saving.tmp")
        beside.write_bytes(content)
        beside.replace(asset)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--replacements", type=int, default=0)
    parser.add_argument("--attaches", type=int, default=0)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        found = (
            save_during_attaches(asked.attaches, Path(place), asked.seed)
            if asked.attaches
            else save_during_replacements(asked.replacements, Path(place), asked.seed)
        )
    print(json.dumps(found, indent=2))
    sys.exit(bool(found["lost"]))
