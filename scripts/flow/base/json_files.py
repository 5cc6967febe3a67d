# SPDX-License-Identifier: Apache-2.0
"""JSON from files that anyone may have damaged."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from .errors import FlowError


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
