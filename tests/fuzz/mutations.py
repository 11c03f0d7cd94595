"""Seeded damage to USD files: what disks, networks, editors, scripts and adversaries do to them.

`mutant` gives the n-th damaged file of a format; the same arguments give the same bytes.
"""

from __future__ import annotations

import io
import random
import re
import struct
import zipfile
import zlib
from collections.abc import Callable, Mapping

Seeds = Mapping[str, bytes]
"""Sound ``.usda`` or ``.usdc`` files by name."""

_NUMBERS = (
    "0", "-1", "1", "2", "3", "25", "0.5", "-0.5", "1e6", "2147483647", "-2147483648", "4294967296", "1e-45", "1e39",
    "-1e39", "1e308", "nan", "inf", "-inf",
)  # fmt: skip
_NO_NUMBERS = ("99999999999999999999", '""', "None", "true", "[]", "()", "<>", "@@", "[0]", "", "--1")
_WORDS = (
    "SkelRoot", "Skeleton", "SkelAnimation", "BlendShape", "Mesh", "Xform", "Points", "over", "class", "def",
    "uniform", "custom", "token[]", "float[]", "int[]", "half3[]", "double", "matrix4d[]", "rel", "timeSamples",
    "prepend", "delete", "references", "payload", "inherits", "instanceable", "active", "purpose", "visibility",
    "points", "offsets", "pointIndices", "normalOffsets", "skel:joints", "skel:blendShapes", "skel:skeleton",
    "skel:blendShapeTargets", "blendShapeWeights", "primvars:skel:jointIndices", "primvars:skel:jointWeights",
    "elementSize", "interpolation", "constant", "vertex", "weight", "restTransforms", "bindTransforms",
)  # fmt: skip
_WIDE = (0, 1, 2, 0x7F, 0xFF, 0xFFFF, 1 << 24, 1 << 31, (1 << 31) - 1, 1 << 32, 1 << 40, 1 << 63, (1 << 64) - 1)


def mutant(form: str, seeds: Seeds, number: int, seed: int = 0) -> bytes:
    """Damaged file `number` of the format ``usda``, ``usdc`` or ``usdz``, made from one of `seeds`."""
    chance = random.Random(f"{form} {seed} {number}")
    names = sorted(name for name in seeds if form == "usdz" or name.endswith(form))
    name = chance.choice(names)
    if form == "usdz":
        return _archive(name, seeds[name], chance)
    return _damaged(name, seeds[name], chance)


def package(name: str, content: bytes, checksum: int | None = None, first: bytes = b"") -> bytes:
    """A usdz of one layer, its data aligned to 64 bytes; `checksum` may be wrong, `first` stands before it."""
    padding = -(len(first) + 30 + len(name) + 4) % 64
    extra = struct.pack("<HH", 0x1986, padding) + bytes(padding)
    total = zlib.crc32(content) if checksum is None else checksum
    fields = (20, 0, 0, 0, 0x21, total, len(content), len(content), len(name), len(extra))
    local = struct.pack("<4s5H3L2H", b"PK\3\4", *fields) + name.encode() + extra
    central = struct.pack("<4s6H3L5H2L", b"PK\1\2", 20, *fields, 0, 0, 0, 0, len(first)) + name.encode() + extra
    place = len(first) + len(local) + len(content)
    end = struct.pack("<4s4H2LH", b"PK\5\6", 0, 0, 1, 1, len(central), place, 0)
    return first + local + content + central + end


def _damaged(name: str, content: bytes, chance: random.Random) -> bytes:
    ways = _TEXT if name.endswith("usda") else _BINARY
    for _ in range(chance.choice((1, 1, 1, 1, 2, 4))):
        content = chance.choice(ways)(content, chance)
    return content


def _archive(name: str, content: bytes, chance: random.Random) -> bytes:
    """Half of the damage is inside a sound archive, half is to the archive itself."""
    if chance.random() < 0.5:
        return package(name, _damaged(name, content, chance))
    if chance.random() < 0.2:
        return _compressed(name, content)
    whole = package(name, content)
    for _ in range(chance.choice((1, 1, 2, 4))):
        near_headers = chance.random() < 0.7
        way = chance.choice(_BINARY)
        whole = _at_headers(whole, chance) if near_headers else way(whole, chance)
    return whole


def _compressed(name: str, content: bytes) -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(zipfile.ZipInfo(name), content)
    return buffer.getvalue()


def _at_headers(content: bytes, chance: random.Random) -> bytes:
    """A changed field of one of the archive's headers."""
    starts = [match.start() for match in re.finditer(rb"PK[\1\3\5][\2\4\6]", content)] or [0]
    place = chance.choice(starts) + chance.randrange(46)
    return _patched(content, min(place, max(0, len(content) - 4)), chance.choice((1, 2, 4)), chance)


# --- text --------------------------------------------------------------------------------------------


def _number(content: bytes, chance: random.Random) -> bytes:
    found = list(re.finditer(rb"(?<![\w.])-?\d+(\.\d+)?(e-?\d+)?(?!\w)", content))
    texts = _NUMBERS if chance.random() < 0.9 else _NO_NUMBERS
    return _with(content, chance.choice(found), chance.choice(texts)) if found else content


def _word(content: bytes, chance: random.Random) -> bytes:
    found = list(re.finditer(rb"[A-Za-z_:]{3,}(\[\])?", content))
    return _with(content, chance.choice(found), chance.choice(_WORDS)) if found else content


def _mark(content: bytes, chance: random.Random) -> bytes:
    found = list(re.finditer(rb'[\[\](){}<>@",=]', content))
    return _with(content, chance.choice(found), chance.choice('[](){}<>@",= \n\0\xff')) if found else content


def _line(content: bytes, chance: random.Random) -> bytes:
    lines = content.split(b"\n")
    place, other = chance.randrange(len(lines)), chance.randrange(len(lines))
    way = chance.randrange(4)
    if way == 0:
        del lines[place]
    elif way == 1:
        lines.insert(place, lines[other])
    elif way == 2:
        lines[place], lines[other] = lines[other], lines[place]
    else:
        first, last = sorted((place, other))
        lines[first : first + min(last - first, 20)] = []
    return b"\n".join(lines)


def _items(content: bytes, chance: random.Random) -> bytes:
    """An array with items added or taken away."""
    found = list(re.finditer(rb"\[[^\[\]]*,[^\[\]]*\]", content))
    if not found:
        return content
    match = chance.choice(found)
    items = match.group()[1:-1].split(b", ")
    place = chance.randrange(len(items))
    items = items[:place] if chance.random() < 0.5 else items[: place + 1] * chance.choice((2, 3))
    return content[: match.start()] + b"[" + b", ".join(items) + b"]" + content[match.end() :]


def _nested(content: bytes, chance: random.Random) -> bytes:
    depth = chance.choice((10, 1000, 30_000))
    opening, closing = chance.choice(((b'def "a" {\n', b"}\n"), (b"[", b"]"), (b"(", b")"), (b"{", b"}")))
    place = chance.choice([match.end() for match in re.finditer(rb"\n", content)] or [0])
    return content[:place] + opening * depth + closing * depth + content[place:]


def _with(content: bytes, match: re.Match[bytes], text: str) -> bytes:
    return content[: match.start()] + text.encode("latin-1") + content[match.end() :]


# --- bytes -------------------------------------------------------------------------------------------


def _bit(content: bytes, chance: random.Random) -> bytes:
    if not content:
        return content
    place = chance.randrange(len(content))
    return content[:place] + bytes([content[place] ^ 1 << chance.randrange(8)]) + content[place + 1 :]


def _field(content: bytes, chance: random.Random) -> bytes:
    width = chance.choice((1, 2, 4, 8))
    if len(content) < 8:
        return content
    return _patched(content, chance.randrange(len(content) - 7) // width * width, width, chance)


def _structure(content: bytes, chance: random.Random) -> bytes:
    """A changed number in the header or the table of sections of a crate file, or in what they point to."""
    if len(content) < 100 or content[:8] != b"PXR-USDC":
        return _field(content, chance)
    (table,) = struct.unpack_from("<Q", content, 16)
    places = [8, 16]
    if table + 8 <= len(content):
        count = min(struct.unpack_from("<Q", content, table)[0], 8)
        entries = [table + 8 + 32 * i for i in range(count) if table + 40 + 32 * i <= len(content)]
        starts = [struct.unpack_from("<Q", content, entry + 16)[0] for entry in entries]
        places += [table, *(entry + 16 for entry in entries), *(entry + 24 for entry in entries)]
        places += [start + 4 * chance.randrange(40) for start in starts]
    place = chance.choice([each for each in places if each + 8 <= len(content)])
    return _patched(content, place, chance.choice((1, 4, 8)), chance)


def _cut(content: bytes, chance: random.Random) -> bytes:
    return content[: chance.randrange(len(content) + 1)]


def _hole(content: bytes, chance: random.Random) -> bytes:
    place, size = chance.randrange(len(content) + 1), chance.choice((1, 8, 64, 512))
    filler = chance.choice((b"", bytes(size), b"\xff" * size, chance.randbytes(size)))
    return content[:place] + filler + content[place + size :]


def _copy(content: bytes, chance: random.Random) -> bytes:
    place, origin, size = (chance.randrange(len(content) + 1) for _ in range(3))
    return content[:place] + content[origin : origin + size % 300] + content[place + size % 300 :]


def _patched(content: bytes, place: int, width: int, chance: random.Random) -> bytes:
    old = int.from_bytes(content[place : place + width], "little")
    new = chance.choice((old + 1, old - 1, old * 2, old ^ 1 << chance.randrange(8 * width), chance.choice(_WIDE)))
    return content[:place] + (new % (1 << 8 * width)).to_bytes(width, "little") + content[place + width :]


_Way = Callable[[bytes, random.Random], bytes]
_TEXT: tuple[_Way, ...] = (
    *(_number,) * 12,
    *(_items,) * 6,
    *(_word,) * 3,
    *(_line,) * 2,
    *(_mark, _nested, _bit, _cut, _hole, _copy),
)
_BINARY: tuple[_Way, ...] = (
    *(_bit,) * 3,
    *(_field,) * 2,
    *(_structure,) * 3,
    *(_cut, _hole, _copy),
)
