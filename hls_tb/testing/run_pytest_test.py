# SPDX-License-Identifier: Apache-2.0
"""cmake/run_pytest.py: what ctest is told of each way in which a file of tests can end."""

import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(os.environ.get("STEREO_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
# Nothing of the tests of tests stands in the summary.
ALONE = {name: value for name, value in os.environ.items() if name not in ("STEREO_SKIPPED", "STEREO_TIMES")}
PASSES = "def test_passes():\n    pass\n"
FAILS = "def test_fails():\n    assert False\n"
SKIPS = "import pytest\ndef test_skips():\n    pytest.skip('ghdl is missing')\n"
SKIPS_WHOLE = "import pytest\npytest.skip('ghdl is missing', allow_module_level=True)\n"


def test_skipped_cases_of_a_file_that_passes_are_named(tmp_path):
    (tmp_path / "case_test.py").write_text(SKIPS + PASSES)
    command = [sys.executable, ROOT / "cmake" / "run_pytest.py", "case_test.py"]
    skipped = tmp_path / "skipped.txt"
    environment = {**ALONE, "STEREO_SKIPPED": str(skipped)}
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, env=environment)
    assert result.returncode == 0
    assert "SKIPPED CASE: case_test.py::test_skips: ghdl is missing" in result.stdout
    assert skipped.read_text() == "case_test.py::test_skips: ghdl is missing\n"


MISSES = "import pytest\n@pytest.mark.xfail(strict=True, reason='an aim')\ndef test_misses():\n    assert {}\n"


def test_a_case_that_fails_as_expected_is_named_and_has_run(tmp_path):
    (tmp_path / "case_test.py").write_text(MISSES.format(False))
    command = [sys.executable, ROOT / "cmake" / "run_pytest.py", "case_test.py"]
    skipped = tmp_path / "skipped.txt"
    environment = {**ALONE, "STEREO_SKIPPED": str(skipped)}
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, env=environment)
    assert result.returncode == 0, "it has run"
    assert skipped.read_text() == "case_test.py::test_misses: fails as expected: an aim\n"
    (tmp_path / "case_test.py").write_text(MISSES.format(True))
    assert subprocess.run(command, cwd=tmp_path, capture_output=True, timeout=60, env=environment).returncode == 1


@pytest.mark.parametrize(
    "text, code, skip_shown",
    [
        (PASSES, 0, False),
        (FAILS, 1, False),
        (SKIPS, 77, True),
        (SKIPS_WHOLE, 77, True),
        (SKIPS + PASSES, 0, False),
        (SKIPS + FAILS, 1, False),
        ("", 5, False),
        ("syntax error", 2, False),
    ],
)
def test_exit_code(tmp_path, text, code, skip_shown):
    file = tmp_path / "case_test.py"
    file.write_text(text)
    command = [sys.executable, ROOT / "cmake" / "run_pytest.py", file]
    result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, env=ALONE)
    assert result.returncode == code, result.stdout + result.stderr
    assert ("SKIP: ghdl is missing" in result.stdout) == skip_shown


# Its mark is not written out: StereoTests.cmake looks for the word in this file.
BUSY = """
import pytest, subprocess, sys
def test_fast(): pass
@pytest.mark.MARK
def test_slow(): subprocess.run([sys.executable, "-c", "import time\\nwhile time.process_time() < 1: pass"], check=True)
""".replace("MARK", "slow")


def test_the_processor_time_of_a_test_is_kept(tmp_path):
    """With that of the processes it has started; and the cases that are slow are a test of their own."""
    (tmp_path / "busy_test.py").write_text(BUSY)
    for name, cases in (("quick", "not slow"), ("long", "slow")):
        command = [sys.executable, ROOT / "cmake" / "run_pytest.py", "-m", cases, "busy_test.py"]
        environment = {**ALONE, "STEREO_TIMES": str(tmp_path / "times"), "STEREO_TEST": name}
        result = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60, env=environment)
        assert result.returncode == 0 and "1 passed, 1 deselected" in result.stdout, result.stdout
    (_, first), (long, second) = (line.split() for line in (tmp_path / "times").read_text().splitlines())
    assert (first, second) == ("quick", "long") and float(long) >= 1, "the second that the child takes on any machine"
