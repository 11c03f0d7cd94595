"""Records as JSON documents, by the names of their fields."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import msgspec


def document(kind: str, **content: Any) -> str:
    """A document of the format ``usdrigui.KIND``, version 1: UTF-8, two-space indent."""
    whole = {"format": f"usdrigui.{kind}", "version": 1, **content}
    return json.dumps(plain(whole), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """Records, arrays and tables as JSON has them; it has no NaN and no infinity, for which null
    stands."""
    told = json.dumps(msgspec.to_builtins(value, str_keys=True, enc_hook=_plain))
    return json.loads(told, parse_constant=lambda _: None)


def _plain(value: Any) -> Any:
    """What msgspec does not know: tables that cannot be changed, and what numpy has."""
    return dict(value) if isinstance(value, Mapping) else value.tolist()
