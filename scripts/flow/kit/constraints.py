# SPDX-License-Identifier: Apache-2.0
"""The one constraint of a core, its clock, and where that comes from."""

from ..implementation.results import Configuration
from ..implementation.targets import ROUTED, TARGETS
from .fill import fill
from .subject import CLOCK, Subject

DEFAULT_MHZ = 100.0


def measured(config: str) -> list[str]:
    """Sentences on the clocks that were placed and routed."""
    results = Configuration(config, stale_is_none=True)
    said = []
    for target in ROUTED:
        for shell, what in ((True, "in the AXI shell"), (False, "the core alone")):
            clock = results.clock(target, shell)
            if clock:
                command = f"scripts/implement.py --config {config} --target {target}" + (" --shell" if shell else "")
                mhz = f"{clock['median']:.1f} MHz, {clock['of']}"
                said.append(f"{TARGETS[target].device}, {what}: {mhz} ({command}).")
    return said or ["The clock of this configuration has not been measured."]


def text(subject: Subject, mhz: float) -> str:
    """The same words are XDC and SDC."""
    return fill(
        "clock.sdc",
        top=subject.top,
        clock=CLOCK,
        period=f"{1000 / mhz:.3f}",
        mhz=f"{mhz:g}",
        measured="\n".join(f"# {sentence}" for sentence in measured(subject.config)),
    )
