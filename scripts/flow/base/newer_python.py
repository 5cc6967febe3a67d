# SPDX-License-Identifier: Apache-2.0
"""What newer Pythons have and the oldest one that runs the commands (scripts/flow/__init__.py) has not."""

from __future__ import annotations

import platform
import sys
from typing import TYPE_CHECKING, Annotated, Any, get_args, get_origin

from .errors import EXIT_MISSING_TOOL, FlowError

if TYPE_CHECKING or sys.version_info >= (3, 11):
    from typing import NotRequired
else:

    class NotRequired:
        """Of a key of a TypedDict."""

        def __class_getitem__(cls, kind: Any) -> Any:
            return Annotated[kind, cls]


__all__ = ["NotRequired", "need_python", "required"]


def required(kind: Any) -> tuple[Any, bool]:
    """(kind of a key of a TypedDict without NotRequired, whether the key must be there)"""
    arguments = get_args(kind)
    is_optional = get_origin(kind) is NotRequired or NotRequired in arguments[1:]
    return (arguments[0], False) if is_optional else (kind, True)


def need_python(version: tuple[int, int], what: str) -> None:
    """Refuses an older one in a sentence. `what` needs it."""
    if sys.version_info < version:
        wanted = ".".join(map(str, version))
        raise FlowError(
            f"{what} needs Python {wanted} or later; {sys.executable} is {platform.python_version()}", EXIT_MISSING_TOOL
        )
