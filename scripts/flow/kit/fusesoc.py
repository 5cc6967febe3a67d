# SPDX-License-Identifier: Apache-2.0
"""A kit for FuseSoC: a core file of format CAPI2."""

from .fill import fill
from .subject import GENERIC, LIBRARY, Subject


def core(subject: Subject, sources: list[str], bench: str) -> str:
    """TOP.core. `sources`: in compile order, the top last."""
    return fill(
        "core.yml",
        config=subject.config,
        library=LIBRARY,
        top=subject.top,
        version=subject.version,
        generic=GENERIC,
        files="\n".join(f"      - {name}" for name in sources),
        bench=bench,
        bench_top=bench.rpartition("/")[2].removesuffix(".vhd"),
    )
