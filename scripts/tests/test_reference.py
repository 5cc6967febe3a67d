# SPDX-License-Identifier: Apache-2.0
"""docs/options.md and docs/configurations.md have every option and every configuration as they are declared."""

import re

import pytest

from flow.base import committed, files
from flow.base.configurations import configuration, designs, options
from flow.base.errors import FlowError
from flow.pages import reference
from flow.synthesis import manifest
from flow_commands import call


def rows(page):
    """{what the first column names: the others}"""
    lines = [line.strip("| ").split(" | ") for line in page.read_text().splitlines() if line.startswith("| `")]
    return {first.strip("`"): rest for first, *rest in lines}


def test_the_committed_pages_are_up_to_date():
    process = call("reference.py", "--check")
    assert process.returncode == 0, process.stderr


def test_every_option_stands_there():
    assert rows(reference.OPTIONS).keys() == {name for family in options().values() for name in family}


def test_every_configuration_stands_there():
    found = rows(reference.CONFIGURATIONS)
    assert found.keys() == designs().keys()
    use, what, *_, latency, memory, registers = found["tiny_median"]
    tools = manifest.read(committed.folder("tiny_median"))["tool_report"]
    assert use == "option" and what == configuration("tiny_median")["description"]
    expected = [configuration("tiny_median")["latency_clocks"], tools["memory_bits"], tools["register_bits"]]
    assert [int(number.replace(",", "")) for number in (latency, memory, registers.strip(" |"))] == expected


def test_what_an_option_costs_is_what_two_configurations_differ_in():
    table = designs()
    made = {name: manifest.read(committed.folder(name)) for name in ("tiny", "tiny_median", "tiny_all")}
    (found,) = reference.costs("block_matching", table, made)
    before, after = (made[name]["tool_report"] for name in ("tiny", "tiny_median"))
    clocks = table["tiny_median"]["latency_clocks"] - table["tiny"]["latency_clocks"]
    bits = [after[name] - before[name] for name in ("memory_bits", "register_bits")]
    assert clocks > 0 and found == ("median", reference.Cost("tiny_median", "tiny", clocks, *bits))


def test_an_example_stands_with_its_family():
    """Where the limits or the defaults of an option are not the same in all families, it has several lines."""
    examples = 0
    for line in reference.OPTIONS.read_text().splitlines():
        *_, families, example = line.strip("|").split("|") if line.startswith("|") else ("", "")
        if shown := re.search(r"\(`(\w+)` beside `(\w+)`\)", example):
            examples += 1
            for name in shown.groups():
                assert families.strip() == "all" or configuration(name)["family"] in families.strip().split(", ")
    assert examples > 10


def test_another_page_is_noticed(tmp_path, monkeypatch):
    page = tmp_path / "options.md"
    page.write_text(reference.OPTIONS.read_text().replace("1 ... 4096", "1 ... 4095"))
    texts = {page: reference.pages()[reference.OPTIONS]}
    with pytest.raises(FlowError, match="not up to date"):
        files.update(texts, True, "scripts/reference.py")
