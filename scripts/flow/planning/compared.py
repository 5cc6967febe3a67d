# SPDX-License-Identifier: Apache-2.0
"""How good the model is: each routed core against what the others say of it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from statistics import median

from . import cores, ram
from .model import Core, Implemented, Model, is_modelled


@dataclass(frozen=True)
class Compared:
    """A core on a target, measured and estimated; None where nothing is estimated."""

    core: Implemented
    luts: int | None
    block_rams: int | None
    mhz: float | None
    flip_flops: int | None = None
    lut_sites: int | None = None

    @property
    def lut_sites_error(self) -> float | None:
        taken = self.core.lut_sites
        return None if self.lut_sites is None or taken is None else self.lut_sites / taken - 1

    @property
    def flip_flops_error(self) -> float | None:
        return None if self.flip_flops is None else self.flip_flops / self.core.flip_flops - 1

    @property
    def luts_error(self) -> float | None:
        return None if self.luts is None else self.luts / self.core.luts - 1

    @property
    def block_rams_error(self) -> int | None:
        return None if self.block_rams is None else self.block_rams - self.core.result["block_rams"]

    @property
    def mhz_error(self) -> float | None:
        return None if self.mhz is None or not self.core.mhz else self.mhz / self.core.mhz - 1


def _block_rams(core: Implemented) -> int | None:
    """From the options, or where they do not say them, from the memories in the VHDL."""
    family = ram.family_of(core.target)
    if family is None:
        return None
    has_shape = is_modelled(core)
    memories = cores.memories_of(cores.shape_of(core.options)) if has_shape else cores.memories_in_vhdl(core.name)
    return ram.mapped(memories, family, cores.shows_word_before(core.options)).block_rams


def compare(measured: Sequence[Implemented]) -> list[Compared]:
    """Of every core that was placed and routed, or is too large for it. Each is left out of its own estimate."""
    model, found = Model(measured), []
    others: dict[str, Model] = {}
    for core in measured:
        if "device" not in core.result:
            continue
        luts = mhz = flip_flops = sites = None
        if is_modelled(core):
            left = others.setdefault(core.name, model.without(core.name))
            sizes = Core(cores.shape_of(core.options))
            luts, mhz = left.luts(sizes, core.target), left.mhz(sizes, core.target)
            flip_flops = left.flip_flops(sizes, core.target)
            sites = left.lut_sites(luts or 0, left.flip_flop_sites(sizes, core.target) or 0, core.target)
        found.append(Compared(core, luts, _block_rams(core), mhz, flip_flops, sites))
    return found


def size_of(errors: Iterable[float | None]) -> float | None:
    """Median of the errors' sizes."""
    known = [abs(error) for error in errors if error is not None]
    return median(known) if known else None
