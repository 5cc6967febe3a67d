# SPDX-License-Identifier: Apache-2.0
"""Of the tools that make VHDL."""

from ..base.tools import find_bambu
from .bambu import tool_version


def versions() -> dict[str, str]:
    return {"bambu": tool_version(find_bambu())}
