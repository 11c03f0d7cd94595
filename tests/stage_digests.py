"""What the public functions of some packages return while something runs, as short digests.

A digest has two parts.  Numbers, flags, words and the shape of records give a checksum, which must
be the same; floats give their count and two sums, which may differ in their last digits.
"""

from __future__ import annotations

import dataclasses
import functools
import importlib
import pkgutil
import re
import sys
import types
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from usdrigui.model.record import Record

TOLERANCE = 1e-6
"""Of sums of floats, as a share of the sum of what they amount to: some parts are single precision."""
FINE = 1e4
"""Floats count by the area sine of so many times themselves, lest large ones hide a change of small ones."""

CALLS = 60
"""Of each function in one scene; later ones are not looked at."""
OF_THE_MACHINE = ("reader_main", "reader_process", "temporaries", "source", "safe_write")
"""Modules whose functions return what differs from one machine or run to the next."""


class Digest:
    """A digest that grows."""

    def __init__(self, known: dict[int, tuple[Record, Digest]]) -> None:
        self.exact, self.count, self.total, self.turned = 0, 0, 0.0, 0.0
        self.calls = 0
        self._known = known

    def add(self, value: Any) -> None:
        """Take in a value and all that is in it."""
        match value:
            case bool() | np.bool_() | int() | np.integer() | str() | bytes() | None:
                self._note(value if isinstance(value, bytes) else _word(value).encode())
            case float() | np.floating():
                self._floats(np.array([value], dtype=np.float64))
            case np.ndarray() if value.dtype.kind == "f":
                self._note(repr(value.shape).encode())
                self._floats(value.astype(np.float64).ravel())
            case np.ndarray() if value.dtype.kind in "iub":
                self._note(repr(value.shape).encode() + value.astype(np.int64).tobytes())
            case Mapping():
                self._all(each for pair in value.items() for each in pair)
            case set() | frozenset():
                self._all(sorted(map(repr, value)))
            case list() | tuple():
                self._all(value)
            case Record():
                if id(value) not in self._known:
                    self._known[id(value)] = value, Digest(self._known)
                    self._known[id(value)][1]._fields(value)
                self._join(self._known[id(value)][1])
            case _ if dataclasses.is_dataclass(value) and not isinstance(value, type):
                self._fields(value)
            case _:
                self._note(type(value).__name__.encode())

    def read(self) -> list[Any]:
        """The digest as it is written."""
        return [f"{self.exact:08x}", self.count, float(f"{self.total:.9g}"), float(f"{self.turned:.9g}")]

    def _fields(self, record: Any) -> None:
        names = (each.name for each in dataclasses.fields(record) if each.name != "seconds")
        self._all(getattr(record, name) for name in names)

    def _join(self, other: Digest) -> None:
        self._note(b"%d %d" % (other.exact, other.count))
        self.turned += other.turned * float(np.cos(1.0 + self.count))
        self.total += other.total
        self.count += other.count

    def _all(self, values: Iterable[Any]) -> None:
        for each in values:
            self.add(each)
            self._note(b",")
        self._note(b";")

    def _note(self, text: bytes) -> None:
        self.exact = zlib.crc32(text, self.exact)

    def _floats(self, values: np.ndarray) -> None:
        known = np.where(np.isnan(values), 2e30, np.clip(values, -1e30, 1e30))
        felt = np.arcsinh(FINE * known)
        self.total += float(np.abs(felt).sum())
        self.turned += float(felt @ np.cos(1.0 + self.count + np.arange(len(felt))))
        self.count += len(felt)


def _word(value: Any) -> str:
    """A plain value as text, without the working folder, the random part of a name and the address of a layer."""
    text = repr(value.item() if isinstance(value, np.generic) else value)
    return re.sub(r"0x[0-9a-f]+|\.[0-9a-f-]{40,}\.rigui-tmp", "", text.replace(f"{Path.cwd()}/", ""))


def alike(found: list[Any], golden: list[Any]) -> bool:
    """Whether two digests say the same."""
    scale = TOLERANCE * max(1.0, golden[2])
    return found[:2] == golden[:2] and all(
        abs(one - other) <= scale for one, other in zip(found[2:], golden[2:], strict=True)
    )


@contextmanager
def returned(packages: tuple[str, ...]) -> Iterator[dict[str, Digest]]:
    """Digests of what each public function of the packages returns while this is entered, in the order of its calls."""
    digests: dict[str, Digest] = {}
    known: dict[int, tuple[Record, Digest]] = {}
    watched: dict[types.FunctionType, Callable[..., Any]] = {}

    def watching(function: types.FunctionType, name: str) -> Callable[..., Any]:
        @functools.wraps(function)
        def called(*given: Any, **named: Any) -> Any:
            value = function(*given, **named)
            digest = digests.setdefault(name, Digest(known))
            digest.calls += 1
            if digest.calls <= CALLS:
                digest.add(value)
            return value

        return called

    for package in packages:
        _import_all(f"usdrigui.{package}")
    with pytest.MonkeyPatch.context() as patch:
        for place, name, function in list(_functions(packages)):
            if function not in watched:
                shown = f"{function.__module__.removeprefix('usdrigui.')} {function.__qualname__}"
                watched[function] = watching(function, shown)
            patch.setattr(place, name, watched[function])
        yield digests


def _functions(packages: tuple[str, ...]) -> Iterator[tuple[Any, str, types.FunctionType]]:
    """Every place of the package that has a public function of the `packages`, with its name there; methods too.

    What functions remember of earlier calls is forgotten: each must be called.
    """
    of = tuple(f"usdrigui.{each}" for each in packages)
    for module in [each for name, each in sys.modules.items() if name.startswith("usdrigui")]:
        for name, value in vars(module).items():
            if isinstance(value, types.FunctionType):
                own = value.__module__.startswith(of) and not value.__module__.endswith(OF_THE_MACHINE)
                if own and not value.__name__.startswith("_"):
                    yield module, name, value
            elif hasattr(value, "cache_clear"):
                value.cache_clear()
            elif isinstance(value, type) and value.__module__ == module.__name__ and value.__module__.startswith(of):
                for method, each in vars(value).items():
                    if isinstance(each, types.FunctionType) and not method.startswith("_"):
                        yield value, method, each


def _import_all(package: str) -> None:
    """Import a package with all that is in it but for plug-ins, which USD imports itself."""
    found = importlib.import_module(package)
    for each in pkgutil.iter_modules(found.__path__, f"{package}."):
        if each.ispkg and not each.name.endswith(".validation"):
            _import_all(each.name)
        elif not each.ispkg:
            importlib.import_module(each.name)
