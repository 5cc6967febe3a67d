# SPDX-License-Identifier: Apache-2.0
"""What others take into their designs: the instantiation, the FuseSoC core and the pictures of the
documentation."""

import os
import re
import shutil
import subprocess
from functools import partial

import pytest

from conftest import where_reachable
from flow.base import committed, rtl
from flow.base.ghdl import STANDARD
from flow.base.tools import ROOT
from flow.shell import cocotb_runs, design, template
from flow.synthesis import manifest
from flow_commands import call, refused


def ghdl_run(ghdl, folder, files, top):
    def step(*words):
        return subprocess.run([ghdl, *map(str, words)], cwd=folder, capture_output=True, text=True)

    analysed = step("-a", STANDARD, *files)
    assert analysed.returncode == 0, analysed.stderr
    assert step("-e", STANDARD, top).returncode == 0
    return step("-r", STANDARD, top, "--ieee-asserts=disable-at-0")


CONFIGURATIONS = ["tiny", "tiny_p2", "tiny_f2", "tiny_p4", "tiny_all_recursive", "example_p2_delayed", "ambrosch2007"]


@pytest.mark.parametrize("config", committed.known_configurations())
def test_committed_wrapper_follows_from_the_manifest(config):
    assert template.path(config).read_text() == template.entity(config, manifest.read(committed.folder(config)))


def test_command_prints_the_committed_wrapper():
    process = call("instantiate.py", "--config", "tiny")
    assert process.returncode == 0 and process.stdout == template.path("tiny").read_text()


@pytest.mark.parametrize("config", CONFIGURATIONS)
def test_wrapper_fits_its_core(ghdl, tmp_path, config):
    process = ghdl_run(ghdl, tmp_path, design.vhdl_files(config), rtl.ip_entity(config))
    assert process.returncode == 0, process.stdout + process.stderr


def two_cores(configs):
    """A design with two configurations, each with its streams tied off."""
    instances = []
    for config in configs:
        entry = manifest.read(committed.folder(config))
        ports = template.ports(design.generics(entry), rtl.pixel_bits_of(entry["parameters"]))
        tied = {
            port.name: "open" if port.direction == "out" else "(others => '0')" if "vector" in port.kind else "'0'"
            for port in ports
        }
        instances.append(template.instance(f"{config}_ip", rtl.ip_entity(config), {}, tied | {"aclk": "clock"}))
    head = "library ieee;\nuse ieee.std_logic_1164.all;\nentity two is\nend entity;\narchitecture test of two is\n"
    return head + "  signal clock : std_logic := '0';\nbegin\n" + "\n".join(instances) + "\nend architecture;\n"


@pytest.mark.parametrize("configs", [("tiny", "tiny_p4"), ("tiny_all_recursive", "example")])
def test_two_configurations_stand_in_one_library(ghdl, tmp_path, configs):
    (tmp_path / "two.vhd").write_text(two_cores(configs))
    process = ghdl_run(ghdl, tmp_path, [*design.library_files(configs), tmp_path / "two.vhd"], "two")
    assert process.returncode == 0, process.stdout + process.stderr


@pytest.mark.parametrize("config", ["tiny", "example_p2_delayed"])
@pytest.mark.parametrize("generic", rtl.GENERICS)
def test_a_wrong_generic_stops_elaboration(ghdl, tmp_path, config, generic):
    """A core that is not what its user says of it: a wrapper of another configuration, or of another version."""
    values = design.generics(manifest.read(committed.folder(config)))
    wrong, entity = values[generic] + 1, rtl.core_entity(config)
    step = partial(subprocess.run, cwd=tmp_path, capture_output=True, text=True)
    assert step([ghdl, "-a", STANDARD, *manifest.core_files(config)]).returncode == 0
    process = step([ghdl, "-r", STANDARD, entity, f"-g{generic}={wrong}"])
    assert process.returncode != 0
    assert f"{entity}: {generic} is {wrong} but this core has {values[generic]}" in process.stdout + process.stderr


def test_registers_of_another_core_stop_elaboration(ghdl, tmp_path):
    """The shell of one configuration around the core of another."""
    text = template.path("tiny").read_text().replace(rtl.core_entity("tiny"), rtl.core_entity("tiny_ties"))
    assert rtl.core_entity("tiny_ties") in text
    text = text.replace("width_px => 32", "width_px => 40")
    (tmp_path / "mixed.vhd").write_text(text)
    files = [*manifest.core_files("tiny_ties"), *design.shell_files(), tmp_path / "mixed.vhd"]
    process = ghdl_run(ghdl, tmp_path, files, rtl.ip_entity("tiny"))
    assert process.returncode != 0
    assert "stereo_core_tiny_ties: width_px is 40 but this core has 32" in process.stdout + process.stderr


def test_instance_to_be_pasted():
    process = call("instantiate.py", "--config", "tiny_p2", "--instance")
    assert process.returncode == 0 and "entity work.stereo_ip_tiny_p2" in process.stdout
    named = [ROOT / name for name in re.findall(r"^  -- (\S+\.vhd)$", process.stdout, re.MULTILINE)]
    assert named == design.vhdl_files("tiny_p2"), "what must be compiled before it"


def test_unknown_configuration():
    refused(call("instantiate.py", "--config", "nonsense"), 2, "no generated VHDL for 'nonsense'")


@pytest.mark.parametrize("target, word", [("sim", "self test passed"), ("lint", "ghdl -m")])
def test_fusesoc(ghdl, fusesoc, tmp_path, target, word):
    environment = {**os.environ, "PATH": f"{fusesoc}{os.pathsep}{os.environ['PATH']}"}
    # A copy: FuseSoC would look for cores in build/, too.
    cores = tmp_path / "cores"
    for name in ("hls", "generated_rtl/block_matching/tiny", "examples"):
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


@pytest.mark.slow
def test_pictures_are_what_the_simulation_gives(ghdl):
    where_reachable(cocotb_runs.environment_folder)
    process = call("timing_diagrams.py", "--check")
    assert process.returncode == 0, process.stdout + process.stderr
