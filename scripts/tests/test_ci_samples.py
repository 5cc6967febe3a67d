# SPDX-License-Identifier: Apache-2.0
"""The samples for CI services: linted as their services read them, and what they call is there."""

import re
import shutil
import subprocess

import pytest

from conftest import where_reachable
from flow.base import venv
from flow.base.tools import ROOT

SAMPLES = ROOT / "examples" / "ci"
REQUIREMENTS = ROOT / "scripts" / "requirements-samples.txt"
RULES = "{extends: default, rules: {line-length: {max: 120}}}"
# The container shall have what Debian has now, so packages are not pinned.
CONTAINER = ("hadolint", "--ignore", "DL3008")
LINTERS = {
    "github-cosimulation.yml": [
        ("yamllint", "-s", "-d", RULES),
        ("check-jsonschema", "--builtin-schema", "vendor.github-workflows"),
    ],
    "gitlab-ci.yml": [
        ("yamllint", "-s", "-d", RULES),
        ("check-jsonschema", "--builtin-schema", "vendor.gitlab-ci"),
    ],
    "Containerfile": [CONTAINER],
}
FAULTS = [
    ("github-cosimulation.yml", "    runs-on: ubuntu-latest\n", ""),
    ("github-cosimulation.yml", "jobs:\n", "jobs:\n  cosimulation: {runs-on: x}\n"),  # the key comes twice
    ("gitlab-ci.yml", "    when: always\n", "    when: sometimes\n"),
    ("gitlab-ci.yml", "  script:\n", "   script:\n"),
    ("Containerfile", "WORKDIR /work", "WORKDIR work"),
    ("Containerfile", "FROM debian:bookworm", "FROM debian"),
]


@pytest.fixture(scope="module")
def complaints():
    """What the linters of a sample say of a file; nothing where it is right."""
    programs = where_reachable(lambda: venv.ensure("venv-samples", REQUIREMENTS, "the linters of the CI samples"))

    def lint(name, path):
        said = []
        for program, *options in LINTERS[name]:
            process = subprocess.run([programs / program, *options, path], capture_output=True, text=True)
            said += [process.stdout + process.stderr] if process.returncode else []
        return said

    return lint


def test_every_sample_has_its_linters():
    assert {path.name for path in SAMPLES.iterdir()} == set(LINTERS)


@pytest.mark.parametrize("name", LINTERS)
def test_no_complaint(complaints, name):
    assert complaints(name, SAMPLES / name) == []


@pytest.mark.parametrize("name, old, new", FAULTS)
def test_a_fault_is_found(complaints, tmp_path, name, old, new):
    text = (SAMPLES / name).read_text()
    assert text.count(old) == 1
    shutil.copy(SAMPLES / name, tmp_path)
    (tmp_path / name).write_text(text.replace(old, new))
    assert complaints(name, tmp_path / name)


@pytest.mark.parametrize("name", LINTERS)
def test_what_a_sample_calls_is_there(name):
    """Scripts of this project with options that they have; files of theirs that are kept."""
    text = (SAMPLES / name).read_text()
    calls = re.findall(r"(scripts/\w+\.(?:py|sh))((?: --[\w-]+)?)", text)
    assert calls
    for script, option in calls:
        process = subprocess.run([ROOT / script, "--help"], capture_output=True, text=True)
        assert process.returncode == 0 and option.strip() in process.stdout
    kept = set(re.findall(r"build/\S+", text))
    assert kept <= {"build/cosim/regression", "build/cosim/regression/junit.xml"}, "where cosim.py puts them"
