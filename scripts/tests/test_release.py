# SPDX-License-Identifier: Apache-2.0
"""scripts/release.py refuses each thing that must not be in a release, and only that."""

import subprocess

import pytest

from conftest import need
from flow.base.tools import ROOT
from flow.release import conditions
from flow_commands import call

PASSED = '<testcase name="a" status="run"><system-out>fine</system-out></testcase>'
SKIPPED = '<testcase name="b" status="notrun"><skipped message="77"/><system-out>{}</system-out></testcase>'
FAILED = '<testcase name="c" status="fail"><failure message=""/><system-out>SKIP: not so</system-out></testcase>'


def write(folder, files):
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def commit(folder):
    words = ["-c", "user.name=test", "-c", "user.email=test@example.org", "commit", "-q", "--allow-empty", "-m", "test"]
    for command in (["add", "."], words):
        subprocess.run(["git", "-C", folder, *command], check=True)


@pytest.fixture
def project(tmp_path):
    """The files that the conditions read, committed, in a repository of their own."""
    need("git")
    folder = tmp_path / "project"
    files = {
        "CMakeLists.txt": "project(stereo_hls VERSION 1.2.3 LANGUAGES CXX)\n",
        "CHANGELOG.md": "# Changelog\n\n## 1.2.3\n\n## 1.2.2\n",
        "stereo_hls.core": "CAPI=2:\nname: ::stereo_hls:1.2.3\n",
        "README.md": "[all](docs/README.md)\n",
        "docs/README.md": "[a page](page.md)\n",
        "docs/page.md": "# A page\n",
    }
    write(folder, files)
    subprocess.run(["git", "-C", folder, "init", "-q"], check=True)
    commit(folder)
    return folder


@pytest.fixture
def results(project, tmp_path):
    """Those of .ci/run where everything passed."""
    folder = tmp_path / "results"
    skipped = SKIPPED.format("SKIP: nvc is not installed")
    files = {
        "commit.txt": conditions.git(project, "rev-parse", "HEAD") + "\n",
        "fast.xml": f"<testsuite>{PASSED}{skipped}</testsuite>",
        "slow.xml": f"<testsuite>{PASSED}</testsuite>",
        "fast_skipped.txt": "test_x.py::test_y: nvc is not installed\n",
    }
    write(folder, files)
    return folder


def test_the_tree_must_be_clean(project):
    assert conditions.clean_tree(project) == []
    (project / "new.txt").write_text("new")
    assert conditions.clean_tree(project) == ["not committed: ?? new.txt"]
    commit(project)
    (project / "new.txt").write_text("changed")
    assert conditions.clean_tree(project) == ["not committed: M new.txt"]


def test_the_version_must_be_described(project):
    assert conditions.version(project) == "1.2.3" and conditions.one_version(project) == []
    write(project, {"CHANGELOG.md": "# Changelog\n\n## Unreleased\n\n## 1.2.3\n"})
    (found,) = conditions.one_version(project)
    assert "CHANGELOG.md begins with Unreleased" in found


def test_other_files_must_have_the_same_version(project):
    write(project, {"stereo_hls.core": "CAPI=2:\nname: ::stereo_hls:1.2.2\n"})
    (found,) = conditions.one_version(project)
    assert "stereo_hls.core" in found


def test_a_tag_must_not_move(project):
    subprocess.run(["git", "-C", project, "tag", "v1.2.3"], check=True)
    assert conditions.one_version(project) == []
    commit(project)
    assert conditions.one_version(project) == ["the tag v1.2.3 stands at another commit"]


def test_links_must_lead_somewhere(project):
    assert conditions.whole_links(project) == []
    write(project, {"docs/page.md": "[gone](gone.md)\n", "docs/lonely.md": "# Nobody links here\n"})
    found = conditions.whole_links(project)
    assert found == ["page.md: gone.md: there is no such file", "docs/README.md does not link to lonely.md"]


def test_pages_must_be_up_to_date(tmp_path):
    write(tmp_path, {"good.py": "", "stale.py": "import sys\nsys.exit('stale.py: not up to date: docs/a.md')\n"})
    assert conditions.refused_by([("good.py", "--check")], tmp_path) == []
    both = [("good.py", "--check"), ("stale.py", "--check")]
    assert conditions.refused_by(both, tmp_path) == ["stale.py: not up to date: docs/a.md"]
    write(tmp_path, {"silent.py": "import sys\nsys.exit(3)\n"})
    assert conditions.refused_by([("silent.py",)], tmp_path) == ["silent.py ended with exit code 3"]


def test_every_page_command_is_there_and_has_the_option():
    for name, option in (*conditions.PAGE_COMMANDS, *conditions.VHDL_COMMANDS):
        process = call(name, "--help")
        assert process.returncode == 0 and option in process.stdout
    checked = {name for name, _ in (*conditions.PAGE_COMMANDS, *conditions.VHDL_COMMANDS)}
    with_check = {path.name for path in (ROOT / "scripts").glob("*.py") if '"--check"' in path.read_text()}
    assert with_check == checked


def test_results_without_a_fault(project, results):
    assert conditions.passed_tests(results, project) == []


@pytest.mark.parametrize(
    "file, text, words",
    [
        ("slow.xml", None, "no whole run of the tests"),
        ("commit.txt", "0123\n", "the tests ran at 0123"),
        ("commit.txt", "\n", "an unknown commit"),
        ("slow.xml", "<testsuite/>", "the slow set has no test"),
        ("slow.xml", f"<testsuite>{FAILED}</testsuite>", "c failed"),
        ("fast.xml", f"<testsuite>{SKIPPED.format('')}</testsuite>", "b is skipped without a reason"),
        ("fast.xml", f"<testsuite>{SKIPPED.format('SKIP: ')}</testsuite>", "b is skipped without a reason"),
        ("fast_skipped.txt", "test_x.py::test_y: \n", "test_x.py::test_y is skipped without a reason"),
    ],
)
def test_tests_must_have_passed(project, results, file, text, words):
    if text is None:
        (results / file).unlink()
    else:
        (results / file).write_text(text)
    (found,) = conditions.passed_tests(results, project)
    assert words in found


def test_ci_keeps_what_the_check_list_reads():
    text = (ROOT / ".ci" / "run").read_text()
    assert "build/ci/results" in text and "commit.txt" in text
    for name in conditions.SETS:
        assert f"run_set {name}" in text


def test_the_project_has_one_version():
    assert f"name: ::stereo_hls:{conditions.version()}\n" in (ROOT / "stereo_hls.core").read_text()
