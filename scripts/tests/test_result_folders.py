# SPDX-License-Identifier: Apache-2.0
"""A command that is given a folder replaces what an earlier run has made there, and no file of the user's. Options that
would have no effect are refused."""

import importlib
import shutil
import subprocess
import sys

import pytest

from flow.base import committed, places
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.kit import contents
from flow.shell import registers
from flow.synthesis import manifest
from flow_commands import call, refused, scene


@pytest.mark.parametrize(
    "name, command, words",
    [
        ("report.json", "cosim.py", ["--config", "tiny"]),
        ("junit.xml", "cosim.py", ["--config", "tiny"]),
        ("stimulus.txt", "cosim.py", ["--config", "tiny"]),
        ("observed.txt", "cosim.py", ["--config", "tiny"]),
        ("coverage.json", "cosim.py", ["--config", "tiny", "--coverage"]),
        ("summary.html", "cosim.py", ["--config", "tiny", "tiny_p2"]),
        ("report.json", "mutate.py", ["--core", 1, "--shell", 0]),
        ("junit.xml", "verify_axi.py", ["--short"]),
        ("explore.csv", "explore.py", ["--scenes", 1]),
        ("evaluations.jsonl", "explore.py", ["--scenes", 1]),
        ("anything", "build_example.py", ["--board", "icebreaker"]),
        ("source/anything", "site.py", []),
        ("html/anything", "site.py", []),
        ("anything", "try_tools.py", ["--config", "tiny"]),
        ("quality_cost.ipynb", "notebook.py", []),
        ("report.html", "demo.sh", ["--config", "tiny"]),
    ],
)
def test_a_file_of_the_user_is_not_replaced(tmp_path, name, command, words):
    own = tmp_path / "folder" / name
    own.parent.mkdir(parents=True)
    own.write_text("the user's own")
    refused(call(command, *words, "--out", tmp_path / "folder"), 2, "earlier run", "name another folder")
    assert own.read_text() == "the user's own"


def test_a_notebook_is_not_replaced_by_its_copy_with_outputs(tmp_path):
    own = tmp_path / "mine.ipynb"
    own.write_text("{}")
    refused(call("notebook.py", own, "--out", tmp_path), 2, "the notebook itself would be replaced")
    assert own.read_text() == "{}"


def test_board_does_not_replace_an_image(tmp_path):
    left, right = scene(tmp_path, "tiny")
    before = left.read_bytes()
    (tmp_path / "link").symlink_to(tmp_path)
    words = ["--config", "tiny", "--simulate", "--left", left, "--right", right]
    refused(call("board.py", *words, "--out", tmp_path / "link" / left.name), 2, "would be replaced")
    assert left.read_bytes() == before


@pytest.mark.parametrize("name", ["front.png", "scene1/left.png"])
def test_explore_does_not_replace_an_image(tmp_path, name):
    places.results_folder(tmp_path, [])
    left = tmp_path / name
    left.parent.mkdir(exist_ok=True)
    left.write_text("the user's own")
    words = ["--pair", left, left, left, "-", "--scenes", 1, "--out", tmp_path]
    refused(call("explore.py", *words), 2, f"{name} is an input of this command")
    assert left.read_text() == "the user's own"


def test_a_refused_exploration_leaves_no_folder(tmp_path):
    refused(call("explore.py", "--scenes", 0, "--out", tmp_path / "new"), 2, "no pair")
    assert not (tmp_path / "new").exists()


def test_results_of_an_earlier_run_are_replaced(tmp_path):
    folder = places.results_folder(tmp_path / "new", ["report.json"])
    (folder / "report.json").write_text("of the first run")
    (folder / "mine.txt").write_text("the user's own")
    assert places.results_folder(folder, ["report.json"]) == folder  # the second run
    assert (folder / "mine.txt").is_file()


def test_a_folder_of_an_earlier_run_is_emptied(tmp_path):
    folder = places.emptied_folder(tmp_path / "new")
    (folder / "routed").write_text("of the first run")
    assert [path.name for path in places.emptied_folder(folder).iterdir()] == [places.MARK_OF_ALL]


def test_a_folder_of_results_beside_files_of_the_user_is_not_emptied(tmp_path):
    (tmp_path / "mine.txt").write_text("the user's own")
    places.results_folder(tmp_path, ["report.json"])
    with pytest.raises(FlowError, match="is not empty"):
        places.emptied_folder(tmp_path)
    assert (tmp_path / "mine.txt").is_file()


def test_a_link_to_a_folder_of_the_user_is_not_emptied(tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("the user's own")
    (tmp_path / "link").symlink_to(tmp_path / "mine")
    with pytest.raises(FlowError, match="is not empty"):
        places.emptied_folder(tmp_path / "link")
    assert (tmp_path / "mine" / "file").is_file()


PAIR = ["--left", "left.png", "--right", "right.png", "--out", "map.png"]
VECTORS = ["--config", "tiny", "--stimulus", "stimulus.txt", "--expected", "expected.txt"]


@pytest.mark.parametrize(
    "command, words, option, mode",
    [
        ("board.py", [*PAIR, "--simulate", "--baud", 9600], "--baud", "--simulate"),
        ("board.py", [*PAIR, "--port", "line", "--simulator", "ghdl"], "--simulator", "--port"),
        ("build_example.py", ["--core", "file", "--seed", 5], "--seed", "--core"),
        ("build_example.py", ["--check", "--record"], "--record", "--check"),
        ("camera_system.py", ["--seeds", 3], "--seeds", "the list of files"),
        ("camera_system.py", ["--show", "--seeds", 2], "--seeds", "--show"),
        ("cosim.py", [*VECTORS, "--frames", 5], "--frames", "--stimulus FILE"),
        ("cosim.py", [*VECTORS, "--seed", 5], "--seed", "--stimulus FILE"),
        ("implement.py", ["--config", "tiny", "--jobs", 2], "--jobs", "one --config"),
        ("camera_system.py", ["--check", "--router", "router1"], "--router", "--check"),
        ("camera_system.py", ["--frame", "--system", "vga", "--seeds", 2], "--seeds", "--frame"),
        ("camera_system.py", ["--streams", 3, "--system", "tiny", "--router", "router2"], "--router", "--streams"),
        ("mutate.py", ["--check", "--core", 3], "--core", "--check"),
        ("mutate.py", ["--page", "--record"], "--record", "--page"),
        ("plan.py", ["--check", "--fps", 30], "--fps", "--check"),
        ("plan.py", ["--page", "--json"], "--json", "--page"),
        ("quality.py", ["--check", "--pictures", "folder"], "--pictures", "--check"),
        ("random_configurations.py", ["--row", "row", "--count", 20], "--count", "--row"),
        ("synthesize.py", ["--check", "--out", "folder"], "--out", "--check"),
        ("synthesize.py", ["--refresh", "--jobs", 1], "--jobs", "--refresh"),
    ],
)
def test_an_option_without_effect_is_refused(command, words, option, mode):
    refused(call(command, *words), 2, f"{option} has no effect beside {mode}")


@pytest.mark.parametrize(
    "command, words, sentence",
    [
        ("cosim.py", ["--config", "tiny", "--coverage", "--simulator", "ghdl"], "--coverage runs in verilator"),
        ("cosim.py", ["--config", "tiny", "--fit", "crop"], "--fit is for --left and --right"),
        ("implement.py", ["--config", "tiny", "--target", "xc7", "--seeds", 5], "--seeds is for place and route"),
        ("implement.py", ["--config", "tiny", "--target", "xc7", "--router", "router2"], "--router is for place"),
        ("explore.py", ["--truth-scale", 16], "--truth-scale needs --pair"),
        ("instantiate.py", ["--config", "tiny", "--config", "tiny_p2"], "--config appears twice"),
        ("performance.py", ["--config", "tiny", "--config", "tiny_p2"], "--config appears twice"),
        ("build_example.py", ["--seed", 0], "--seed must be 1 or more"),
    ],
)
def test_what_would_be_ignored_is_refused(command, words, sentence):
    refused(call(command, *words), 2, sentence)


@pytest.mark.parametrize("name", ["tiny/", "tiny_p[2]", "tiny_p4/../tiny", "*", "", "."])
@pytest.mark.parametrize("command", ["instantiate.py", "build_example.py"])
def test_a_pattern_or_a_path_is_no_name(tmp_path, command, name):
    words = ["--core", tmp_path / "file"] if command == "build_example.py" else ["--out", tmp_path / "file"]
    refused(call(command, "--config", name, *words), 2, f"'{name}' is no name of a configuration")
    assert not (tmp_path / "file").exists()


@pytest.mark.parametrize("command", ["instantiate.py", "cosim.py", "build_example.py"])
def test_a_slip_in_a_name_gets_the_name_that_is_meant(command):
    refused(call(command, "--config", "ambrosh2007"), 2, "'ambrosh2007'; did you mean ambrosch2007")


def test_a_kit_of_an_edited_manifest_is_refused(monkeypatch, tmp_path):
    folder = tmp_path / "block_matching" / "tiny"
    shutil.copytree(committed.folder("tiny"), folder)
    manifest.require_as_made(folder)
    path = folder / "manifest.json"
    path.write_text(path.read_text().replace('"family": "block_matching"', '"family": "semi_global"'))
    with pytest.raises(FlowError, match=r"manifest\.json was edited"):
        manifest.require_as_made(folder)
    instantiate = importlib.import_module("instantiate")
    monkeypatch.setattr(instantiate.committed, "folder", lambda config: folder)
    for words in ([], ["--instance"], ["--kit", "vivado", "--out", str(tmp_path / "kit")]):
        monkeypatch.setattr(sys, "argv", ["instantiate.py", "--config", "tiny", *words])
        with pytest.raises(FlowError, match=r"manifest\.json was edited"):
            instantiate.main()
    assert not (tmp_path / "kit").exists()


def test_a_kit_needs_the_addresses_of_the_vhdl(monkeypatch, tmp_path):
    text = registers.DESCRIPTION.read_text()
    path = tmp_path / "registers.json"
    path.write_text(text.replace('"offset": 8,', '"offset": 248,', 1))
    monkeypatch.setattr(registers, "DESCRIPTION", path)
    with pytest.raises(FlowError, match="does not follow from registers.json"):
        contents.of("vivado", "tiny", 100)


def test_closed_standard_output():
    command = [sys.executable, ROOT / "scripts" / "instantiate.py", "--config", "tiny"]
    process = subprocess.run(
        ["sh", "-c", '"$@" >&-', "sh", *map(str, command)], stderr=subprocess.PIPE, text=True, check=False
    )
    refused(process, 2, "standard output is closed")


@pytest.mark.parametrize("command", ["cosim.py", "implement.py"])
def test_a_number_of_jobs_is_refused_before_all_else(command):
    refused(call(command, "--config", "tiny", "--jobs", 0), 2, "--jobs: '0' is no whole number, 1 or more")


@pytest.mark.parametrize(
    "text",
    [
        "{",
        "[]",
        '{"registers": 3}',
        '{"registers": []}',
        '{"registers": [3]}',
        '{"registers": [{"name": "id", "access": "read"}]}',
        '{"registers": [{"name": "id", "access": "read", "offset": 9}]}',
        '{"registers": [{"name": "id", "access": "read", "offset": 0}, {"name": "x", "access": "read", "offset": 0}]}',
        '{"registers": [{"name": "id", "access": "read", "offset": "0"}]}',
        '{"registers": [{"name": "id", "access": "read", "offset": 0, "fields": [{"name": "value"}]}]}',
    ],
)
def test_a_damaged_description_of_the_registers_is_refused(monkeypatch, tmp_path, text):
    path = tmp_path / "registers.json"
    path.write_text(text)
    assert registers.description() and registers.DESCRIPTION.is_relative_to(ROOT)
    monkeypatch.setattr(registers, "DESCRIPTION", path)
    with pytest.raises(FlowError, match=r"damaged .*registers\.json: "):
        registers.description()
