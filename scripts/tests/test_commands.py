# SPDX-License-Identifier: Apache-2.0
"""Wrong use of the commands: one clear sentence, the documented exit code, nothing half-written."""

import json
import os
import shutil
import subprocess
import sys

import pytest

from flow.base import committed
from flow.base.tools import ROOT, find_stereo_hls
from flow.synthesis import manifest
from flow_commands import call, cosim, refused, scene


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    return scene(tmp_path_factory.mktemp("scene"), "tiny")


@pytest.fixture
def nothing_written(tmp_path):
    """The output folder, which must hold no result in the end: no report, or one of an error."""
    yield tmp_path / "out"
    path = tmp_path / "out" / "report.json"
    assert not path.exists() or json.loads(path.read_text())["error"]["exit_code"] in (2, 3, 4)


@pytest.fixture
def tiny_rtl(tmp_path):
    """A copy of the committed VHDL of tiny to damage."""
    return shutil.copytree(committed.folder("tiny"), tmp_path / "rtl")


def test_help_names_the_exit_codes():
    for command in ("cosim.py", "synthesize.py"):
        process = call(command, "--help")
        assert process.returncode == 0
        assert "exit codes: 0 done, 1 the answer is no" in " ".join(process.stdout.split())


def test_a_reader_that_leaves_early_is_no_failure_to_report():
    words = [str(ROOT / "scripts" / "synthesize.py"), "--check", "--config", "tiny"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.close()
        assert process.stderr.read() == ""
    assert process.returncode == 141, "as for a program that SIGPIPE ends"


def test_missing_option(nothing_written):
    refused(call("cosim.py"), 2, "required", "--config", "--help")
    refused(call("cosim.py", "--config", "tiny", "--left", "left.png"), 2, "required", "--left", "--right")


@pytest.mark.parametrize(
    "options", [["--broken", -1], ["--broken", 2, "--frames", 2], ["--broken", 2, "--rows", "0:8"]]
)
def test_a_broken_stream_has_no_frames_and_rows(options, pair, nothing_written):
    refused(cosim("tiny", pair, nothing_written, *options), 2, "--broken")


def test_unknown_configuration(pair, nothing_written):
    refused(cosim("huge", pair, nothing_written), 2, "unknown configuration 'huge'", "ambrosch2007, ", "tiny")
    refused(call("synthesize.py", "--config", "huge", "--check"), 2, "unknown configuration 'huge'")


def test_missing_image(pair, nothing_written):
    refused(cosim("tiny", ("nowhere.png", pair[1]), nothing_written), 2, "nowhere.png")


def test_image_of_another_size(tmp_path, pair, nothing_written):
    large = scene(tmp_path / "large", "ambrosch2007")
    refused(cosim("tiny", large, nothing_written), 2, "320x240", "32x12", "--fit")
    refused(cosim("tiny", (pair[0], large[1]), nothing_written), 2, "left", "right")


@pytest.mark.parametrize("rows", ["0", "5.", "5:5", "8:3", "0:13", "a:b", "-1:4"])
def test_bad_rows(pair, nothing_written, rows):
    refused(cosim("tiny", pair, nothing_written, f"--rows={rows}"), 2, "row")


@pytest.mark.parametrize(
    "option,value",
    [
        ("--frames", "0"),
        ("--frames", "many"),
        ("--stall-percent", "200"),
        ("--stress-clocks", "1000"),
        ("--simulator", "modelsim"),
        ("--wave", "wave.txt"),
        ("--seed", "-1"),
        ("--seed", str(2**64)),
        ("--rows", ""),
        ("--out", ""),
        ("--watchdog", "nan"),
        ("--watchdog", "-1"),
    ],
)
def test_bad_values(pair, nothing_written, option, value):
    refused(cosim("tiny", pair, nothing_written, option, value), 2, option.strip("-"))


def test_rows_without_any_output_are_refused(pair, nothing_written):
    refused(cosim("tiny", pair, nothing_written, "--rows", "0:1"), 2, "would give no output")


@pytest.mark.parametrize(
    "tool,variable,options",
    [
        ("ghdl", "GHDL", []),
        ("verilator", "VERILATOR", ["--simulator", "verilator"]),
        ("nvc", "NVC", ["--simulator", "nvc"]),
    ],
)
def test_missing_simulator(pair, nothing_written, tmp_path, tool, variable, options):
    copy = shutil.copytree(committed.folder("tiny"), tmp_path / "rtl")
    design = copy / "stereo_core_tiny.vhd"
    design.write_text(design.read_text() + "-- so that nothing built before fits\n")
    entry = manifest.read(copy)
    entry["files"]["stereo_core_tiny.vhd"] = manifest.digest(design)
    manifest.write(copy, entry)
    process = cosim("tiny", pair, nothing_written, "--rtl", copy, *options, environment={variable: "/nowhere/tool"})
    refused(process, 3, f"{tool} not found in {variable}=/nowhere/tool", "apt-get install")


def test_missing_bambu_says_where_to_get_it():
    refused(
        call("synthesize.py", "--config", "tiny", environment={"BAMBU": "/nowhere/bambu"}),
        3,
        "bambu not found",
        "https://release.bambuhls.eu",
        "BAMBU",
    )


def test_missing_program_says_how_to_build_it(pair):
    words = ["--config", "tiny", "--left", pair[0], "--right", pair[1]]
    process = call("cosim.py", *words, environment={"STEREO_HLS": "/nowhere/stereo_hls"})
    refused(process, 3, "stereo_hls not found at /nowhere/stereo_hls", "scripts/setup.sh")


def test_another_program_in_its_place(pair, tmp_path):
    arguments = ("cosim.py", "--config", "tiny", "--left", pair[0], "--right", pair[1])
    refused(call(*arguments, environment={"STEREO_HLS": str(tmp_path)}), 3, f"stereo_hls not found at {tmp_path}")
    refused(call(*arguments, environment={"STEREO_HLS": "/bin/true"}), 4, "/bin/true does not list configurations")


@pytest.mark.parametrize(
    "words",
    [
        ["synthesize.py", "--config", "tiny", "--out", "made"],
        ["verify_axi.py", "--config", "tiny", "--frames", 1, "--out", "made"],
    ],
    ids=["synthesize.py", "verify_axi.py"],
)
def test_a_core_that_is_not_built_is_missed_before_the_tool_runs(tmp_path, words):
    """What needs it comes minutes later. A program without modules beside it stands for one whose core is not built."""
    program = shutil.copy(find_stereo_hls(), tmp_path)
    tool = tmp_path / "bambu"
    tool.write_text(f"#!/bin/sh\ntouch '{tmp_path}/ran'\n")
    tool.chmod(0o755)
    words = [tmp_path / word if word == "made" else word for word in words]
    process = call(*words, environment={"STEREO_HLS": program, "BAMBU": str(tool)})
    refused(process, 3, "the clocked core of tiny is not built", "cmake --build")
    assert not (tmp_path / "made").exists() and not (tmp_path / "ran").exists()


def test_no_vhdl_for_this_configuration(pair, nothing_written, tmp_path):
    refused(
        cosim("tiny", pair, nothing_written, "--rtl", tmp_path / "empty"),
        2,
        "it has no manifest.json",
        "synthesize.py",
    )


def damage(tiny_rtl, **changes):
    path = tiny_rtl / "manifest.json"
    entry = json.loads(path.read_text())
    for key, value in changes.items():
        entry.pop(key) if value is None else entry.update({key: value})
    path.write_text(json.dumps(entry))


def test_damaged_manifests(pair, tiny_rtl, nothing_written):
    good = (tiny_rtl / "manifest.json").read_text()
    damage(tiny_rtl, files=None)
    refused(cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl), 2, "damaged manifest", "no files")
    (tiny_rtl / "manifest.json").write_text(good[: len(good) // 2])
    refused(cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl), 2, "damaged manifest")
    (tiny_rtl / "manifest.json").write_text("[]")
    refused(cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl), 2, "damaged manifest")
    (tiny_rtl / "manifest.json").write_text(good)
    damage(tiny_rtl, format="stereo-hls manifest 9")
    refused(cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl), 2, "damaged manifest", "manifest 9")
    (tiny_rtl / "manifest.json").write_text(good)
    damage(tiny_rtl, files={})
    refused(cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl), 2, "names no VHDL file")


def test_vhdl_edited_by_hand(pair, tiny_rtl, nothing_written):
    design = tiny_rtl / "stereo_core_tiny.vhd"
    design.write_text(design.read_text() + "-- edited\n")
    process = cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl, takes_edited=False)
    refused(process, 2, "stereo_core_tiny.vhd differs from its manifest")
    design.unlink()
    process = cosim("tiny", pair, nothing_written, "--rtl", tiny_rtl)
    refused(process, 2, "stereo_core_tiny.vhd is named by the manifest but missing")


def test_output_folder_that_cannot_be(pair, tmp_path):
    (tmp_path / "file").write_text("")
    refused(cosim("tiny", pair, tmp_path / "file" / "out"), 2, "cannot create")

    refused(
        cosim("tiny", pair, tmp_path / "out", "--wave", tmp_path / "file" / "wave.vcd"),
        2,
        "cannot create the folder of --wave",
    )
    refused(call("build_example.py", "--out", tmp_path / "file"), 2, "file: File exists")
    refused(call("lint.py", "--rtl", tmp_path / "file"), 2, "file/", "Not a directory")


def test_shell_scripts_refuse_unknown_options():
    refused(call("tidy.sh", "--everything"), 2, "unknown option '--everything'")
    refused(call("tidy.sh", "nowhere.cpp"), 2, "nowhere.cpp: there is no such file")
    refused(
        call("tidy.sh", environment={"CLANG_TIDY": "/nowhere/clang-tidy"}),
        3,
        "SKIP: /nowhere/clang-tidy is not installed",
        "apt-get install",
    )
    refused(call("setup.sh", "--everything"), 2, "unknown option '--everything'")
    refused(call("fuzz.sh", "--everything"), 2, "unknown option '--everything'")
    refused(call("fuzz.sh", "everything"), 2, "unknown target 'everything'", "calibration", "pfm")
    refused(call("fuzz.sh", "--seconds", "0"), 2, "--seconds")


def run_test_sh(folder, *options, setup="exit 0", ctest="exit 0"):
    """The lines that scripts/test.sh prints in a folder where setup.sh, ctest and cmake are stand-ins."""
    (folder / "scripts").mkdir()
    (folder / "build" / "release").mkdir(parents=True)
    shutil.copy(ROOT / "scripts" / "test.sh", folder / "scripts")
    for path, text in (("scripts/setup.sh", setup), ("cmake", "exit 0"), ("ctest", ctest)):
        (folder / path).write_text(f"#!/bin/sh\n{text}\n")
        (folder / path).chmod(0o755)
    environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}", "STEREO_PRESET": "release"}
    words = [folder / "scripts" / "test.sh", *options]
    return subprocess.run(words, capture_output=True, text=True, env=environment, check=True).stdout.splitlines()


@pytest.mark.parametrize(
    "options, with_slow",
    [
        ([], False),
        (["-R", "slow_name"], False),
        (["-L", "cosim"], False),
        (["--label-regex", "unit", "-R", "kit"], False),
        (["-L", "slow"], True),
        (["-R", "name", "-L", "cosim|slow"], True),
        (["--label-regex=slow"], True),
        (["-LE", "none"], True),
        (["--label-exclude", "unit"], True),
    ],
)
def test_slow_tests_run_only_where_their_label_is_named(tmp_path, options, with_slow):
    """ctest shows its options."""
    given = run_test_sh(tmp_path, *options, ctest='printf "%s\\n" "$@"')
    assert given[given.index("-j") + 2 :] == options + ([] if with_slow else ["-LE", "slow"])


def test_the_processor_time_of_the_build_and_of_all_is_shown(tmp_path):
    busy = f"{sys.executable} -c 'import time\nwhile time.process_time() < 0.5: pass'"
    said = run_test_sh(tmp_path, "--times", setup=busy, ctest=busy)
    seconds = {what: float(number) for number, what in (line.split(maxsplit=1) for line in said[-2:])}
    assert seconds["build"] >= 0.5 and seconds["all, with the other tests"] >= seconds["build"] + 0.5


def test_fuzzing_needs_the_sanitizers_of_its_compiler(tmp_path):
    compiler = tmp_path / "clang++-16"
    compiler.write_text("#!/bin/sh\nexit 1\n")
    compiler.chmod(0o755)
    process = call("fuzz.sh", "pfm", environment={"PATH": f"{tmp_path}:{os.environ['PATH']}"})
    refused(process, 3, "clang++-16 cannot link with its sanitizers", "apt-get install", "libclang-rt")
