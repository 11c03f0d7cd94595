"""Two runs at once on one asset: both complete, with the same bytes, and no file is torn meanwhile.

python tests/faults/pairs.py --count 100
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path


def run_pairs(count: int, folder: Path) -> dict[str, object]:
    """`count` times two commands at once, every other time over an older layer."""
    sys.path.append(str(Path(__file__).parents[1]))
    import skel_stages

    source = skel_stages.head(folder / "char.usda")
    target = folder / "char.rigui.usda"
    command = [sys.executable, "-m", "usdrigui", "process", str(source), "--quiet"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    whole = target.read_bytes()
    older = whole.replace(b"over", b"over ", 1)
    faults, said = [], set()
    for number in range(count):
        target.write_bytes(older) if number % 2 else target.unlink()
        pair = [subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for _ in range(2)]
        torn = False
        while any(process.poll() is None for process in pair):
            if target.exists():
                torn |= target.read_bytes() not in (whole, older)
            time.sleep(0.002)
        ends = [(process.communicate(), process.returncode) for process in pair]
        said |= {out.split(":")[1].split()[0] for (out, _), code in ends if not code}
        if torn or any(code for _, code in ends) or target.read_bytes() != whole:
            faults.append(f"pair {number}: {'torn' if torn else ends}")
        if len(list(folder.iterdir())) != 2:
            faults.append(f"pair {number}: files left")
        if number % 10 == 9:
            print(f"{number + 1} pairs: {len(faults)} faults", file=sys.stderr, flush=True)
    return {"pairs": count, "said": sorted(said), "faults": faults}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=3)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as place:
        found = run_pairs(asked.count, Path(place))
    print(json.dumps(found, indent=2))
    sys.exit(bool(found["faults"]))
