# SPDX-License-Identifier: Apache-2.0
"""The pages as a static site. Sphinx reads a copy of them in which every linked file stands where the link says."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path

from ..base import places, venv
from ..base.tools import ROOT, Say, run
from . import links

REQUIREMENTS = ROOT / "scripts" / "requirements-site.txt"
CONFIGURATION = """\
project = "stereo_hls"
html_title = "stereo_hls {version}"
extensions = ["myst_parser"]
root_doc = "index"
html_theme = "furo"
html_show_copyright = False
html_copy_source = False
highlight_language = "none"
myst_heading_anchors = 4
"""
CONTENTS = "CONTENTS.md"  # in place of a folder


def groups(front: str) -> Iterator[tuple[str, list[str]]]:
    """(heading, pages that are linked below it) of the front page."""
    for part in re.split(r"^## ", front, flags=re.MULTILINE)[1:]:
        named = (target.partition("#")[0] for target in links.targets(part))
        yield part.splitlines()[0], [name for name in named if name.endswith(".md")]


def tables_of_contents(root: Path) -> str:
    """Of the front page's groups, for the page in the root."""
    folder, text = Path(links.FRONT).parent, f"\n```{{toctree}}\n:hidden:\n{links.FRONT.removesuffix('.md')}\n```\n"
    for heading, pages in groups((root / links.FRONT).read_text()):
        names = [os.path.normpath(folder / page).removesuffix(".md") for page in pages]
        text += "\n".join(["", "```{toctree}", ":hidden:", f":caption: {heading}", *names, "```", ""])
    return text


def stage(out: Path, root: Path, version: str) -> None:
    """Copies the pages and what they link to. README.md becomes index.md."""
    places.emptied_folder(out)
    pages = {page.resolve() for page in links.pages(root)}
    for page in sorted(pages):
        text = page.read_text()
        for target in set(links.targets(text)):
            file = (page.parent / target.partition("#")[0]).resolve()
            if re.match(r"#|[a-z]+:", target):
                continue
            if file == (root / "README.md").resolve():
                text = text.replace(f"]({target})", f"]({target.replace('README.md', 'index.md')})")
            elif file in pages:
                continue
            elif file.is_dir():
                text = text.replace(f"]({target})", f"]({target.rstrip('/')}/{CONTENTS})")
                _copy_folder(file, out / file.relative_to(root))
            elif file.is_file():
                _copy(file, out / file.relative_to(root))
        name = page.relative_to(root)
        if name == Path("README.md"):
            name, text = Path("index.md"), text + tables_of_contents(root)
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        (out / name).write_text(text)
    (out / "conf.py").write_text(CONFIGURATION.format(version=version))


def _copy(file: Path, to: Path) -> None:
    to.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(file, to)


def _copy_folder(folder: Path, to: Path) -> None:
    """Its files, and a page that lists them."""
    files = sorted(file for file in folder.iterdir() if file.is_file() and file.suffix != ".md")
    for file in files:
        _copy(file, to / file.name)
    lines = ["---", "orphan: true", "---", f"# {folder.name}", "", *(f"- [{file.name}]({file.name})" for file in files)]
    (to / CONTENTS).write_text("\n".join([*lines, ""]))


def build(out: Path, version: str, root: Path = ROOT, say: Say = print) -> Path:
    """Makes the site below `out`; any warning is an error. Returns its first page."""
    source, html = out / "source", out / "html"
    stage(source, root, version)
    places.emptied_folder(html)
    programs = venv.ensure("venv-site", REQUIREMENTS, "the site generator (Sphinx)", say)
    run(
        [programs / "sphinx-build", "-q", "-W", "--keep-going", "-b", "html", "-d", out / "doctrees", source, html],
        log=out / "site.log",
    )
    return html / "index.html"
