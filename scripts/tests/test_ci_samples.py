# SPDX-License-Identifier: Apache-2.0
"""The files that CI services and forges read, those of this project and the samples for others: linted as their
services read them, and what they call is there."""

import re
import subprocess
from pathlib import Path

import pytest

from conftest import where_reachable
from flow.base import venv
from flow.base.tools import ROOT

SAMPLES = "examples/ci"
FORMS = ".github/ISSUE_TEMPLATE"
REQUIREMENTS = ROOT / "scripts" / "requirements-samples.txt"
RULES = "{extends: default, rules: {line-length: {max: 120}}}"
# The container shall have what Debian has now, so packages are not pinned.
CONTAINER = ("hadolint", "--ignore", "DL3008")
YAML = ("yamllint", "-s", "-d", RULES)


def yaml_of(schema):
    return [YAML, ("check-jsonschema", "--builtin-schema", f"vendor.{schema}")]


LINTERS = {
    f"{SAMPLES}/github-cosimulation.yml": yaml_of("github-workflows"),
    f"{SAMPLES}/gitlab-ci.yml": yaml_of("gitlab-ci"),
    f"{SAMPLES}/Containerfile": [CONTAINER],
    ".github/workflows/ci.yml": yaml_of("github-workflows"),
    f"{FORMS}/config.yml": yaml_of("github-issue-config"),
    f"{FORMS}/wrong_result.yml": yaml_of("github-issue-forms"),
    f"{FORMS}/hardware.yml": yaml_of("github-issue-forms"),
    f"{FORMS}/proposal.yml": yaml_of("github-issue-forms"),
    "CITATION.cff": yaml_of("citation-file-format"),
}
CALLERS = [name for name in LINTERS if name.startswith((SAMPLES, ".github/workflows"))]
FAULTS = [
    (f"{SAMPLES}/github-cosimulation.yml", "    runs-on: ubuntu-latest\n", ""),
    (f"{SAMPLES}/github-cosimulation.yml", "jobs:\n", "jobs:\n  cosimulation: {runs-on: x}\n"),  # the key comes twice
    (f"{SAMPLES}/gitlab-ci.yml", "    when: always\n", "    when: sometimes\n"),
    (f"{SAMPLES}/gitlab-ci.yml", "  script:\n", "   script:\n"),
    (f"{SAMPLES}/Containerfile", "WORKDIR /work", "WORKDIR work"),
    (f"{SAMPLES}/Containerfile", "FROM debian:bookworm", "FROM debian"),
    (".github/workflows/ci.yml", "    container:", "    kontainer:"),
    (f"{FORMS}/config.yml", "true", "sometimes"),
    (f"{FORMS}/hardware.yml", "name: Use in a design\n", ""),
    ("CITATION.cff", "license: Apache-2.0", "license: Apache-20"),
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
    folders = [ROOT / SAMPLES, ROOT / ".github"]
    found = {path.relative_to(ROOT).as_posix() for folder in folders for path in folder.rglob("*") if path.is_file()}
    assert {*found, "CITATION.cff"} == set(LINTERS)


@pytest.mark.parametrize("name", LINTERS)
def test_no_complaint(complaints, name):
    assert complaints(name, ROOT / name) == []


@pytest.mark.parametrize("name, old, new", FAULTS)
def test_a_fault_is_found(complaints, tmp_path, name, old, new):
    text = (ROOT / name).read_text()
    assert text.count(old) == 1
    copy = tmp_path / Path(name).name
    copy.write_text(text.replace(old, new))
    assert complaints(name, copy)


@pytest.mark.parametrize("name", CALLERS)
def test_what_a_sample_calls_is_there(name):
    """Scripts of this project with options that they have; files of theirs that are kept."""
    text = (ROOT / name).read_text()
    calls = re.findall(r"(scripts/\w+\.(?:py|sh))((?: --[\w-]+)?)", text)
    assert calls or (" .ci/run\n" in text and (ROOT / ".ci" / "run").is_file())
    for script, option in calls:
        process = subprocess.run([ROOT / script, "--help"], capture_output=True, text=True)
        assert process.returncode == 0 and option.strip() in process.stdout
    kept = set(re.findall(r"build/\S+", text))
    assert kept <= {"build/cosim/regression", "build/cosim/regression/junit.xml"}, "where cosim.py puts them"
