# SPDX-License-Identifier: Apache-2.0
"""Words that a memory reads in the clock in which it writes them.

The option -no-rw-check of yosys leaves them open. It is not used, because there are such words: in block matching those
of bubbles, which nobody looks at; in semi-global matching some that decide the result."""

import pytest

from flow.base import rtl
from flow.base.configurations import configuration
from flow.base.tools import find_stereo_hls, run
from flow.cosim.simulators import Ghdl
from flow.implementation.targets import FAMILIES
from flow.synthesis import manifest
from flow_commands import scene

READ = "          word <= memory(read_address);\n"
OTHER = "          word <= 2 ** bits - 1 - memory(read_address) when {} else memory(read_address);\n"
SAME_CLOCK = "read_address = write_address"
BLOCK_MATCHING = ["tiny", "tiny_all", "tiny_all_recursive", "tiny_p4", "tiny_lr_left", "tiny_median_left_subpixel"]


def observed(config, folder, wrong=None):
    """What the core answers to two frames with bubbles; with `wrong`, its memories read other words where that is
    true."""
    pair, cell = folder / "pair", folder / "line_memory.vhd"
    if not pair.is_dir():
        left, right = scene(pair, config)
        images = ["--left", left, "--right", right]
        options = ["--frames", 2, "--stall-percent", 25, "--seed", 1, "--fit", "none", "--out", folder]
        run([find_stereo_hls(), "vectors", "--config", config, *images, *options])
    text = rtl.MEMORY_CELL.read_text()
    assert READ in text
    cell.write_text(text.replace(READ, OTHER.format(wrong)) if wrong else text)
    row = configuration(config)
    files = [cell if path == rtl.MEMORY_CELL else path for path in manifest.core_files(config)]
    simulator = Ghdl(config, files, folder / "simulation", row["pixels_per_clock"], row["disparity_bits"])
    simulator.build()
    simulator.run(folder / "stimulus.txt", folder / "observed.txt", lambda clock: None, 100)
    return (folder / "observed.txt").read_text()


@pytest.mark.parametrize("config", BLOCK_MATCHING)
def test_block_matching_looks_at_none(ghdl, tmp_path, config):
    right = observed(config, tmp_path)
    assert observed(config, tmp_path, SAME_CLOCK) == right
    # The test sees wrong words: of the clock in which the address before was written.
    assert observed(config, tmp_path, "read_address = write_address + 1") != right


def test_semi_global_matching_looks_at_some(ghdl, tmp_path):
    assert observed("tiny_sgm", tmp_path, SAME_CLOCK) != observed("tiny_sgm", tmp_path)


def test_the_option_is_not_used():
    assert not [family for family in FAMILIES.values() if "no-rw-check" in family.synthesis]
