"""Values of ``set`` as TOML in one line."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence

from ._asked import shown
from ._errors import InputError, refused

_MOST = 2**63


def value(key: str, found: object) -> str:
    """``found`` as TOML."""
    try:
        return _value(key, found)
    except RecursionError:
        raise _wrong(key, found) from None


def _value(key: str, found: object) -> str:
    if isinstance(found, bool):
        return "true" if found else "false"
    if isinstance(found, int) and -_MOST <= found < _MOST:
        return str(int(found))
    if isinstance(found, float) and math.isfinite(found):
        return repr(float(found))
    if isinstance(found, str) and not any("\ud800" <= letter <= "\udfff" for letter in found):
        return _text(found)
    if isinstance(found, Mapping):
        return "{ " + ", ".join(f"{_text(str(name))} = {_value(key, one)}" for name, one in found.items()) + " }"
    if isinstance(found, Sequence) and not isinstance(found, str | bytes):
        return "[" + ", ".join(_value(key, one) for one in found) + "]"
    # Numbers and arrays of NumPy.
    if hasattr(found, "tolist"):
        return _value(key, found.tolist())
    raise _wrong(key, found)


def _text(text: str) -> str:
    # TOML has no escapes in pairs, as JSON has them for what lies beyond 16 bits, and no bare DEL.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _wrong(key: str, found: object) -> InputError:
    expected = "a number of TOML, a text, true or false, or a list or dictionary of them"
    return refused("set", f"`{key}` is {shown(found)}", found=shown(found), expected=expected)
