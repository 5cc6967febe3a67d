# SPDX-License-Identifier: Apache-2.0
"""The files and generics of a stereo_ip."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import cast

from ..base import committed, rtl
from ..base.errors import FlowError
from ..base.tools import ROOT
from ..synthesis import manifest

RTL = rtl.HAND_WRITTEN
# In compile order, after the core's own files.
SHELL = (
    "stream_register",
    "stream_fifo",
    "stream_credit",
    "stereo_framing",
    "stereo_frames",
    "frame_timer",
    "stereo_axis",
    "stereo_register_map",
    "stereo_registers",
    "stereo_shell",
)
JOINER = ("camera_queue", "stereo_joiner")  # of two cameras' streams, in front of any shell


def vhdl_files(config: str) -> list[Path]:
    """All files in compile order."""
    return [*manifest.core_files(config), *shell_files(), committed.folder(config) / f"{rtl.ip_entity(config)}.vhd"]


def shell_files(folder: Path | None = None) -> list[Path]:
    """`folder`: another one than the project's."""
    return [(folder or RTL) / f"{name}.vhd" for name in SHELL]


def joiner_files(folder: Path | None = None) -> list[Path]:
    """Of stereo_joiner alone, without what it shares with the shell."""
    return [(folder or RTL) / f"{name}.vhd" for name in JOINER]


def digests() -> manifest.Digests:
    """{file: SHA-256} of what stands around every core."""
    return {path.relative_to(ROOT).as_posix(): manifest.digest(path) for path in shell_files()}


def library_files(configs: Iterable[str]) -> list[Path]:
    """All files of several configurations in one library, in compile order, each once."""
    return list(dict.fromkeys(path for config in configs for path in vhdl_files(config)))


def generics(entry: manifest.Manifest) -> dict[str, int]:
    """What a user may state of a core, in the order of its entity."""
    values = cast(dict[str, int], entry["parameters"])
    missing = [name for name in rtl.GENERICS if not isinstance(values.get(name), int)]
    if missing:
        raise FlowError(f"the manifest of '{entry['configuration']}' says no {', '.join(missing)}")
    return {name: values[name] for name in rtl.GENERICS}
