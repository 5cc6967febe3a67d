# SPDX-License-Identifier: Apache-2.0
"""What generated_rtl/NAME/ says of one configuration: how it was made, its co-simulations, area and clock."""

from ..base.errors import EXIT_MISMATCH, FlowError
from ..base.tools import GENERATED_RTL
from ..cosim import record as cosim_record
from ..synthesis import manifest
from . import figures, job as implement


class Configuration:
    """The committed files of one configuration. `targets` is empty when it is not implemented yet, and, if `stale_is_none`,
    when it was implemented from other VHDL."""

    def __init__(self, name, stale_is_none=False):
        self.name = name
        self.manifest = manifest.read(GENERATED_RTL / name)
        self.parameters = self.manifest["parameters"]
        result = implement.read(GENERATED_RTL / name)
        self.stale = result is not None and not implement.is_fresh(result, self.manifest)
        if self.stale and stale_is_none:
            result = None
        elif self.stale:
            raise FlowError(
                f"generated_rtl/{name}/implementation.json is of other VHDL; run scripts/implement.py --config {name}",
                EXIT_MISMATCH,
            )
        self.targets = result["targets"] if result else {}
        self.cosimulations = cosim_record.read(GENERATED_RTL / name, self.manifest)

    def size(self):
        p = self.parameters
        return f"{p['width_px']}x{p['height_px']}, D={p['disparities']}, {p['window_px']}x{p['window_px']}, P={p['pixels_per_clock']}"

    def clock(self):
        """Routed clock and what follows from it, or {} when there is none."""
        routed = self.targets.get("ecp5")
        if not routed:
            return {}
        median = routed["fmax_mhz"]["median"]
        return {
            "median": median,
            "best": routed["fmax_mhz"]["best"],
            "path": routed["critical_path"],
            **figures.speed(self.parameters, median, figures.lut_count(routed)),
        }
