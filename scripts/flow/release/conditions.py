# SPDX-License-Identifier: Apache-2.0
"""What must hold before a release. Each condition returns a sentence for each thing that is against it."""

from __future__ import annotations

import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable
from pathlib import Path

from ..base.tools import ROOT
from ..pages import links

PAGE_COMMANDS = (
    ("performance.py", "--check"),
    ("features.py", "--check"),
    ("reference.py", "--check"),
    ("registers.py", "--check"),
    ("camera_system.py", "--check"),
    ("recovery.py", "--check"),
    ("timing_diagrams.py", "--check"),
    ("quality.py", "--check"),
    ("post_processing.py", "--check"),
    ("plan.py", "--check"),
    ("build_example.py", "--check"),
    ("mutate.py", "--check"),
)
VHDL_COMMANDS = (("synthesize.py", "--check"),)
RESULTS = ROOT / "build" / "ci" / "results"  # where .ci/run leaves them
SETS = ("fast", "slow")


def git(root: Path, *words: str) -> str:
    return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=True).stdout.strip()


def clean_tree(root: Path = ROOT) -> list[str]:
    changed = git(root, "status", "--porcelain").splitlines()
    return [f"not committed: {line.strip()}" for line in changed]


def version(root: Path = ROOT) -> str:
    """Of CMakeLists.txt, where it is declared."""
    found = re.search(r"^project\(\w+ VERSION (\S+)", (root / "CMakeLists.txt").read_text(), re.MULTILINE)
    return found[1] if found else ""


def one_version(root: Path = ROOT) -> list[str]:
    """The changelog describes this version, FuseSoC's file has it, and no other commit has its tag."""
    this, found = version(root), []
    newest = re.search(r"^## (\S+)", (root / "CHANGELOG.md").read_text(), re.MULTILINE)
    if newest is None or newest[1] != this:
        found.append(f"CHANGELOG.md begins with {newest[1] if newest else 'no version'}, CMakeLists.txt has {this}")
    if f"name: ::stereo_hls:{this}\n" not in (root / "stereo_hls.core").read_text():
        found.append(f"stereo_hls.core has another version than CMakeLists.txt, {this}")
    tag = f"v{this}"
    if tag in git(root, "tag").split() and git(root, "rev-parse", f"{tag}^{{commit}}") != git(
        root, "rev-parse", "HEAD"
    ):
        found.append(f"the tag {tag} stands at another commit")
    return found


def refused_by(commands: Iterable[tuple[str, ...]], scripts: Path = ROOT / "scripts") -> list[str]:
    """What failing commands say. One whose tool or data is missing has checked nothing and counts as failing."""
    found = []
    for name, *options in commands:
        process = subprocess.run([sys.executable, scripts / name, *options], capture_output=True, text=True)
        if process.returncode:
            said = (process.stderr or process.stdout).strip().splitlines()
            found.append(said[-1] if said else f"{name} ended with exit code {process.returncode}")
    return found


def whole_links(root: Path = ROOT) -> list[str]:
    broken = [sentence for page in links.pages(root) for sentence in links.broken(page)]
    return broken + [f"docs/README.md does not link to {name}" for name in sorted(links.unreachable(root))]


def passed_tests(results: Path = RESULTS, root: Path = ROOT) -> list[str]:
    """Both sets ran at this commit, nothing failed, and what was skipped says why."""
    if not all((results / name).is_file() for name in ("commit.txt", *(f"{name}.xml" for name in SETS))):
        return [f"{results} has no whole run of the tests; run .ci/run"]
    commit, head = (results / "commit.txt").read_text().strip(), git(root, "rev-parse", "HEAD")
    found = [] if commit == head else [f"the tests ran at {commit or 'an unknown commit'}, not at {head}"]
    for name in SETS:
        cases = list(ElementTree.parse(results / f"{name}.xml").iter("testcase"))
        if not cases:
            found.append(f"the {name} set has no test")
        for case in cases:
            found += _against(case)
        skipped = results / f"{name}_skipped.txt"
        for line in skipped.read_text().splitlines() if skipped.is_file() else ():
            case_name, _, reason = line.partition(": ")
            if not reason.strip():
                found.append(f"{case_name} is skipped without a reason")
    return found


def _against(case: ElementTree.Element) -> list[str]:
    name, output = case.get("name", "a test"), case.findtext("system-out") or ""
    if case.find("failure") is not None or case.get("status") == "fail":
        return [f"{name} failed"]
    if case.get("status") != "run" and not re.search(r"SKIP: \S", output):
        return [f"{name} is skipped without a reason"]
    return []


CONDITIONS = (
    ("the tree is clean", clean_tree),
    ("the version is declared once and described", one_version),
    ("every link leads somewhere", whole_links),
    ("the pages are up to date", lambda: refused_by(PAGE_COMMANDS)),
    ("the VHDL follows from the sources", lambda: refused_by(VHDL_COMMANDS)),
    ("all tests passed at this commit", passed_tests),
)
