# SPDX-License-Identifier: Apache-2.0
"""A command that is given a folder replaces what an earlier run has made there, and no file of the user's. Options that
would have no effect are refused."""

import pytest

from flow.base import places
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.shell import registers
from flow_commands import call, refused


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


def test_results_of_an_earlier_run_are_replaced(tmp_path):
    folder = places.results_folder(tmp_path / "new", ["report.json"])
    (folder / "report.json").write_text("of the first run")
    (folder / "mine.txt").write_text("the user's own")
    assert places.results_folder(folder, ["report.json"]) == folder  # the second run
    assert (folder / "mine.txt").is_file()


def test_a_folder_of_an_earlier_run_is_emptied(tmp_path):
    folder = places.emptied_folder(tmp_path / "new")
    (folder / "routed").write_text("of the first run")
    assert [path.name for path in places.emptied_folder(folder).iterdir()] == [places.MARK]


def test_a_link_to_a_folder_of_the_user_is_not_emptied(tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "file").write_text("the user's own")
    (tmp_path / "link").symlink_to(tmp_path / "mine")
    with pytest.raises(FlowError, match="is not empty"):
        places.emptied_folder(tmp_path / "link")
    assert (tmp_path / "mine" / "file").is_file()


@pytest.mark.parametrize(
    "command, words, option, mode",
    [
        ("camera_system.py", ["--show", "--seeds", 2], "--seeds", "--show"),
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
