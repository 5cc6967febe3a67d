# SPDX-License-Identifier: Apache-2.0
"""What is committed of one configuration: how it was made, its co-simulations, area and clock."""

from __future__ import annotations

from ..base import committed
from ..base.configurations import Size, option
from ..base.errors import EXIT_MISMATCH, FlowError
from ..cosim import record as cosim_record
from ..shell import design
from ..synthesis import manifest
from . import figures, record


class Clock(figures.Speed):
    """The routed clock, and what follows from it."""

    median: float
    best: float
    of: str  # how many seeds, and the router
    path: record.CriticalPath


class Configuration:
    """The committed files of one configuration. `targets` is empty when it is not implemented yet, and, if
    `stale_is_none`, when it was implemented from other VHDL."""

    def __init__(self, name: str, stale_is_none: bool = False) -> None:
        self.name = name
        folder = committed.folder(name)
        self.manifest = manifest.read(folder)
        self.parameters = self.manifest["parameters"]
        implemented = record.read(folder)
        self.stale = implemented is not None and not record.is_fresh(implemented, self.manifest)
        if self.stale and not stale_is_none:
            raise FlowError(
                f"{folder / record.FILE} is of other VHDL; run scripts/implement.py --config {name}",
                EXIT_MISMATCH,
            )
        fresh = implemented if implemented and not self.stale else None
        self.targets = fresh["targets"] if fresh else {}
        # Of stereo_ip_NAME; a result of an older shell is none.
        self.shell_targets = record.shell_results(fresh, design.digests()) if fresh else {}
        self.cosimulations = cosim_record.read(folder, self.manifest)

    def has(self, size: Size) -> bool:
        p = self.parameters
        return all(p[key] == size[key] for key in ("width_px", "height_px", "disparities"))

    def size(self) -> str:
        p = self.parameters
        window = option(p, "window_px")
        windows = f" {window}x{window}," if window else ""
        return f"{p['width_px']}x{p['height_px']}, D={p['disparities']},{windows} P={p['pixels_per_clock']}"

    def clock(self, target: str = "ecp5", shell: bool = False) -> Clock | None:
        """Of the core, or of the shell around it, where it was placed and routed."""
        routed = (self.shell_targets if shell else self.targets).get(target)
        if not routed or "fmax_mhz" not in routed:
            return None
        fmax = routed["fmax_mhz"]
        speed = figures.speed(self.parameters, fmax["median"], figures.lut_count(routed))
        return {
            "median": fmax["median"],
            "best": fmax["best"],
            "of": figures.counted(len(fmax["by_seed"]), routed.get("router")),
            "path": routed["critical_path"],
            **speed,
        }
