# SPDX-License-Identifier: Apache-2.0
"""The edits of docs/tutorial.md apply to the files as they are, one after the other. test_tutorial.py, which also runs
what the page says, takes many minutes."""

import re
import shutil

import pytest

from conftest import need
from flow.base.tools import ROOT
from test_tutorial import STEPS, Block, Reader, complaint

EDITS = [block for block, _ in STEPS if block.kind == "diff"]


def files_of(block):
    return re.findall(r"^\+\+\+ b/(\S+)$", block.text, re.MULTILINE)


def apply(blocks, folder):
    """What is wrong with the first block that does not apply to a copy of its files, or None."""
    need("git")
    for name in {name for block in blocks for name in files_of(block)}:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(ROOT / name, folder / name)
    reader = Reader(folder)
    for block in blocks:
        before = [(folder / name).read_text() for name in files_of(block)]
        wrong = complaint(reader.follow(block), [])
        after = [(folder / name).read_text() for name in files_of(block)]
        if wrong is None and (not before or any(old == new for old, new in zip(before, after))):
            wrong = "a file is as it was"
        if wrong:
            return f"line {block.line}: {wrong}"
    return None


def test_every_edit_applies(tmp_path):
    assert len(EDITS) >= 6
    assert apply(EDITS, tmp_path) is None


@pytest.mark.parametrize(
    "text, words",
    [
        ("--- a/LICENSE\n+++ b/LICENSE\n@@ -1 +1 @@\n-no such line\n+other\n", "does not apply"),
        ("", "exit code"),
    ],
)
def test_an_edit_that_does_not_apply_is_noticed(tmp_path, text, words):
    found = apply([Block(7, "diff", (), text)], tmp_path)
    assert found.startswith("line 7: ") and words in found
