# SPDX-License-Identifier: Apache-2.0
"""The VHDL of the kits: its top as VHDL-93, two frames through it, and both in FuseSoC."""

import os
import re
import subprocess

import pytest

import kits
from cover import with_slow
from flow.base.ghdl import STANDARD
from flow.implementation.results import Configuration
from flow.pages import camera


def ghdl_step(ghdl, folder, *words):
    return subprocess.run([ghdl, *map(str, words)], cwd=folder, capture_output=True, text=True)


def analyse_top_as_93(ghdl, kit, work):
    """The top with the bare entity of what is in it: all that a packager reads."""
    inside = kit.folder / "rtl" / f"stereo_ip_{kit.config}.vhd"
    bare = work / "bare.vhd"
    bare.write_text(inside.read_text().partition("architecture")[0])
    return ghdl_step(ghdl, work, "-a", "--std=93", bare, kit.sources()[-1])


@pytest.mark.parametrize("config", ["tiny", "tiny_p4", "tiny_subpixel"])
def test_top_is_vhdl_93(ghdl, tmp_path, config):
    process = analyse_top_as_93(ghdl, kits.make(tmp_path / "kit", "vivado", config), tmp_path)
    assert process.returncode == 0, process.stderr


@pytest.mark.parametrize("tool", kits.KITS)
@pytest.mark.parametrize("config", with_slow(["tiny_p2", "tiny_sgm"], ["tiny_p2"]))
@pytest.mark.parametrize("standard", ["--std=93", "--std=08"])
def test_every_file_is_valid_in_both_versions(ghdl, tmp_path, tool, config, standard):
    kit = kits.make(tmp_path / "kit", tool, config)
    process = ghdl_step(ghdl, tmp_path, "-a", standard, *kit.sources())
    assert process.returncode == 0, process.stderr
    assert ghdl_step(ghdl, tmp_path, "-e", standard, kit.top).returncode == 0


def test_a_top_of_vhdl_2008_is_noticed(ghdl, tmp_path):
    kit = kits.make(tmp_path / "kit", "vivado", "tiny")
    top = kit.sources()[-1]
    top.write_text(top.read_text().replace("aclk => aclk", "aclk => aclk and aresetn"))
    assert analyse_top_as_93(ghdl, kit, tmp_path).returncode != 0


def bench(ghdl, kit, *options):
    """The finished process of the bench in a kit."""
    work, name = kit.folder.parent, f"tb_{kit.top}"
    files = [*kit.sources(), kit.folder / "sim" / f"{name}.vhd"]
    analysed = ghdl_step(ghdl, work, "-a", STANDARD, *files)
    assert analysed.returncode == 0, analysed.stderr
    return ghdl_step(ghdl, work, "-r", STANDARD, name, "--ieee-asserts=disable", *options)


CONFIGURATIONS = ["tiny", "tiny_p4", "tiny_subpixel", "tiny_left_min_negative", "tiny_sgm", "tiny_trellis", "example"]
CONFIGURATIONS += ["tiny_dense", "tiny_dense_p2", "tiny_confidence"]  # with bits above the disparity


@pytest.mark.parametrize("config", with_slow(CONFIGURATIONS, ["tiny_p4", "tiny_sgm", "tiny_dense"]))
def test_two_frames_go_through(ghdl, tmp_path, config):
    """In the kit whose files differ most from the committed ones; with the latency that the documentation states."""
    process = bench(ghdl, kits.make(tmp_path / "kit", "quartus", config))
    assert process.returncode == 0, process.stdout + process.stderr
    passed = re.search(rf"stereo_plain_{config} passed: (\d+) clocks", process.stdout + process.stderr)
    assert int(passed.group(1)) == camera.clocks_to_first(Configuration(config, stale_is_none=True))


@pytest.mark.parametrize("config", with_slow(["tiny_lr", "tiny_all_recursive", "tiny_sgm"], ["tiny_all_recursive"]))
@pytest.mark.parametrize("missing", [0, 1])
def test_blanking_that_a_camera_needs(ghdl, tmp_path, config, missing):
    """As docs/integration.md says: with flush_groups clocks between frames the source never waits."""
    blanking = Configuration(config, stale_is_none=True).parameters["flush_groups"] - missing
    process = bench(ghdl, kits.make(tmp_path / "kit", "vivado", config), f"-gblanking={blanking}", "-gsink_waits=0")
    assert f", {missing} in which the source waited" in process.stdout + process.stderr, process.stdout


FAULTS = {  # what the bench says: (file of rtl/, what, instead)
    "disparities are 2": ("stereo_ip_tiny", r"left_pixel => left_pixel", "left_pixel => right_pixel"),
    "register core is": ("stereo_ip_tiny", r'core_id => x"[0-9a-f]{8}', 'core_id => x"01234567'),
    "register matching is": ("stereo_ip_tiny", r"disparities => 8", "disparities => 9"),
    "frame error at beat": ("stereo_plain_tiny", r"s_axis_tlast => s_axis_tlast", "s_axis_tlast => s_axis_tuser(0)"),
    "end of line is wrong": ("stereo_plain_tiny", r"m_axis_tlast => m_axis_tlast", "m_axis_tlast => open"),
    "the maps do not come": ("stereo_plain_tiny", r"enabled_at_reset = 1", "enabled_at_reset = 0"),
}


@pytest.mark.parametrize("said", with_slow(FAULTS, ["disparities are 2", "the maps do not come"]))
def test_the_bench_notices_a_fault(ghdl, tmp_path, said):
    file, what, instead = FAULTS[said]
    kit = kits.make(tmp_path / "kit", "vivado", "tiny")
    path = kit.folder / "rtl" / f"{file}.vhd"
    text, count = re.subn(what, instead, path.read_text(), count=1)
    assert count == 1
    path.write_text(text)
    process = bench(ghdl, kit)
    assert process.returncode != 0 and said in process.stdout + process.stderr, process.stdout + process.stderr


@pytest.mark.parametrize("target, words", [("sim", ["passed: "]), ("lint", ["ghdl -m"])])
def test_fusesoc(ghdl, fusesoc, tmp_path, target, words):
    kit = kits.make(tmp_path / "cores" / "kit", "fusesoc", "tiny_p2")
    environment = {**os.environ, "PATH": f"{fusesoc}{os.pathsep}{os.environ['PATH']}"}
    command = [fusesoc / "fusesoc", "--cores-root", tmp_path / "cores", "run", "--target", target, kit.top]
    process = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, env=environment)
    said = process.stdout + process.stderr
    assert process.returncode == 0 and all(word in said for word in words), said
    assert said.count("WARNING") == said.count("backend is deprecated"), said
