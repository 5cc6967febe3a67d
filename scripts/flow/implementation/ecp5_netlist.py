# SPDX-License-Identifier: Apache-2.0
"""What yosys leaves undone in a netlist for ECP5: done on the JSON that nextpnr reads."""

import json
from collections import Counter
from pathlib import Path
from typing import Any

from .ecp5_carry import CarryPacker
from .ecp5_fanout import copy_wide_controls
from .ecp5_memory import use_output_registers
from .ecp5_reset import resets_to_logic


def improve(path: Path, top: str) -> dict[str, int]:
    """Rewrites the netlist. Returns {cell type: how many more it has}."""
    netlist = json.loads(path.read_text())
    module = netlist["modules"][top]
    before = _types(module)
    CarryPacker(module).run()
    use_output_registers(module)
    resets_to_logic(module)
    copy_wide_controls(module)
    path.write_text(json.dumps(netlist))
    after = _types(module)
    return {name: after[name] - before[name] for name in before}


def _types(module: dict[str, Any]) -> Counter[str]:
    return Counter(cell["type"] for cell in module["cells"].values())
