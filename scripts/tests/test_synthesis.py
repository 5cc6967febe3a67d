# SPDX-License-Identifier: Apache-2.0
"""With Bambu installed: regenerating changes nothing, and the lowered design runs like the tool's own."""

import pytest

from conftest import need
from flow.base import committed
from flow.base.configurations import designs
from flow.synthesis import manifest
from flow_commands import call, cosim, random_pair, report

# The large ones take minutes each; they are made by the same steps.
USES = ("tiny", "option", "example")
CONFIGURATIONS = [*(name for name, row in sorted(designs().items()) if row["use"] in USES), "ambrosch2007"]


@pytest.fixture(scope="module")
def regenerated(tmp_path_factory):
    """The configurations synthesised anew, into another folder."""
    need("bambu", "BAMBU")
    if call("synthesize.py", "--check").returncode != 0:
        pytest.fail("the committed VHDL is stale; see flow.manifest")
    folder = tmp_path_factory.mktemp("rtl")
    process = call("synthesize.py", "--out", folder, *[word for name in CONFIGURATIONS for word in ("--config", name)])
    assert process.returncode == 0, process.stderr
    return folder


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_regenerating_gives_the_committed_files(regenerated, name):
    old, new = committed.folder(name), regenerated / name
    if manifest.read(old)["tool"] != manifest.read(new)["tool"]:
        pytest.skip(f"SKIP: {manifest.read(old)['tool']} is not installed, {manifest.read(new)['tool']} is")
    made = sorted(new.iterdir())
    assert [path.name for path in made] == ["manifest.json", f"{committed.entity(name)}.vhd"]
    for path in made:
        assert path.read_bytes() == (old / path.name).read_bytes(), f"{path.name} differs"


def test_twice_gives_the_same_digest(regenerated, tmp_path):
    assert call("synthesize.py", "--config", "tiny", "--out", tmp_path).returncode == 0
    assert manifest.read(tmp_path / "tiny") == manifest.read(regenerated / "tiny")


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_the_loop_is_one_state_and_registers_have_their_names(regenerated, name):
    figures = manifest.read(regenerated / name)["tool_report"]
    assert figures["loop_states"] == 1
    # Where lanes share a word, the tool may keep parts of it.
    assert figures["registers_named"] >= 0.98 * figures["registers"]


@pytest.mark.parametrize(
    "name,options", [("tiny", ["--frames", 2]), ("tiny_p4", ["--frames", 2]), ("ambrosch2007", ["--rows", "0:3"])]
)
def test_original_and_lowered_design_agree_with_the_core_clock_by_clock(ghdl, regenerated, tmp_path, name, options):
    pair = random_pair(tmp_path / "pair", name, levels=16)
    for simulator in ("original", "ghdl"):
        process = cosim(name, pair, tmp_path / simulator, "--simulator", simulator, "--stall-percent", 15, *options)
        assert process.returncode == 0, process.stdout + process.stderr
        assert report(tmp_path / simulator)["mismatches"] == 0
