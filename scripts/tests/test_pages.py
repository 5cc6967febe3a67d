# SPDX-License-Identifier: Apache-2.0
"""README.md and the pages: their links lead somewhere, the front page knows all of them, and commands that they show
are there."""

import functools
import re
import shlex
import subprocess

import pytest

from flow.base.errors import FlowError
from flow.base.tools import ROOT, find_stereo_hls
from flow.pages import links, products, quality

PAGES = links.pages()
LONGEST_README = 100  # lines


def shown_commands(text):
    """The lines of the blocks of shell commands on a page, each with those that continue it."""
    for block in re.findall(r"^ *```sh\n(.*?)^ *```", text, re.MULTILINE | re.DOTALL):
        yield from block.replace("\\\n", " ").splitlines()


def unknown_files(text):
    """Commands of the project that a page shows and that are not there."""
    words = [word for line in shown_commands(text) for word in shlex.split(line, comments=True)]
    named = {word.removeprefix("./") for word in words if re.match(r"(\./)?scripts/[\w.]+$", word)}
    return {name for name in named if not (ROOT / name).is_file()}


@functools.cache
def help_of(program, *command):
    words = [find_stereo_hls(), *command] if program == "stereo_hls" else [ROOT / "scripts" / program]
    process = subprocess.run([*words, "--help"], capture_output=True, text=True)
    assert process.returncode == 0, f"{program} {command}: {process.stderr}"
    return process.stdout


def unknown_options(text):
    """Options that a page shows and that their command does not know."""
    found = set()
    for line in shown_commands(text):
        words = shlex.split(line, comments=True)
        places = [i for i, word in enumerate(words) if re.search(r"(^|/)(stereo_hls|scripts/\w+\.(py|sh))$", word)]
        for place in places[:1]:
            program = words[place].rpartition("/")[2]
            if program == "try_distribution.sh":  # whose last words are commands
                continue
            command = words[place + 1 : place + 2] if program == "stereo_hls" else []
            options = {word.partition("=")[0] for word in words[place + 1 :] if re.match(r"--[a-z]", word)}
            shown = re.findall(r"--[a-z][\w-]*", help_of(program, *command))
            found |= {f"{program} {option}" for option in options - set(shown)}
    return found


def test_pages_are_found():
    assert {"README.md", "CHANGELOG.md", "CONTRIBUTING.md"} <= {page.name for page in PAGES} and len(PAGES) >= 30


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_every_link_leads_somewhere(page):
    assert links.broken(page) == []


@pytest.mark.parametrize(
    "text, words",
    [
        ("[a](no_such.md)", "no_such.md: there is no such file"),
        ("![a picture](images/no_such.svg)", "no such file"),
        ("[a](#nowhere)", "no such heading"),
        ("[a](other.md#nowhere)", "no such heading"),
        ("[`code` [1]](no_such.md)", "no such file"),
    ],
)
def test_a_link_that_leads_nowhere_is_noticed(tmp_path, text, words):
    (tmp_path / "other.md").write_text("# Some where, else\n\n```sh\n# nowhere\n```\n")
    page = tmp_path / "page.md"
    page.write_text(f"# A page\n\n{text}\n")
    (found,) = links.broken(page)
    assert words in found
    page.write_text("[a](other.md#some-where-else) [b](#a-page) [c](https://example.org/x)\n\n# A page\n")
    assert links.broken(page) == []


def test_the_front_page_links_to_every_page():
    assert links.unreachable() == set()


def test_a_page_that_nobody_links_to_is_noticed(tmp_path):
    (tmp_path / "docs").mkdir()
    (tmp_path / "docs" / "README.md").write_text("[a](a.md#part)")
    for name in ("a.md", "b.md"):
        (tmp_path / "docs" / name).write_text("# Page\n")
    assert links.unreachable(tmp_path) == {"b.md"}


def test_readme_is_short():
    lines = (ROOT / "README.md").read_text().splitlines()
    assert len(lines) <= LONGEST_README


def test_every_command_has_a_place_in_the_pages():
    text = "".join(page.read_text() for page in PAGES if page.name != "CHANGELOG.md")
    missing = [script.name for script in sorted((ROOT / "scripts").glob("*.[ps][yh]")) if script.name not in text]
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_commands_that_a_page_shows_are_there(page):
    assert unknown_files(page.read_text()) == set()


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.relative_to(ROOT).as_posix())
def test_options_that_a_page_shows_are_known(page):
    assert unknown_options(page.read_text()) == set()


def test_an_option_that_is_gone_is_noticed():
    lines = ["```sh", "BAMBU=x scripts/cosim.py --config tiny --gone 3 \\", "   --rows=8"]
    text = "\n".join([*lines, "build/release/stereo_hls match --gone2", "```", ""])
    assert unknown_options(text) == {"cosim.py --gone", "stereo_hls --gone2"}


def test_a_command_that_is_gone_is_noticed():
    assert unknown_files("```sh\nVARIABLE=1 scripts/gone.py --now   # it was here\n```\n") == {"scripts/gone.py"}


def test_products_have_the_quality_of_the_page():
    """Each row by its own name, not by its place."""
    text = quality.PAGE.read_text()
    table = {line.split(" | ")[0]: line for line in products.products(text).splitlines()}
    assert len(table) >= 7
    for name, _, measured_as in products.PRODUCTS:
        numbers = re.search(rf"^\| {re.escape(measured_as)} \| (\S+) \| \S+ \| \S+ \| (\S+) \|$", text, re.MULTILINE)
        assert table[f"| `{name}`"].endswith(f"| {numbers[1]} % | {numbers[2]} % |")


def test_a_quality_page_without_the_table_is_refused():
    with pytest.raises(FlowError, match="has no table"):
        products.products(quality.PAGE.read_text().replace("| D1, dense |", "| other |"))
