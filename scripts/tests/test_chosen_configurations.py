# SPDX-License-Identifier: Apache-2.0
"""Builds of some configurations only, as README.md shows: minutes."""

import subprocess

import pytest

from flow.base.tools import ROOT


def run(*command):
    process = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    assert process.returncode == 0, process.stdout[-3000:] + process.stderr
    return process.stdout


@pytest.mark.parametrize("names", ["tiny;ambrosch2007", "ambrosch2007"])
def test_chosen_configurations_build_and_pass_their_tests(tmp_path, names):
    options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", f"-DSTEREO_CONFIGURATIONS={names}"]
    run("cmake", "-S", ROOT, "-B", tmp_path, *options)
    run("cmake", "--build", tmp_path)
    listed = run(tmp_path / "stereo_hls", "configurations")
    assert [line.partition(":")[0] for line in listed.splitlines()] == sorted(names.split(";"))
    assert "100% tests passed" in run("ctest", "--test-dir", tmp_path, "-L", "unit", "--no-tests=error")
