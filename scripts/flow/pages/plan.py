# SPDX-License-Identifier: Apache-2.0
"""docs/plan.md: what fits which device, and how good the estimates behind it are, from committed files only."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path

from ..base.markdown import UNKNOWN, code, number
from ..base.tools import ROOT
from ..planning import plan_text, search
from ..planning.candidates import Camera
from ..planning.compared import Compared, compare, size_of
from ..planning.devices import device_of, lut_name, netlist_of, targets, title_of
from ..planning.model import BASE, CLOCK, REGISTERS, WORK, Model
from . import plan_picture
from .plan_algorithms import algorithms

PAGE = ROOT / "docs" / "plan.md"
TEXT = Path(__file__).parent / "texts" / "plan.md"
FILL, MARGIN = 85, 20  # the defaults of plan.py
CAMERAS = (
    Camera(320, 240, 64, 60),
    Camera(320, 240, 100, 60),
    Camera(640, 480, 64, 30),
    Camera(640, 480, 128, 60),
    Camera(1280, 720, 128, 30),
)


def pages() -> dict[Path, str]:
    planner = search.Planner(algorithms())
    found = compare(planner.known)
    text = TEXT.read_text().format(
        cameras=" | ".join(_camera(camera) for camera in CAMERAS),
        lines="---|" * len(CAMERAS),
        devices="\n".join(_device_row(planner, target) for target in targets() if device_of(target)),
        work="\n".join(f"| {word} | {luts:.2f} |" for word, luts in zip(WORK, planner.model.work_luts)),
        families=_families(planner.model),
        registers="\n".join(
            f"| {word} | {factor:.2f} |" for word, factor in zip(REGISTERS, planner.model.register_flip_flops)
        ),
        register_families=_register_families(planner.model),
        covered=_covered(planner.model),
        clock="\n".join(_clock_rows(planner.model)),
        sites=_sites(planner.model),
        summary="\n".join(summary(found)),
        cores="\n".join(_core_row(one) for one in found),
    )
    return {PAGE: text, plan_picture.PICTURE: plan_picture.picture(planner)}


def _camera(camera: Camera) -> str:
    size = f"{camera.width_px}x{camera.height_px}, D={camera.disparities}"
    return f"{size}, {camera.frames_per_second:g} a second"


def _device_row(planner: search.Planner, target: str) -> str:
    device, cells = device_of(target), []
    assert device is not None  # as its caller has it
    for camera in CAMERAS:
        fitting = search.best(planner.plan(camera, search.Place(target, device, FILL, MARGIN)))
        cells.append(_taken(fitting[search.recommended(fitting)]) if fitting else UNKNOWN)
    return f"| {title_of(target)} | {' | '.join(cells)} |"


def _taken(planned: search.Planned) -> str:
    """The algorithm, and what it takes."""
    row = f", {code(planned.row)}" if planned.row else ""
    n = planned.numbers
    luts, flip_flops, block_rams = (one.value if one else None for one in (n.luts, n.flip_flops, n.block_rams))
    taken = f"{number(luts)} LUTs, {number(flip_flops)} flip-flops, {number(block_rams)} block RAMs"
    title, config = planned.candidate.algorithm.title, code(planned.candidate.algorithm.config)
    name = title if config in title else f"{config}, {title}"
    return f"{name}, {plan_text.speed(planned)}: {taken}{row}"


def _families(model: Model) -> str:
    others = {name: scale for name, scale in model.family_luts.items() if name != BASE}
    return ", ".join(f"{scale:.2f} {lut_name(name)} on {name}" for name, scale in others.items()) or "none yet"


def _register_families(model: Model) -> str:
    others = {name: scale for name, scale in model.family_flip_flops.items() if name != BASE}
    return ", ".join(f"{scale:.2f} on {name}" for name, scale in others.items()) or "none yet"


def _covered(model: Model) -> str:
    return ", ".join(f"{factor:.2f} on {name}" for name, factor in model.covered_ffs.items()) or "none yet"


def _sites(model: Model) -> str:
    return ", ".join(
        f"{name} {sites.of_lut:.2f}, {sites.of_flip_flop:.2f}, {sites.beside:.0f}"
        for name, sites in model.sites.items()
    )


def _clock_rows(model: Model) -> list[str]:
    rows = [f"| {word} | {factor:.3f} |" for word, factor in zip(CLOCK, model.clock)]
    grades = list(model.grades())[1:]
    return rows + [
        f"| {title_of(target)} | {factor:.3f} |" for target, factor in zip(grades, model.clock[len(CLOCK) :])
    ]


Error = Callable[[Compared], "float | None"]


def _netlists(found: Iterable[Compared]) -> list[Compared]:
    """Each netlist once, on however many devices it is."""
    kept: dict[tuple[str, str], Compared] = {}
    for one in found:
        kept.setdefault((one.core.name, netlist_of(one.core.target)), one)
    return list(kept.values())


def summary(found: Sequence[Compared]) -> list[str]:
    """Of LUTs, LUT sites, flip-flops, block RAMs and clock: how many cores, the median error, the bar, the worst."""
    netlists = _netlists(found)
    rows = [_summary_row("look-up tables", netlists, lambda one: one.luts_error, "12 %")]
    rows.append(_summary_row("LUT sites", netlists, lambda one: one.lut_sites_error, "12 %"))
    rows.append(_summary_row("flip-flops", netlists, lambda one: one.flip_flops_error, "12 %"))
    counted = [one for one in netlists if one.block_rams_error is not None]
    wrong = [one for one in counted if one.block_rams_error]
    said = (f"{code(one.core.name)}: {one.block_rams} instead of {one.core.result['block_rams']}" for one in wrong)
    worst = ", ".join(dict.fromkeys(said))  # several netlists of a core may say the same
    exact = f"{len(counted) - len(wrong)} exact"
    rows.append(f"| block RAMs | {len(counted)} | {exact} | exact | {worst or UNKNOWN} |")
    return [*rows, _summary_row("clock", found, lambda one: one.mhz_error, "20 %")]


def _summary_row(title: str, found: Sequence[Compared], error: Error, bar: str) -> str:
    known = [(value, one) for one in found if (value := error(one)) is not None]
    middle = size_of(value for value, _ in known)
    if middle is None:
        return f"| {title} | 0 | {UNKNOWN} | {bar} | {UNKNOWN} |"
    value, one = max(known, key=lambda pair: abs(pair[0]))
    device = title_of(one.core.target)
    worst = f"{100 * value:+.0f} %, {code(one.core.name)}, {device}"
    return f"| {title} | {len(known)} | {100 * middle:.1f} % | {bar} | {worst} |"


def _percent(error: float | None) -> str:
    return UNKNOWN if error is None else f"{100 * error:+.1f} %"


def _core_row(one: Compared) -> str:
    cells = [
        code(one.core.name),
        title_of(one.core.target),
        number(one.core.luts),
        number(one.luts),
        _percent(one.luts_error),
        number(one.core.flip_flops),
        number(one.flip_flops),
        _percent(one.flip_flops_error),
        number(one.core.result["block_rams"]),
        number(one.block_rams),
        number(one.core.mhz, 1),
        number(one.mhz, 1),
        _percent(one.mhz_error),
    ]
    return f"| {' | '.join(cells)} |"
