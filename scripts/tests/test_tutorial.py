# SPDX-License-Identifier: Apache-2.0
"""docs/tutorial.md as a reader works through it: in a copy of the repository, every edit is applied and every command
run, in the order of the page, and each line that the page shows must be printed.

The page's blocks: `diff` an edit; `sh` commands, after which may stand the tools that they need; `text` the beginnings
of lines that the commands above it print."""

import os
import re
import shutil
import subprocess
from dataclasses import dataclass

import pytest

from flow.base.tools import ROOT

PAGE = ROOT / "docs" / "tutorial.md"
VARIABLES = {"bambu": "BAMBU", "ghdl": "GHDL", "yosys": "YOSYS"}


@dataclass(frozen=True)
class Block:
    line: int
    kind: str
    tools: tuple
    text: str


def blocks_of(text):
    found = []
    for match in re.finditer(r"^```(\w+)((?: \w+)*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL):
        found.append(
            Block(text.count("\n", 0, match.start()) + 1, match.group(1), tuple(match.group(2).split()), match.group(3))
        )
    return found


def steps_of(blocks):
    """[(block, lines that it must print)]"""
    steps = []
    for block in blocks:
        if block.kind == "text":
            steps[-1][1].extend(block.text.splitlines())
        else:
            steps.append((block, []))
    return steps


def missing_tool(block):
    return next((tool for tool in block.tools if shutil.which(os.environ.get(VARIABLES[tool]) or tool) is None), None)


class Reader:
    """Works through the page in a folder. Exported variables last from one block of commands to the next."""

    def __init__(self, folder):
        self.folder, self.exports, self.printed = folder, [], {}

    def copy_repository(self):
        names = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=True).stdout.split(b"\0")
        for name in filter(None, names):
            source, target = ROOT / os.fsdecode(name), self.folder / os.fsdecode(name)
            if source.is_file():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(source, target)

    def follow(self, block):
        """The finished process of a block."""
        if block.kind == "diff":
            # The folder may stand in another checkout, of which git would take the paths.
            outside = {**os.environ, "GIT_CEILING_DIRECTORIES": str(self.folder.parent)}
            return subprocess.run(
                ["git", "apply", "-"], input=block.text, cwd=self.folder, capture_output=True, text=True, env=outside
            )
        script = "\n".join(["set -euo pipefail", *self.exports, block.text])
        self.exports += [line for line in block.text.splitlines() if line.startswith("export ")]
        environment = {name: value for name, value in os.environ.items() if name != "STEREO_HLS"}
        return subprocess.run(
            ["bash", "-c", script],
            cwd=self.folder,
            capture_output=True,
            text=True,
            env=environment,
            stdin=subprocess.DEVNULL,
        )


def complaint(process, lines):
    """What is wrong with a finished block, or None."""
    if process.returncode != 0:
        return f"exit code {process.returncode}: {process.stderr[-1500:]}{process.stdout[-500:]}"
    printed = process.stdout.splitlines()
    lacking = [line for line in lines if not any(shown.startswith(line) for shown in printed)]
    return f"did not print {lacking}, but:\n{process.stdout[-2000:]}" if lacking else None


STEPS = steps_of(blocks_of(PAGE.read_text()))


@pytest.fixture(scope="module")
def followed(tmp_path_factory):
    """{line of a block: what was wrong with it, or None}; a block whose tool is missing and all after a wrong one are
    not there."""
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("SKIP: this is no git checkout, which names the files to copy")
    reader, results = Reader(tmp_path_factory.mktemp("tutorial")), {}
    reader.copy_repository()
    for block, lines in STEPS:
        if missing_tool(block):
            continue
        results[block.line] = complaint(reader.follow(block), lines)
        if results[block.line]:
            break
    return results


@pytest.mark.parametrize("block,lines", STEPS, ids=[f"line {block.line}, {block.kind}" for block, _ in STEPS])
def test_step(followed, block, lines):
    if missing_tool(block):
        pytest.skip(f"SKIP: {missing_tool(block)} is not installed")
    assert block.line in followed, "an earlier step failed"
    assert followed[block.line] is None, followed[block.line]


def test_the_page_has_every_kind_of_step():
    kinds = [block.kind for block, _ in STEPS]
    assert kinds.count("diff") >= 6 and kinds.count("sh") >= 6 and set(kinds) == {"diff", "sh"}
    text = PAGE.read_text()
    assert text.count("\n```") == 2 * len(blocks_of(text)), "every block is closed and of a known kind"
    for tool in VARIABLES:
        assert any(tool in block.tools for block, _ in STEPS)


@pytest.mark.parametrize(
    "page,words",
    [
        ("```diff\n--- a/hls/none.hpp\n+++ b/hls/none.hpp\n@@ -1 +1 @@\n-a\n+b\n```\n", "exit code"),
        ("```sh\nfalse | true\n```\n", "exit code 1"),
        ("```sh\necho 12 tests\n```\n\n```text\n13 tests\n```\n", "did not print ['13 tests']"),
        ("```sh\nexport NUMBER=4\n```\n\n```sh\necho $NUMBER\n```\n\n```text\n5\n```\n", "but:\n4"),
        ("```sh\nexport NUMBER=4\n```\n\n```sh\necho $NUMBER\n```\n\n```text\n4\n```\n", None),
    ],
)
def test_a_wrong_step_is_noticed(tmp_path, page, words):
    reader = Reader(tmp_path)
    found = [complaint(reader.follow(block), lines) for block, lines in steps_of(blocks_of(page))][-1]
    assert found is None if words is None else words in found
