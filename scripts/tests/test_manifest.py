# SPDX-License-Identifier: Apache-2.0
"""The committed VHDL must follow from the committed sources: a change of the C++ without new VHDL fails here."""

import pytest

from flow.base import tools
from flow.base.configurations import configuration, configurations
from flow.base.families import keeps_vhdl
from flow.synthesis import generate, manifest
from flow_commands import call

# Of the others the repository has no VHDL.
CONFIGURATIONS = sorted(filter(keeps_vhdl, configurations()))


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_is_up_to_date(name):
    reasons = manifest.stale_reasons(name, configuration(name))
    assert not reasons, (
        f"generated_rtl/{name} is stale ({'; '.join(reasons)}); run scripts/synthesize.py --config {name}"
    )


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_is_what_the_manifest_says(name):
    files = manifest.vhdl_files(tools.GENERATED_RTL / name)
    assert [path.name for path in files] == ["line_memory.vhd", "stereo_core.vhd"], "compile order"


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_says_where_it_came_from(name):
    head = (tools.GENERATED_RTL / name / "stereo_core.vhd").read_text()[:600]
    for words in (
        "SPDX-License-Identifier: Apache-2.0",
        f"configuration {name}",
        "hls/stereo_top.cpp",
        "PandA Bambu",
        "synthesize.py",
    ):
        assert words in head


def test_every_folder_is_a_configuration():
    folders = {path.name for path in tools.GENERATED_RTL.iterdir()}
    assert folders >= set(CONFIGURATIONS) and folders <= set(configurations())


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_nothing_of_the_tools_library_is_committed(name):
    for path in (tools.GENERATED_RTL / name).iterdir():
        text = path.read_text().lower()
        for word in ("politecnico", "lgpl", "panda_pkg", "_expr_fu", "mux_gate", "lesser general"):
            assert word not in text, f"{path.name} has '{word}'"


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A copy of what the digests cover, to be changed."""
    for pattern in (
        "hls/*.[hc]pp",
        "hls/rtl/*.vhd",
        "hls_tb/vectors/*names.hpp",
        "scripts/flow/synthesis/**/*.py",
        "generated_rtl/*/*",
    ):
        for path in tools.ROOT.glob(pattern):
            target = tmp_path / path.relative_to(tools.ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(path.read_bytes())
    monkeypatch.setattr(manifest, "ROOT", tmp_path)
    monkeypatch.setattr(manifest, "GENERATED_RTL", tmp_path / "generated_rtl")
    return tmp_path


def test_a_changed_new_or_missing_source_makes_the_vhdl_stale(project):
    parameters = configuration("tiny")
    assert manifest.stale_reasons("tiny", parameters) == []
    block = project / "hls" / "sad_cost.hpp"
    block.write_text(block.read_text().replace("255", "254", 1))
    (project / "hls" / "census_cost.hpp").write_text("#pragma once\n")
    (project / "scripts" / "flow" / "synthesis" / "lowering" / "rules.py").unlink()
    for path in (
        "scripts/flow/synthesis/bambu.py",
        "scripts/flow/synthesis/generate.py",
        "hls_tb/vectors/register_names.hpp",
    ):
        (project / path).write_text((project / path).read_text() + "\n")
    assert manifest.stale_reasons("tiny", parameters) == [
        "hls/census_cost.hpp is new",
        "hls/sad_cost.hpp changed",
        "hls_tb/vectors/register_names.hpp changed",
        "scripts/flow/synthesis/bambu.py changed",
        "scripts/flow/synthesis/generate.py changed",
        "scripts/flow/synthesis/lowering/rules.py is gone",
    ]


def test_vhdl_that_is_not_what_was_made_is_said(project):
    parameters = configuration("tiny")
    design = project / "generated_rtl" / "tiny" / "stereo_core.vhd"
    design.write_text(design.read_text() + "-- by hand\n")
    (project / "generated_rtl" / "tiny" / "line_memory.vhd").unlink()
    assert manifest.stale_reasons("tiny", parameters) == ["line_memory.vhd is missing", "stereo_core.vhd was edited"]


def test_a_changed_row_of_the_table_makes_only_its_vhdl_stale(project):
    table = project / "hls" / "configurations.hpp"
    table.write_text(table.read_text() + "// another configuration\n")
    assert manifest.stale_reasons("ambrosch2007", configuration("ambrosch2007")) == []
    changed = dict(configuration("tiny"), disparities=9)
    assert manifest.stale_reasons("tiny", changed) == ["its row in hls/configurations.hpp changed"]


def test_check_command_needs_no_bambu():
    process = call("synthesize.py", "--check", environment={"BAMBU": "/nowhere/bambu"})
    assert process.returncode == 0, process.stderr
    for name in CONFIGURATIONS:
        assert f"{name}: up to date" in process.stdout


STAND_IN = """#!/bin/sh
echo "$@" >> "$0.calls"
case "$1" in
  --version) echo " Version: PandA 2024.10 - Revision 0123456789abcdef-main"; exit 0 ;;
esac
exit 7
"""


def test_a_failing_tool_leaves_nothing_behind(tmp_path):
    bambu = tmp_path / "bambu"
    bambu.write_text(STAND_IN)
    bambu.chmod(0o755)
    process = call("synthesize.py", "--config", "tiny", "--out", tmp_path / "rtl", environment={"BAMBU": str(bambu)})
    assert process.returncode == 4
    assert "bambu failed with exit code 7" in process.stderr
    assert not (tmp_path / "rtl" / "tiny").exists()
    version, command = (tmp_path / "bambu.calls").read_text().splitlines()
    assert version == "--version"
    for option in (
        "hls/stereo_top.cpp",
        "-DSTEREO_CONFIGURATION=tiny",
        "--top-fname=stereo_core",
        "-wH",
        "--generate-components-library",
    ):
        assert option in command.split()


def test_a_log_without_figures_is_refused():
    from flow.base.errors import FlowError
    from flow.synthesis import bambu

    with pytest.raises(FlowError, match="no line 'Number of states"):
        bambu.read_log("nothing of use")


def test_header_fits_the_line():
    assert all(
        len(line) <= 120
        for line in generate.header("x", configuration("tiny"), "PandA Bambu 2024.10 revision 683d87153").splitlines()
    )
