# SPDX-License-Identifier: Apache-2.0
"""What scripts/flow/planning derives from options is what the C++ derives, and what the committed VHDL has."""

import dataclasses
import subprocess
from collections import Counter

import pytest

from flow.base import committed
from flow.base.configurations import options
from flow.base.tools import ROOT, find_tool
from flow.implementation.results import Configuration
from flow.pages.plan_algorithms import algorithms
from flow.planning import candidates, cores, ram
from flow.planning.candidates import Camera
from flow.planning.path_shape import PathShape
from flow.planning.window_memories import Memory

KNOWN = [Configuration(name, stale_is_none=True) for name in committed.known_configurations()]
MODELLED = [known for known in KNOWN if known.parameters["family"] in cores.FAMILIES]
# Bits that the tools leave above the highest number in a word, where they cannot see that these are never set.
LEFT_BITS = 3

CAMERAS = [
    Camera(320, 240, 64, 60),
    Camera(320, 240, 100, 60, ("left_right", "subpixel")),
    Camera(640, 480, 48, 30, ("left_right", "uniqueness", "median")),
    Camera(640, 481, 128, 30, (), {"pixel_bits": 10}),
    Camera(450, 375, 60, 30, ("full_width", "left_right")),
    Camera(96, 40, 64, 30, ("left_right",), {"min_disparity": 3}),
    Camera(80, 40, 76, 30, (), {"reference": "right"}),
    Camera(2000, 100, 256, 30, ("texture",)),
    Camera(160, 120, 6, 30),
    Camera(320, 240, 64, 60, (), {"sign_memory": True}),
    Camera(320, 240, 64, 60, (), {"cost": "ssd", "prefilter": "xsobel", "window_px": 15}),
    Camera(320, 240, 64, 60, (), {"path_right": False, "window_px": 3}),
    Camera(320, 240, 64, 60, (), {"window_px": 32}),
    Camera(320, 240, 64, 60, (), {"run_time_size": True}),
]
# What both say of a core, as C++.
WINDOWS = {
    "output_width": "output_width_px()",
    "gap_groups": "gap_groups()",
    "largest_pixel_cost": "largest_pixel_cost()",
    "largest_window_cost": "largest_window_cost()",
    "feature_bits": "feature_bits()",
    "stored_rows": "stored_rows()",
    "taps": "tap_rows()",
}
PATHS = {
    "cost_bits": "cost_bits()",
    "row_path_bits": "row_path_bits()",
    "largest_relief": "largest_relief()",
    "largest_path_above": "largest_path_above()",
    "largest_forward_sum": "largest_forward_sum()",
}


def counted(shape):
    """What the C++ says, as far as it is no list of memories."""
    found = {name: int(getattr(shape, name)) for name in WINDOWS}
    if isinstance(shape, PathShape):
        found |= {name: int(getattr(shape, name)) for name in PATHS} | {"sum_bits": shape.sum_bits}
    return found


def in_cpp(candidate, number):
    family, keys = candidate.family, options()[candidate.family]
    lines = [f"{{ stereo::{family}::Config c;"]
    lines += [f"c.{key} = {candidates.in_cpp(key, candidate.options[key])};" for key in keys]
    is_path = family == "semi_global"
    members = {name: f"{'c.windows().' if is_path else 'c.'}{text}" for name, text in WINDOWS.items()}
    if is_path:
        members |= {name: f"c.{text}" for name, text in PATHS.items()}
        members |= {"sum_bits": "stereo::bits_for(c.largest_sum())"}
    lines += [f'std::printf("{number} {name} %d\\n", int({text}));' for name, text in members.items()]
    lines += [f'std::printf("{number} can_be_built %d\\n", int(c.problem().empty())); }}']
    return "\n".join(lines)


@pytest.fixture(scope="module")
def compared(tmp_path_factory):
    """[(candidate, {what: number} of the C++)]"""
    drawn = [candidate for camera in CAMERAS for candidate in candidates.candidates(camera, algorithms())][::3]
    drawn = [c for c in drawn if not c.problem.startswith("this family")]
    folder = tmp_path_factory.mktemp("shapes")
    functions = [f"static void of_{i}() {in_cpp(candidate, i)}" for i, candidate in enumerate(drawn)]
    calls = "".join(f"of_{i}();" for i in range(len(drawn)))
    head = '#include <cstdio>\n#include "block_matching/config.hpp"\n#include "semi_global/config.hpp"\n'
    text = head + "using namespace stereo;\n" + "\n".join(functions) + f"\nint main() {{ {calls} }}\n"
    (folder / "shapes.cpp").write_text(text)
    compiler = find_tool("c++", "CXX", "on Debian: apt-get install g++")
    words = [compiler, "-std=c++20", "-w", f"-I{ROOT / 'hls'}", folder / "shapes.cpp", "-o", folder / "shapes"]
    subprocess.run(words, check=True)
    said = subprocess.run([folder / "shapes"], check=True, capture_output=True, text=True).stdout
    found = [{} for _ in drawn]
    for line in said.splitlines():
        number, name, value = line.split()
        found[int(number)][name] = int(value)
    return list(zip(drawn, found))


def test_sizes_are_those_of_the_cpp(compared):
    assert len(compared) > 100
    for candidate, said in compared:
        if said["can_be_built"]:
            assert counted(candidate.shape) == {name: said[name] for name in said if name != "can_be_built"}


def test_what_cannot_be_built_is_known(compared):
    for candidate, said in compared:
        assert (not candidate.problem) == said["can_be_built"], (candidate.problem, candidate.options)
    reasons = {candidate.problem for candidate, _ in compared}
    assert len(reasons) > 6, "the cameras meet the limits"


def test_both_tests_see_a_difference(compared):
    candidate, said = next((c, s) for c, s in compared if s["can_be_built"])
    changed = dataclasses.replace(candidate, options={**candidate.options, "window_px": 5})
    assert counted(changed.shape) != {name: said[name] for name in said if name != "can_be_built"}


def differences(memories, of_vhdl):
    """Of two lists of memories, those without a partner of the same depth and a width with at most LEFT_BITS more."""
    ours, left = sorted(memories), []
    for memory in sorted(of_vhdl):
        partner = next(
            (one for one in ours if one.depth == memory.depth and abs(memory.width - one.width) <= LEFT_BITS), None
        )
        if partner in ours:
            ours.remove(partner)
        else:
            left.append(memory)
    return left, ours


def same_first(memories, of_vhdl):
    """Without those that are equal."""
    ours, theirs = Counter(memories), Counter(of_vhdl)
    return list((ours - theirs).elements()), list((theirs - ours).elements())


# Their smallest costs, of 3 bits in the model and of 5 in the VHDL, cost about the same as block RAM and as LUT RAM.
LEFT_BITS_DECIDE = ("sgm_320_64_f16", "sgm_320_32_f16")


@pytest.mark.parametrize("known", MODELLED, ids=lambda known: known.name)
def test_memories_are_those_of_the_vhdl(known):
    memories = cores.memories_of(cores.shape_of(known.parameters))
    of_vhdl = cores.memories_in_vhdl(known.name)
    assert sum(m.depth * m.width for m in of_vhdl) == known.manifest["tool_report"]["memory_bits"]
    other_widths = same_first(memories, of_vhdl)
    assert differences(*other_widths) == ([], [])
    keeps = cores.shows_word_before(known.parameters)
    for name, family in ram.FAMILIES.items():
        counts = [ram.mapped(list_, family, keeps).block_rams for list_ in (memories, of_vhdl)]
        # Where the bits that are left decide: on ECP5 they do for two committed cores.
        is_exact = name == "ecp5" and known.name not in LEFT_BITS_DECIDE
        assert abs(counts[0] - counts[1]) <= (0 if is_exact else len(other_widths[0])), name


def test_a_missing_memory_shows():
    memories = cores.memories_in_vhdl("sgm_450")
    assert differences(*same_first(memories[1:], memories)) == ([memories[0]], [])
    wider = [Memory(memories[0].depth, memories[0].width + LEFT_BITS + 1), *memories[1:]]
    assert differences(*same_first(wider, memories)) == ([memories[0]], [wider[0]])


@pytest.mark.parametrize("known", MODELLED, ids=lambda known: known.name)
def test_schedule_is_that_of_the_table(known):
    shape = cores.shape_of(known.parameters)
    assert shape.output_width == known.parameters["output_width_px"]
    assert shape.gap_groups == known.parameters["gap_groups"]


def recorded():
    """Every committed core on each target whose RAMs are known."""
    for known in KNOWN:
        for target, result in known.targets.items():
            if ram.family_of(target):
                yield known, target, result


# One of its memories costs about the same as block RAM and as LUT RAM.
NOT_EXACT = {"masrani_640": -1}


@pytest.mark.parametrize("known, target, result", list(recorded()), ids=lambda value: getattr(value, "name", None))
def test_block_rams_are_those_of_the_record(known, target, result):
    keeps = cores.shows_word_before(known.parameters)
    family = ram.family_of(target)
    found = ram.mapped(cores.memories_in_vhdl(known.name), family, keeps)
    assert found.block_rams - result["block_rams"] == NOT_EXACT.get(known.name, 0)


def test_shapes_of_ecp5():
    """A block RAM has 18 kbit in several shapes; what is small is LUT RAM, and a bypass makes more small."""

    def of(depth, width, shows=False):
        found = ram.mapped([Memory(depth, width)], ram.FAMILIES["ecp5"], shows)
        return found.block_rams, found.lut_rams, found.choice_bits

    assert of(512, 36) == (1, 0, 0) and of(1024, 18) == (1, 0, 0) and of(1025, 9) == (1, 0, 0)
    assert of(513, 36) == (2, 0, 0), "two halves of 18 bits"
    assert of(512, 37) == (2, 0, 0), "two columns of 19 and 18 bits"
    assert of(2, 4) == (0, 0, 0), "flip-flops"
    assert of(16, 32) == (0, 8, 0) and of(17, 4) == (0, 2, 4)
    assert of(64, 14) == (0, 16, 42) and of(80, 22) == (1, 0, 0) and of(80, 22, True) == (0, 30, 88)
