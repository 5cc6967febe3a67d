# SPDX-License-Identifier: Apache-2.0
"""What newer Pythons have and the oldest one that runs the commands (scripts/flow/__init__.py) has not."""

from __future__ import annotations

import platform
import sys
from typing import TYPE_CHECKING, Any

from .errors import EXIT_MISSING_TOOL, FlowError

if TYPE_CHECKING or sys.version_info >= (3, 11):
    from typing import NotRequired
else:

    class NotRequired:
        """Of a key of a TypedDict. Says nothing at run time."""

        def __class_getitem__(cls, kind: Any) -> Any:
            return kind


__all__ = ["NotRequired", "need_python"]


def need_python(version: tuple[int, int], what: str) -> None:
    """Refuses an older one in a sentence. `what` needs it."""
    if sys.version_info < version:
        wanted = ".".join(map(str, version))
        raise FlowError(
            f"{what} needs Python {wanted} or later; {sys.executable} is {platform.python_version()}", EXIT_MISSING_TOOL
        )
