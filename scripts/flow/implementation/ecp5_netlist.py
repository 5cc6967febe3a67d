# SPDX-License-Identifier: Apache-2.0
"""What yosys leaves undone in a netlist for ECP5: done on the JSON that nextpnr reads."""

from typing import Any

from .ecp5_carry import CarryPacker
from .ecp5_fanout import copy_wide_controls
from .ecp5_memory import use_output_registers
from .ecp5_reset import resets_to_logic


def improve(module: dict[str, Any]) -> None:
    CarryPacker(module).run()
    use_output_registers(module)
    resets_to_logic(module)
    copy_wide_controls(module)
