# SPDX-License-Identifier: Apache-2.0
"""A change of the VHDL that nobody can see is proved to be none, and no other one is."""

import re

import pytest

from conftest import need
from cover import with_slow
from flow.mutation import equivalence
from flow.mutation.equivalence import Design, NotSynthesizedError, Prover
from flow.shell import design
from flow.synthesis import manifest
from flow.synthesis.presentation import scalars

SHELL = Design("tiny", False)
CORE = Design("tiny", True)
FILES = scalars.files(manifest.core_files("tiny")), design.shell_files()

INVISIBLE = {
    "a reset value that counts only with its valid bit": (
        CORE,
        "stereo_core_tiny",
        "        slice0_best_tag_start_of_frame <= false;",
        "        slice0_best_tag_start_of_frame <= true;",
    ),
    "a valid bit after a reset": (
        CORE,
        "stereo_core_tiny",
        "        slice0cost_tag_valid <= false;",
        "        slice0cost_tag_valid <= true;",
    ),
    "a number that is never reached": (CORE, "stereo_core_tiny", "mod 2)) < 12;", "mod 2)) <= 12;"),
    "columns of a memory": (CORE, "line_memory", "(width + 35) / 36", "(width + 6) / 7"),
    "data without a valid bit": (
        SHELL,
        "stereo_registers",
        "if reads = '1' then",
        "if rvalid = '0' then",
    ),
    "a condition that changes nothing": (
        SHELL,
        "stream_register",
        "if moves = '1' or next_valid = '0' then",
        "if moves = '1' or next_valid = '0' or main_valid = '0' then",
    ),
}
VISIBLE = {
    "one column less": (CORE, "stereo_core_tiny", ">= 7) and (raster", ">= 8) and (raster"),
    "a word is written over": (SHELL, "stream_fifo", "return address + 1;", "return address;"),
    "one credit too many": (SHELL, "stream_credit", "lent < words - 2", "lent < words - 1"),
    "the second error is lost": (SHELL, "stereo_framing", "lost <= broken or (lost", "lost <= lost or (lost"),
}


@pytest.fixture(scope="module")
def provers(tmp_path_factory):
    for tool, variable in (("ghdl", "GHDL"), ("yosys", "YOSYS"), ("yosys-abc", "YOSYS_ABC")):
        need(tool, variable)
    return {what.is_core: Prover([what], *FILES, tmp_path_factory.mktemp("originals")) for what in (CORE, SHELL)}


def objection(provers, change, folder):
    """To a file with a change in it."""
    what, name, old, new = change
    text = next(path for files in FILES for path in files if path.stem == name).read_text()
    assert old in text
    changed = folder / f"{name}.vhd"
    changed.write_text(text.replace(old, new, 1))
    core, shell = ([changed if path.stem == name else path for path in files] for files in FILES)
    return provers[what.is_core].objection(core, shell, folder)


def test_what_synthesis_refuses(provers, tmp_path):
    """A clock that is no edge: GHDL compiles it, and makes no hardware of it."""
    change = (SHELL, "frame_timer", "if rising_edge(clock) then", "if not (rising_edge(clock)) then")
    with pytest.raises(NotSynthesizedError, match="latch"):
        objection(provers, change, tmp_path)


# One proof and one difference; those of the core are in the slow set.
FAST_INVISIBLE = ["data without a valid bit"]
FAST_VISIBLE = ["the second error is lost"]


@pytest.mark.parametrize("change", with_slow(INVISIBLE, FAST_INVISIBLE))
def test_what_cannot_be_seen_is_proved(provers, tmp_path, change):
    assert objection(provers, INVISIBLE[change], tmp_path) == ""


@pytest.mark.parametrize("change", with_slow(VISIBLE, FAST_VISIBLE))
def test_what_can_be_seen_is_refuted(provers, tmp_path, change):
    assert re.match("differs in clock", objection(provers, VISIBLE[change], tmp_path))


@pytest.mark.slow
def test_what_shows_late_is_not_proved(provers, tmp_path, monkeypatch):
    for name in ("SECONDS", "SHORT_SECONDS", "LONG_SECONDS"):
        monkeypatch.setattr(equivalence, name, 2)
    upper = "now_clock(31 downto 16) & (now_clock(15 downto 0) + 1)"
    change = (SHELL, "frame_timer", "now_clock <= now_clock + 1", f"now_clock <= {upper}")
    assert objection(provers, change, tmp_path) == "no proof in 2 s"


def test_what_comes_without_a_valid_bit_is_not_seen():
    text = equivalence.observed(
        "module stereo_core_x_8\n  (input  clock,\n   input  reset,\n"
        "   output [7:0] disparity,\n   output disparity_valid);\nendmodule\n",
        "stereo_core_x",
    )
    assert "stereo_core_x_8 inner (.clock(clock), .reset(reset | first)" in text
    assert "assign disparity = of_disparity_valid ? of_disparity : 0;" in text
    assert "assign disparity_valid = of_disparity_valid;" in text
