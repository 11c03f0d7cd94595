"""Records as JSON documents, by the names of their fields."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np


def document(kind: str, **content: Any) -> str:
    """A document of the format ``usdrigui.KIND``, version 1: UTF-8, two-space indent."""
    whole = {"format": f"usdrigui.{kind}", "version": 1, **content}
    return json.dumps(plain(whole), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def plain(value: Any) -> Any:
    """Records, arrays and tables as JSON has them; it has no NaN and no infinity, for which null
    stands."""
    if is_dataclass(value):
        return {each.name: plain(getattr(value, each.name)) for each in fields(value)}
    if isinstance(value, Mapping):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
