# SPDX-License-Identifier: Apache-2.0
"""The page about one demo: what the disparity map, the co-simulations, the synthesis and the implementation gave, what
others have published, and the command that prints each number again."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path

from ..base.errors import FlowError
from ..base.tools import ROOT, Word
from ..cosim import mismatch
from ..implementation import figures
from ..implementation.record import Result
from ..implementation.results import Configuration
from ..implementation.targets import TARGETS
from ..rendering import page, pictures
from ..rendering.page import number
from ..rendering.pictures import Array, Picture
from ..synthesis.manifest import with_use
from . import map_pictures, performance, published
from .demo_folder import COSIMS, MAP, VALID, Demo, Match, Truth

PROGRAM = "build/release/stereo_hls"


# --- commands ---------------------------------------------------------------------------------------------------------


def _command(*words: Word) -> str:
    return " ".join(shlex.quote(str(word)) for word in words)


def _pair_options(match: Match) -> list[str]:
    fit = [] if match["fit"] == "none" else ["--fit", match["fit"]]
    return ["--config", match["config"], "--left", match["left"], "--right", match["right"], *fit]


def match_commands(demo: Demo) -> list[str]:
    """How the pair and its disparity map were made; a pair with ground truth is a generated scene."""
    match, commands = demo.match, []
    truth: list[str] = []
    if "truth" in match:
        scene, seed = Path(match["left"]).parent, demo.cosims[0]["seed"]
        commands.append(_command(PROGRAM, "scene", "--config", match["config"], "--seed", seed, "--out", scene))
        truth = ["--truth", match["truth"]["disparity"], "--visible", match["truth"]["visible"]]
    commands.append(_command(PROGRAM, "match", *_pair_options(match), *truth, "--out", "build/match"))
    return commands


# --- pictures ---------------------------------------------------------------------------------------------------------


def _named(name: str) -> Path:
    """A file that a JSON of the demo names: relative to the project, or to where one is."""
    return ROOT / name if (ROOT / name).exists() else Path(name)


def _optional(notes: list[str], what: str, load: Callable[[], Array]) -> Array | None:
    """What `load` gives, or None with a note for the page: the demo's folder does not hold the user's pair."""
    try:
        return load()
    except FlowError as error:
        notes.append(f"No picture of {what}: {error}.")
        return None


def _pair(match: Match, notes: list[str]) -> dict[str, Array]:
    """The images that are there, by side."""
    pair = {}
    for side, name in (("left", match["left"]), ("right", match["right"])):

        def load(name: str = name) -> Array:
            return map_pictures.fitted(pictures.load(_named(name), gray=True), match)

        image = _optional(notes, f"the {side} image", load)
        if image is not None:
            pair[side] = image
    return pair


def _truth(match: Match, notes: list[str]) -> tuple[Array, Array] | None:
    """(true disparities, which pixels the other image shows)"""
    if "truth" not in match:
        return None
    names = match["truth"]
    truth = _optional(notes, "the errors", lambda: pictures.load(_named(names["disparity"])).astype(float))
    if truth is None:
        return None
    visible = _optional(notes, "the errors", lambda: pictures.load(_named(names["visible"])))
    return None if visible is None else (truth, visible)


def _map(demo: Demo) -> tuple[Array, Array]:
    """(disparities in pixels, which of them are valid)"""
    numpy, _ = pictures.libraries()
    match = demo.match
    values = match["min_disparity"] + pictures.load(demo.folder / MAP).astype(float) / match["disparity_steps_per_px"]
    valid: Array = numpy.ones(values.shape, bool)
    if demo.has_checks:
        valid = pictures.load(demo.folder / VALID) != 0
    if values.shape != (match["output_height_px"], match["output_width_px"]) or valid.shape != values.shape:
        raise FlowError(
            f"{demo.folder / MAP} is damaged: its size is not the one in match.json; make it again with scripts/demo.sh"
        )
    return values, valid


def draw(demo: Demo) -> tuple[list[Picture], list[str]]:
    """(pictures in their order, notes on those that cannot be drawn)"""
    match = demo.match
    notes: list[str] = []
    values, valid = _map(demo)
    pair = _pair(match, notes)
    drawn = [_side(match, side, image) for side, image in pair.items()]
    drawn.append(map_pictures.of_map(match, values, valid))
    known = _truth(match, notes)
    if known:
        picture, bad = map_pictures.of_errors(match, values, valid, *known)
        drawn.append(picture)
        if bad != match["truth"]["bad_px"]:
            notes.append(
                f"The error picture shows {bad:,} bad pixels, match.json counts {match['truth']['bad_px']:,}: "
                "the files are not of one run."
            )
    if demo.has_checks and match["reference"] in pair:
        reference = pair[match["reference"]]
        drawn.append(map_pictures.of_rejections(match, reference, values, valid, known))
    return drawn, notes


def _side(match: Match, side: str, image: Array) -> Picture:
    """One image of the pair."""
    is_reference = side == match["reference"]
    caption = "The reference: the map has its pixels." if is_reference else "The image in which matches are searched."
    return Picture(f"{side.capitalize()} image", pictures.png(image), caption, match["width_px"], match["height_px"])


# --- numbers ----------------------------------------------------------------------------------------------------------


def _beside(demo: Demo, text: str, value: int) -> str:
    """The paper's number, where the demo has the paper's size. `text`: with a place for it."""
    return text.format(f"{value:,}") if demo.is_papers_size else ""


def key_figures(demo: Demo) -> list[tuple[str, str, str]]:
    """(number, what it is, beside it) for the top of the page."""
    cards, paper = [], "2007 paper: {}"
    if demo.whole_frames:
        clocks = _beside(demo, paper, published.PAPER_CLOCKS_PER_FRAME)
        cards.append((number(demo.whole_frames["clocks_per_frame"]), "clocks a frame", clocks))
    clock = demo.core.clock()
    if clock:
        cards.append((f"{clock['median']:.0f} MHz", "on ECP5, placed and routed", ""))
        frames = _beside(demo, paper, published.PAPER_FRAMES_PER_SECOND)
        cards.append((number(clock["frames_per_second"]), "frames a second at that clock", frames))
    if "ecp5" in demo.core.targets:
        cards.append((number(figures.lut_count(demo.core.targets["ecp5"])), "look-up tables on ECP5", ""))
    bits = _beside(demo, paper, published.PAPER_MEMORY_BITS)
    cards.append((number(demo.tool["memory_bits"]), "memory bits", bits))
    if "truth" in demo.match:
        truth = demo.match["truth"]
        cards.append((f"{bad_percent(truth):.2f} %", "bad pixels", f"off by more than {truth['tolerance_px']} px"))
    return cards


Rows = list[tuple[str, str, str]]  # (what, this core, the paper)


def hardware(demo: Demo) -> list[tuple[str, Rows]]:
    """The numbers under the command that prints them."""
    name = demo.match["config"]
    sections = [
        ((demo.whole_frames or demo.cosims[0])["command"], _clock_rows(demo)),
        (f"scripts/performance.py --config {name}", _size_rows(demo)),
        (f"scripts/synthesize.py --config {name}    (needs Bambu)", _synthesis_rows(demo)),
    ]
    for target, result in demo.core.targets.items():
        sections.append((f"scripts/implement.py --config {name} --target {target}", _target_rows(demo, target, result)))
    return sections


def _clock_rows(demo: Demo) -> Rows:
    whole, paper = demo.whole_frames, number(published.PAPER_CLOCKS_PER_FRAME)
    back_to_back = ", frames back to back" if whole and whole["frames"] > 1 else ""
    return [
        ("clocks a frame" + back_to_back, number(whole["clocks_per_frame"] if whole else None), paper),
        ("latency, clocks", number((whole or demo.cosims[0])["latency_clocks"]), "–"),
    ]


def _size_rows(demo: Demo) -> Rows:
    paper_evaluations = figures.evaluations_per_frame(published.PAPER) / published.PAPER_CLOCKS_PER_FRAME
    evaluations = figures.evaluations_per_clock(demo.core.parameters)
    return [
        ("disparity evaluations a clock", number(evaluations), number(paper_evaluations, 1)),
        ("memory bits", number(demo.tool["memory_bits"]), number(published.PAPER_MEMORY_BITS)),
        ("register bits", number(demo.tool["register_bits"]), "–"),
    ]


def _synthesis_rows(demo: Demo) -> Rows:
    tool = demo.tool
    return [
        ("registers, of them named as in C++", f"{tool['registers']:,}, {tool['registers_named']:,}", "–"),
        ("states, of them in the loop", f"{tool['states']}, {tool['loop_states']}", "–"),
    ]


def _target_rows(demo: Demo, target: str, result: Result) -> Rows:
    luts = f"{target}: look-up tables ({TARGETS[target].family.lut_name})"
    paper_luts = f"{number(published.PAPER_ALUTS)} (Stratix II)" if target == "cyclonev" else "–"
    rows = [
        (luts, number(figures.lut_count(result)), paper_luts),
        (f"{target}: flip-flops", number(result["ffs"]), "–"),
        (f"{target}: block RAMs", number(result["block_rams"]), "–"),
    ]
    clock = demo.core.clock(target)
    if clock is None:
        return rows
    mhz = f"{target}: MHz after place and route, {clock['of']} (best)"
    paper_speed = published.PAPER_FRAMES_PER_SECOND * figures.evaluations_per_frame(published.PAPER) / 1e6
    return [
        *rows,
        (mhz, f"{clock['median']:.1f} ({clock['best']:.1f})", f"{published.PAPER_MHZ} (Stratix II)"),
        (
            f"{target}: frames a second at that clock",
            number(clock["frames_per_second"]),
            number(published.PAPER_FRAMES_PER_SECOND),
        ),
        (f"{target}: million disparity evaluations a second", number(clock["mde_per_second"]), number(paper_speed)),
    ]


def comparisons() -> list[performance.Grid]:
    """What performance.py writes into docs/performance.md; a result of other VHDL counts as none."""

    def make(name: str) -> Configuration:
        return Configuration(name, stale_is_none=True)

    papers = [make(name) for name in with_use("paper")]
    return [performance.comparison(papers), performance.systems(make)]


def bad_percent(truth: Truth) -> float:
    return page.percent(truth["bad_px"], truth["compared_px"])


# --- writing ----------------------------------------------------------------------------------------------------------


def render(demo: Demo) -> str:
    drawn, notes = draw(demo)
    failures = [
        mismatch.read(demo.folder / name, demo.core.parameters)
        for name, cosim in zip(COSIMS, demo.cosims)
        if not cosim["passed"]
    ]
    return page.render(
        "report.html.j2",
        demo=demo,
        match=demo.match,
        truth=demo.match.get("truth"),
        pictures=drawn,
        notes=notes,
        scale=pictures.scale_png(),
        cards=key_figures(demo),
        match_commands=match_commands(demo),
        cosims=demo.cosims,
        hardware=hardware(demo),
        comparisons=comparisons(),
        bad_percent=bad_percent,
        failures=[failure for failure in failures if failure],
        size={**published.PAPER, "window_px": published.PAPER_WINDOW_PX},
    )


def summary(demo: Demo) -> str:
    """The key facts in a few lines of text."""
    parts = [f"{cosim['compared']:,} of {cosim['expected']:,} outputs in {cosim['simulator']}" for cosim in demo.cosims]
    mismatches = sum(cosim["mismatches"] for cosim in demo.cosims)
    verdict, paper = "PASS" if demo.passed else "FAIL", " (2007 paper: {})"
    lines = [f"{verdict}: VHDL against C++ core, {demo.match['config']}: {', '.join(parts)}; {mismatches:,} mismatches"]
    facts, tool = [], demo.tool
    if demo.whole_frames is not None:
        clocks = _beside(demo, paper, published.PAPER_CLOCKS_PER_FRAME)
        facts.append(f"{demo.whole_frames['clocks_per_frame']:,} clocks a frame{clocks}")
        facts.append(f"latency {number(demo.whole_frames['latency_clocks'])} clocks")
    if "truth" in demo.match:
        facts.append(f"{bad_percent(demo.match['truth']):.2f} % bad pixels against the ground truth")
    if facts:
        lines.append(", ".join(facts))
    bits = _beside(demo, paper, published.PAPER_MEMORY_BITS)
    lines.append(f"{tool['memory_bits']:,} memory bits{bits}, {tool['register_bits']:,} register bits")
    return "\n".join(lines)
