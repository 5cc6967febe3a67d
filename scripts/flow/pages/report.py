# SPDX-License-Identifier: Apache-2.0
"""The page about one demo: what the disparity map, the co-simulations, the synthesis and the implementation gave, what others
have published, and the command that prints each number again."""

import shlex
from pathlib import Path

from ..base.errors import FlowError
from ..base.families import PAPER, family
from ..base.tools import ROOT
from ..cosim import mismatch
from ..implementation import figures, job as implement
from ..implementation.results import Configuration
from ..implementation.yosys import TARGETS
from ..rendering import page, pictures
from ..rendering.page import number
from . import performance
from .demo_folder import COSIMS, MAP, VALID

PROGRAM = "build/release/stereo_hls"


# --- commands ---------------------------------------------------------------------------------------------------------


def _command(*words):
    return " ".join(shlex.quote(str(word)) for word in words)


def _pair_options(match):
    fit = [] if match["fit"] == "none" else ["--fit", match["fit"]]
    return ["--config", match["config"], "--left", match["left"], "--right", match["right"], *fit]


def match_commands(demo):
    """How the pair and its disparity map were made; a pair with ground truth is a generated scene."""
    match, commands, truth = demo.match, [], []
    if "truth" in match:
        scene = Path(match["left"]).parent
        commands.append(
            _command(PROGRAM, "scene", "--config", match["config"], "--seed", demo.cosims[0]["seed"], "--out", scene)
        )
        truth = ["--truth", match["truth"]["disparity"], "--visible", match["truth"]["visible"]]
    commands.append(_command(PROGRAM, "match", *_pair_options(match), *truth, "--out", "build/match"))
    return commands


# --- pictures ---------------------------------------------------------------------------------------------------------


def _named(name):
    """A file that a JSON of the demo names: relative to the project, or to where one is."""
    return ROOT / name if (ROOT / name).exists() else Path(name)


def _optional(notes, what, load):
    """What `load` gives, or None with a note for the page: the demo's folder does not hold the user's pair."""
    try:
        return load()
    except FlowError as error:
        notes.append(f"No picture of {what}: {error}.")
        return None


def _pair(match, notes):
    pair = {}
    for side in ("left", "right"):
        name = match[side]
        image = _optional(
            notes, f"the {side} image", lambda: pictures.fitted(pictures.load(_named(name), gray=True), match)
        )
        if image is not None:
            pair[side] = image
    return pair


def draw(demo):
    """(pictures in their order, notes on those that cannot be drawn)"""
    match, notes = demo.match, []
    numpy, _ = pictures.libraries()
    values = match["min_disparity"] + pictures.load(demo.folder / MAP).astype(float) / match["disparity_steps_per_px"]
    valid = numpy.ones(values.shape, bool)
    if demo.has_checks:
        valid = pictures.load(demo.folder / VALID) != 0
    if values.shape != (match["output_height_px"], match["output_width_px"]) or valid.shape != values.shape:
        raise FlowError(
            f"{demo.folder / MAP} is damaged: its size is not the one in match.json; make it again with scripts/demo.sh"
        )
    pair = _pair(match, notes)
    drawn = [
        pictures.Picture(
            f"{side.capitalize()} image",
            pictures.png(image),
            "The reference: the map has its pixels."
            if side == match["reference"]
            else "The image in which matches are searched.",
            match["width_px"],
            match["height_px"],
        )
        for side, image in pair.items()
    ]
    drawn.append(pictures.of_map(match, values, valid))
    truth = visible = None
    if "truth" in match:
        truth = _optional(notes, "the errors", lambda: pictures.load(_named(match["truth"]["disparity"])).astype(float))
        visible = (
            truth
            if truth is None
            else _optional(notes, "the errors", lambda: pictures.load(_named(match["truth"]["visible"])))
        )
    if visible is not None:
        drawn.append(_errors(match, values, valid, truth, visible, notes))
    if demo.has_checks and match["reference"] in pair:
        known = (truth, visible) if visible is not None else ()
        drawn.append(pictures.of_rejections(match, pair[match["reference"]], values, valid, *known))
    return drawn, notes


def _errors(match, values, valid, truth, visible, notes):
    picture, bad = pictures.of_errors(match, values, valid, truth, visible)
    if bad != match["truth"]["bad_px"]:
        notes.append(
            f"The error picture shows {bad:,} bad pixels, match.json counts {match['truth']['bad_px']:,}: the files are not of one run."
        )
    return picture


# --- numbers ----------------------------------------------------------------------------------------------------------


def key_figures(demo):
    """(number, what it is, beside it) for the top of the page."""
    paper, cards = performance.PAPER_SYSTEM, []
    beside = (lambda value: f"2007 paper: {value:,}") if demo.is_papers_size else (lambda value: "")
    if demo.whole_frames:
        cards.append((number(demo.whole_frames["clocks_per_frame"]), "clocks a frame", beside(paper.clocks_per_frame)))
    clock = demo.core.clock()
    if clock:
        cards.append((f"{clock['median']:.0f} MHz", "on ECP5, placed and routed", ""))
        cards.append(
            (number(clock["frames_per_second"]), "frames a second at that clock", beside(paper.frames_per_second))
        )
    if "ecp5" in demo.core.targets:
        cards.append((number(figures.lut_count(demo.core.targets["ecp5"])), "look-up tables on ECP5", ""))
    cards.append((number(demo.tool["memory_bits"]), "memory bits", beside(paper.memory_bits)))
    if "truth" in demo.match:
        cards.append(
            (
                f"{bad_percent(demo.match['truth']):.2f} %",
                "bad pixels",
                f"off by more than {demo.match['truth']['tolerance_px']} px",
            )
        )
    return cards


def hardware(demo):
    """[(command, [(what, this core, the paper)])]: the numbers under the command that prints them."""
    name, tool, paper, whole = demo.match["config"], demo.tool, performance.PAPER_SYSTEM, demo.whole_frames
    paper_evaluations = figures.evaluations_per_frame(performance.PAPER)
    return [
        (
            (whole or demo.cosims[0])["command"],
            [
                (
                    "clocks a frame" + (", frames back to back" if whole and whole["frames"] > 1 else ""),
                    number(whole and whole["clocks_per_frame"]),
                    number(paper.clocks_per_frame),
                ),
                ("latency, clocks", number((whole or demo.cosims[0])["latency_clocks"]), "–"),
            ],
        ),
        (
            f"scripts/performance.py --config {name}",
            [
                (
                    "disparity evaluations a clock",
                    number(figures.evaluations_per_clock(demo.core.parameters)),
                    number(paper_evaluations / paper.clocks_per_frame, 1),
                ),
                ("memory bits", number(tool["memory_bits"]), number(paper.memory_bits)),
                ("register bits", number(tool["register_bits"]), "–"),
            ],
        ),
        (
            f"scripts/synthesize.py --config {name}    (needs Bambu)",
            [
                ("registers, of them named as in C++", f"{tool['registers']:,}, {tool['registers_named']:,}", "–"),
                ("states, of them in the loop", f"{tool['states']}, {tool['loop_states']}", "–"),
            ],
        ),
        *(
            (f"scripts/implement.py --config {name} --target {target}", _target_rows(demo, target, result))
            for target, result in demo.core.targets.items()
        ),
    ]


def _target_rows(demo, target, result):
    paper, tables = performance.PAPER_SYSTEM, TARGETS[target].lut_name
    rows = [
        (
            f"{target}: look-up tables ({tables})",
            number(figures.lut_count(result)),
            f"{number(paper.aluts)} (Stratix II)" if target == "cyclonev" else "–",
        ),
        (f"{target}: flip-flops", number(result["ffs"]), "–"),
        (f"{target}: block RAMs", number(result["block_rams"]), "–"),
    ]
    if "fmax_mhz" in result:
        fmax, clock, seeds = result["fmax_mhz"], demo.core.clock(), len(result["fmax_mhz"]["by_seed"])
        rows += [
            (
                f"{target}: MHz after place and route, median (best) of {seeds} seed{'s' if seeds != 1 else ''}",
                f"{fmax['median']:.1f} ({fmax['best']:.1f})",
                f"{performance.PAPER_MHZ} (Stratix II)",
            ),
            (
                f"{target}: frames a second at that clock",
                number(clock["frames_per_second"]),
                number(paper.frames_per_second),
            ),
            (
                f"{target}: million disparity evaluations a second",
                number(clock["mde_per_second"]),
                number(paper.frames_per_second * figures.evaluations_per_frame(performance.PAPER) / 1e6),
            ),
        ]
    return rows


def comparisons():
    """[(head, rows)]: what performance.py writes into docs/performance.md; a result of other VHDL counts as none."""

    def make(name):
        return Configuration(name, stale_is_none=True)

    families = [make(name) for name in implement.known_configurations() if family(name) == PAPER]
    return [performance.comparison(families), performance.systems(make)]


def bad_percent(truth):
    return page.percent(truth["bad_px"], truth["compared_px"])


# --- writing ----------------------------------------------------------------------------------------------------------


def render(demo):
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
        size={**performance.PAPER, "window_px": performance.PAPER_WINDOW_PX},
    )


def summary(demo):
    """The key facts in a few lines of text."""
    parts = [f"{cosim['compared']:,} of {cosim['expected']:,} outputs in {cosim['simulator']}" for cosim in demo.cosims]
    mismatches = sum(cosim["mismatches"] for cosim in demo.cosims)
    lines = [
        f"{'PASS' if demo.passed else 'FAIL'}: VHDL against C++ core, {demo.match['config']}: {', '.join(parts)}; {mismatches:,} mismatches"
    ]
    paper = performance.PAPER_SYSTEM
    beside = (lambda value: f" (2007 paper: {value:,})") if demo.is_papers_size else (lambda value: "")
    facts, tool = [], demo.tool
    if demo.whole_frames is not None:
        facts.append(f"{demo.whole_frames['clocks_per_frame']:,} clocks a frame{beside(paper.clocks_per_frame)}")
        facts.append(f"latency {number(demo.whole_frames['latency_clocks'])} clocks")
    if "truth" in demo.match:
        facts.append(f"{bad_percent(demo.match['truth']):.2f} % bad pixels against the ground truth")
    lines += [", ".join(facts)] if facts else []
    return "\n".join(
        [
            *lines,
            f"{tool['memory_bits']:,} memory bits{beside(paper.memory_bits)}, {tool['register_bits']:,} register bits",
        ]
    )
