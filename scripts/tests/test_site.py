# SPDX-License-Identifier: Apache-2.0
"""The static site of the pages: built without a warning, each link leads somewhere, nothing is from other servers."""

import re
from html.parser import HTMLParser
from urllib.parse import unquote

import pytest

from conftest import where_reachable
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.pages import links, site

LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}  # what a browser fetches


class Page(HTMLParser):
    """What a page of the site loads, links to, and can be linked to at."""

    def __init__(self, text):
        super().__init__()
        self.loaded, self.linked, self.ids = [], [], set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if values.get("id"):
            self.ids.add(values["id"])
        if values.get(LOADED.get(tag)):
            self.loaded.append(values[LOADED[tag]])
        if tag == "a" and values.get("href"):
            self.linked.append(values["href"])


def pages_of(folder):
    return {path.resolve(): Page(path.read_text()) for path in folder.rglob("*.html")}


def faults(folder):
    pages, found = pages_of(folder), []
    for path, page in pages.items():
        name = path.relative_to(folder.resolve()).as_posix()
        found += [f"{name} loads {address}" for address in page.loaded if re.match(r"(\w+:)?//", address)]
        local = [address for address in page.loaded + page.linked if not re.match(r"[a-z]+:|//", address)]
        for address in local:
            file, _, anchor = address.partition("#")
            target = (path.parent / unquote(file.partition("?")[0])).resolve() if file else path
            if not target.is_file():
                found.append(f"{name}: {address}: there is no such file")
            elif anchor and target in pages and unquote(anchor) not in pages[target].ids:
                found.append(f"{name}: {address}: there is no such place")
    return found


def small_project(folder, text):
    """A project with one page."""
    for name, content in {
        "README.md": "# Front\n\n[pages](docs/README.md)\n",
        "docs/README.md": "# Pages\n\n## Use\n\n- [a page](page.md)\n",
        "docs/page.md": text,
    }.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(content)
    return folder


@pytest.fixture(scope="module")
def build():
    where_reachable(lambda: site.venv.ensure("venv-site", site.REQUIREMENTS, "the site generator (Sphinx)"))
    return site.build


@pytest.fixture(scope="module")
def built(build, tmp_path_factory):
    return build(tmp_path_factory.mktemp("site"), "1.2.3").parent


def test_each_link_of_the_site_leads_somewhere(built):
    assert faults(built) == []


def test_every_page_is_there(built):
    for page in links.pages():
        name = page.relative_to(ROOT).with_suffix(".html")
        assert (built / ("index.html" if page == ROOT / "README.md" else name)).is_file()
    front = (built / "index.html").read_text()
    for heading, _ in site.groups((ROOT / links.FRONT).read_text()):
        assert f">{heading}<" in front
    assert "stereo_hls 1.2.3" in front


def test_a_folder_of_the_user_is_refused_before_anything_is_installed(tmp_path, monkeypatch):
    monkeypatch.setattr(site.venv, "ensure", lambda *words: pytest.fail("installed first"))
    (tmp_path / "html").mkdir()
    (tmp_path / "html" / "mine").touch()
    with pytest.raises(FlowError, match="name another folder"):
        site.build(tmp_path, "1.2.3")


def test_a_warning_is_an_error(build, tmp_path):
    good = small_project(tmp_path / "good", "# A page\n\n[a header](../README.md)\n")
    assert build(tmp_path / "out", "1", good).is_file()
    bad = small_project(tmp_path / "bad", "# A page\n\n[nowhere](nowhere.md)\n")
    with pytest.raises(FlowError, match="sphinx-build failed"):
        build(tmp_path / "out", "1", bad)


@pytest.mark.parametrize(
    "text, fault",
    [
        ('<a href="gone.html">', "page.html: gone.html: there is no such file"),
        ('<a href="#gone">', "page.html: #gone: there is no such place"),
        ('<script src="https://example.org/x.js">', "page.html loads https://example.org/x.js"),
        ('<link href="//example.org/x.css">', "page.html loads //example.org/x.css"),
    ],
)
def test_a_fault_of_a_site_is_noticed(tmp_path, text, fault):
    page = tmp_path / "page.html"
    page.write_text(text)
    assert faults(tmp_path) == [fault]
    page.write_text('<h1 id="here"><a href="#here"><a href="https://example.org"><a href="page.html">')
    assert faults(tmp_path) == []
