# SPDX-License-Identifier: Apache-2.0
"""What others take into their designs: the instantiation, the FuseSoC core, the example and the pictures of the
documentation."""

import os
import re
import shutil
import subprocess

import pytest

from flow.base import venv
from flow.base.errors import FlowError
from flow.base.ghdl import STANDARD
from flow.base.tools import ROOT
from flow.shell import cocotb_runs, design, example
from flow_commands import call, refused


def from_pypi(install):
    """What `install` gives, or a skip where PyPI is out of reach."""
    try:
        return install()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")


@pytest.fixture(scope="module")
def fusesoc():
    return from_pypi(lambda: venv.ensure("venv-fusesoc", ROOT / "scripts" / "requirements-fusesoc.txt", "fusesoc"))


def ghdl_run(ghdl, folder, files, top):
    def step(*words):
        return subprocess.run([ghdl, *map(str, words)], cwd=folder, capture_output=True, text=True)

    analysed = step("-a", STANDARD, *files)
    assert analysed.returncode == 0, analysed.stderr
    assert step("-e", STANDARD, top).returncode == 0
    return step("-r", STANDARD, top, "--ieee-asserts=disable-at-0")


@pytest.mark.parametrize("config", ["tiny", "tiny_p2", "tiny_p4", "ambrosch2007"])
def test_entity_without_generics_fits_its_core(ghdl, tmp_path, config):
    wrapper = tmp_path / "wrapper.vhd"
    assert call("instantiate.py", "--config", config, "--out", wrapper).returncode == 0
    named = [ROOT / name for name in re.findall(r"^--   (\S+\.vhd)$", wrapper.read_text(), re.MULTILINE)]
    assert named == design.vhdl_files(config)
    process = ghdl_run(ghdl, tmp_path, [*named, wrapper], f"stereo_ip_{config}")
    assert process.returncode == 0, process.stdout + process.stderr


def test_instance_to_be_pasted():
    process = call("instantiate.py", "--config", "tiny_p2", "--instance")
    assert process.returncode == 0
    assert "entity work.stereo_ip" in process.stdout and "pixels_per_clock => 2" in process.stdout


def test_unknown_configuration():
    refused(call("instantiate.py", "--config", "nonsense"), 2, "no generated VHDL for 'nonsense'")


def test_example_has_the_generics_of_its_core():
    text = (example.FOLDER / "example_top.vhd").read_text()
    text = text[text.index("entity work.stereo_ip") :]
    constants = dict(re.findall(r"constant (\w+) : \w+ := (\d+);", (example.FOLDER / "example_top.vhd").read_text()))
    given = {
        name: int(constants.get(value, value))
        for name, value in re.findall(r"(\w+) => (\w+)", text[: text.index("port map")])
    }
    assert given == design.generics("tiny")


def test_example_shows_the_right_disparities(ghdl, tmp_path):
    files = [
        *design.vhdl_files("tiny"),
        *(example.FOLDER / f"{name}.vhd" for name in (*example.SOURCES, "tb_example_top")),
    ]
    process = ghdl_run(ghdl, tmp_path, files, "tb_example_top")
    assert process.returncode == 0 and "example passed: LEDs 10000100" in process.stdout + process.stderr


def test_example_notices_wrong_disparities(ghdl, tmp_path):
    wrong = tmp_path / "example_top.vhd"
    wrong.write_text(
        (example.FOLDER / "example_top.vhd")
        .read_text()
        .replace(
            "map_px => output_width_px * height_px, shift => shift",
            "map_px => output_width_px * height_px, shift => shift + 1",
        )
    )
    files = [
        *design.vhdl_files("tiny"),
        *(example.FOLDER / f"{name}.vhd" for name in example.SOURCES[:-1]),
        wrong,
        example.FOLDER / "tb_example_top.vhd",
    ]
    process = ghdl_run(ghdl, tmp_path, files, "tb_example_top")
    assert process.returncode != 0 and "LEDs show 00000100" in process.stdout + process.stderr


@pytest.mark.parametrize("target, word", [("sim", "example passed"), ("lint", "ghdl -m")])
def test_fusesoc(ghdl, fusesoc, tmp_path, target, word):
    environment = {**os.environ, "PATH": f"{fusesoc}{os.pathsep}{os.environ['PATH']}"}
    # A copy: FuseSoC would look for cores in build/, too.
    cores = tmp_path / "cores"
    for name in ("hls", "generated_rtl/tiny", "examples"):
        shutil.copytree(ROOT / name, cores / name)
    shutil.copy(ROOT / "stereo_hls.core", cores)
    process = subprocess.run(
        [fusesoc / "fusesoc", "--cores-root", tmp_path / "cores", "run", "--target", target, "stereo_hls"],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        env=environment,
    )
    assert process.returncode == 0 and word in process.stdout + process.stderr, process.stdout + process.stderr


def test_pictures_are_what_the_simulation_gives(ghdl):
    from_pypi(cocotb_runs.environment_folder)
    process = call("timing_diagrams.py", "--check")
    assert process.returncode == 0, process.stdout + process.stderr
