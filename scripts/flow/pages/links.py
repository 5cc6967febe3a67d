# SPDX-License-Identifier: Apache-2.0
"""The links of the pages: whether each leads to a file, and to a heading of it, and which pages nobody links to."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import unquote

from ..base.tools import ROOT

FRONT = "docs/README.md"
_FENCE = re.compile(r"^ *(```|~~~).*?^ *\1 *$", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]+)\)")


def pages(root: Path = ROOT) -> list[Path]:
    """All pages for readers; the folder docs/ and the pages beside the examples and in the root."""
    found = [*root.glob("*.md"), *(root / "docs").rglob("*.md"), *(root / "examples").rglob("*.md")]
    return sorted(found)


def targets(text: str) -> Iterator[str]:
    """Where the links and pictures of a page lead to."""
    for link in _LINK.finditer(_FENCE.sub("", text)):
        yield link[1]


def anchors(text: str) -> set[str]:
    """The headings of a page as parts of an address, as GitHub and GitLab write them."""
    found: set[str] = set()
    for heading in re.findall(r"^#{1,6} +(.*?) *#*$", _FENCE.sub("", text), re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        name, count = slug, 0
        while name in found:
            count += 1
            name = f"{slug}-{count}"
        found.add(name)
    return found


def broken(page: Path) -> list[str]:
    """A sentence for each link of a page that leads nowhere. Addresses of other servers are not looked at."""
    found = []
    for target in targets(page.read_text()):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, anchor = target.partition("#")
        file = page.parent / unquote(name) if name else page
        if not file.exists():
            found.append(f"{page.name}: {target}: there is no such file")
        elif anchor and (file.suffix != ".md" or anchor not in anchors(file.read_text())):
            found.append(f"{page.name}: {target}: there is no such heading")
    return found


def unreachable(root: Path = ROOT) -> set[str]:
    """Pages of docs/ that its front page does not link to."""
    front = root / FRONT
    linked = {(front.parent / target.partition("#")[0]).resolve() for target in targets(front.read_text())}
    return {page.name for page in (root / "docs").rglob("*.md") if page.resolve() not in {*linked, front.resolve()}}
