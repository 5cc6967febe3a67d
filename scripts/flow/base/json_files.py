# SPDX-License-Identifier: Apache-2.0
"""JSON from files that anyone may have damaged."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, get_args, get_origin, get_type_hints

from .errors import FlowError
from .newer_python import required


def load(path: Path) -> Any:
    """The content of a JSON file. Raises OSError, or ValueError with one sentence on what cannot be read or written
    again."""
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
        json.dumps(content, ensure_ascii=False).encode()  # JSON can name halves of characters that no file can hold
    except RecursionError:
        raise ValueError("nested too deeply") from None
    return content


def load_result(path: Path, form: str) -> dict[str, Any] | None:
    """The object of a result file that names its format, or None when there is no such file."""
    try:
        content = load(path)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        raise FlowError(f"damaged {path}: {getattr(error, 'strerror', None) or error}") from None
    if not isinstance(content, dict) or content.get("format") != form:
        raise damaged(path, form)
    return content


def damaged(path: Path, form: str) -> FlowError:
    return FlowError(f"damaged {path}: not of format '{form}'; remove it, and make it again")


def fits(value: object, kind: Any) -> bool:
    """Whether a value has the type that an annotation names: a TypedDict, a dict with names, a list, or a plain one."""
    if kind is Any:
        return True
    if get_origin(kind) is dict:
        return isinstance(value, dict) and all(fits(one, get_args(kind)[1]) for one in value.values())
    if get_origin(kind) is list:
        return isinstance(value, list) and all(fits(one, get_args(kind)[0]) for one in value)
    if hasattr(kind, "__total__"):
        hints = {key: required(hint) for key, hint in get_type_hints(kind, include_extras=True).items()}
        return isinstance(value, dict) and all(
            fits(value[key], hint) if key in value else not is_needed for key, (hint, is_needed) in hints.items()
        )
    if isinstance(value, bool):
        return kind is bool
    return isinstance(value, (int, float) if kind is float else kind)
