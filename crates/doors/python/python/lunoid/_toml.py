"""Values of ``set`` as TOML in one line."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence

from ._errors import refused


def value(key: str, found: object) -> str:
    """``found`` as TOML."""
    if isinstance(found, bool):
        return "true" if found else "false"
    if isinstance(found, int):
        return str(int(found))
    if isinstance(found, float) and math.isfinite(found):
        return repr(float(found))
    if isinstance(found, str):
        return json.dumps(found, ensure_ascii=False)
    if isinstance(found, Mapping):
        return "{ " + ", ".join(f"{json.dumps(str(name), ensure_ascii=False)} = {value(key, one)}" for name, one in found.items()) + " }"
    if isinstance(found, Sequence):
        return "[" + ", ".join(value(key, one) for one in found) + "]"
    if hasattr(found, "item"):
        return value(key, found.item())
    expected = "a number, a word, true or false, or a list of them"
    raise refused("set", f"`{key}` is {found!r}", found=repr(found), expected=expected)
