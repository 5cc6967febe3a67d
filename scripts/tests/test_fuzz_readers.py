# SPDX-License-Identifier: Apache-2.0
"""Any bytes and any damaged file: each reader of the flow gives a result that the code behind it can use, or FlowError
with one sentence, never another exception. Env STEREO_FUZZ_EXAMPLES: how many files for each reader."""

import copy
import json
import os
import tempfile
from pathlib import Path

import pytest

from conftest import SEED
from flow.base import committed
from flow.base.errors import FlowError
from flow.cosim import checker, record as cosim_record, vectors
from flow.implementation import record as implementation
from flow.pages import demo_folder, performance, report
from flow.shell import verilated
from flow.synthesis import manifest

hypothesis = pytest.importorskip("hypothesis", reason="SKIP: python3-hypothesis is not installed")
from hypothesis import strategies as st  # noqa: E402

EXAMPLES = int(os.environ.get("STEREO_FUZZ_EXAMPLES", "50"))
LONGEST = 3000  # bytes of a damaged file that are looked at

STIMULUS = b"stereo-hls stimulus 2 config=tiny pixels=1 clocks=3\n3 01 ff\n0 00 00\n1 a0 0b\n"
EXPECTED = (
    b"stereo-hls expected 2 config=tiny pixels=2 disparity_bits=16 outputs=2 latency=10\n"
    b"50 0 0 0 000f0003 5\n51 1 0 0 001f0000 0\n"
)
OBSERVED = b"50 3 1\n51 X X\n52 1f 4\nend 60\n"
OBSERVATION = b"r\no 03 1 17\nr\np a promise\no ff 2 90\nend 120\n"
MATCH = {
    "format": demo_folder.MATCH_FORMAT,
    "config": "tiny",
    "engine": "fast",
    "left": "left.png",
    "right": "right.png",
    "fit": "none",
    "width_px": 32,
    "height_px": 12,
    "disparities": 8,
    "window_px": 3,
    "output_width_px": 24,
    "output_height_px": 12,
    "output_first_column": 0,
    "disparity_steps_per_px": 1,
    "min_disparity": 0,
    "reference": "right",
    "milliseconds": 0.25,
    "truth": {
        "disparity": "disparity.png",
        "visible": "visible.png",
        "tolerance_px": 1,
        "compared_px": 200,
        "bad_px": 3,
    },
}
COSIM = {
    "config": "tiny",
    "command": "scripts/cosim.py",
    "simulator": "ghdl",
    "rows": "0:8",
    "stall_percent": 0,
    "seed": 1,
    "passed": True,
    "expected": 288,
    "compared": 288,
    "mismatches": 0,
    "first_mismatch": None,
    "frames": 1,
    "clocks": 500,
    "clocks_per_frame": 384,
    "initiation_interval": {"min": 1, "avg": 1.0, "max": 1},
    "latency_clocks": 15,
    "clocks_per_second": 1e4,
    "build_seconds": 1.5,
    "simulation_seconds": 0.25,
}
COSIM_RECORD = {
    "format": cosim_record.FORMAT,
    "configuration": "tiny",
    "design": {"structure": "00"},
    "runs": {
        "ghdl": {
            "command": "scripts/cosim.py",
            "passed": True,
            "expected": 288,
            "compared": 288,
            "mismatches": 0,
            "frames": 1,
            "clocks": 500,
        }
    },
}
PNG = b"\x89PNG\r\n\x1a\n"


# Each takes a folder with the file as `name` and does what the commands do with it.


def use_expected(folder, name):
    expected, _ = vectors.read_expected(folder / name)
    verdict = checker.compare(expected, [], 8)
    assert verdict.mismatches == len(expected)
    str(verdict.first_mismatch)


def use_observed(folder, name):
    observed, clocks = vectors.read_observed(folder / name)
    assert clocks >= 0 and checker.compare([], observed, 8).mismatches == len(observed)


def use_observation(folder, name):
    assert verilated.read_observation(folder / name).clocks >= 0


def use_manifest(folder, _):
    entry = manifest.read(folder)
    assert set(manifest.KEYS) <= set(entry)
    manifest.vhdl_files(folder)
    implementation.is_fresh({"design": {}}, entry)


def use_implementation(folder, _):
    result = implementation.read(folder)
    assert result is not None
    assert not implementation.is_fresh(result, {"cells": {}, "structure": ""})


def use_cosim_record(folder, _):
    runs = cosim_record.read(folder, {"cells": {}, **COSIM_RECORD["design"]})
    assert all(performance.compared(run).endswith(" differ") for run in runs.values())


def use_demo(folder, name):
    """A demo folder of which one file is the one under test."""
    for path, content in (
        ("match/match.json", MATCH),
        ("cosim-ghdl/report.json", COSIM),
        ("cosim-verilator/report.json", COSIM),
    ):
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(json.dumps(content))
    (folder / demo_folder.MAP).write_bytes(PNG)
    (folder / name).replace(folder / TARGETS[name])
    demo = demo_folder.read_demo(folder)
    assert report.summary(demo).startswith(("PASS", "FAIL"))


TARGETS = {"match.json": "match/match.json", "cosim.json": "cosim-verilator/report.json"}


def committed_text(name):
    """A file of the committed VHDL of tiny, short enough to be damaged everywhere."""
    content = json.loads((committed.folder("tiny") / name).read_text())
    if "sources" in content:
        content["sources"] = dict(list(content["sources"].items())[:2])
    return content


TEXTS = [
    ("stimulus.txt", STIMULUS, lambda folder, name: vectors.read_stimulus(folder / name)),
    ("expected.txt", EXPECTED, use_expected),
    ("observed.txt", OBSERVED, use_observed),
    ("observation.txt", OBSERVATION, use_observation),
]
OBJECTS = [
    ("manifest.json", committed_text("manifest.json"), use_manifest),
    ("implementation.json", committed_text("implementation.json"), use_implementation),
    ("cosimulation.json", COSIM_RECORD, use_cosim_record),
    ("match.json", MATCH, use_demo),
    ("cosim.json", COSIM, use_demo),
]
ALL = [*TEXTS, *((name, json.dumps(content).encode(), use) for name, content, use in OBJECTS)]
by_name = pytest.mark.parametrize("name,valid,use", ALL, ids=[entry[0] for entry in ALL])


def refusal(name, content, use):
    """None when the bytes were taken, else the sentence."""
    with tempfile.TemporaryDirectory(prefix="stereo-fuzz-") as folder:
        folder = Path(folder)
        for path in committed.folder("tiny").glob("*.vhd"):
            (folder / path.name).symlink_to(path)
        (folder / name).write_bytes(content)
        try:
            use(folder, name)
        except FlowError as error:
            assert len(str(error).splitlines()) == 1, f"no sentence: {str(error)!r}"
            assert error.exit_code in (2, 4)
            return str(error)
    return None


# --- what is fed ------------------------------------------------------------------------------------------------------

TOKENS = [
    b"0",
    b"-1",
    b"1e999",
    b"NaN",
    b"4",
    b"9" * 5000,
    b"999999999999",
    b"null",
    b"\n",
    b"\r",
    b"\x00",
    b"\xff",
    b" ",
    b"=",
    b"\xc2\xb2",
    b'"',
    b"{",
    b"[",
]


def damaged(valid):
    """Bytes of a valid file with some of them cut out, put in or doubled."""
    place = st.integers(0, len(valid))
    edit = st.tuples(
        place, st.integers(0, 40), st.one_of(st.binary(max_size=8), st.sampled_from(TOKENS), st.just(None))
    )

    def apply(edits):
        data = valid
        for start, length, new in edits:
            gone = data[start : start + length]
            data = data[:start] + (2 * gone if new is None else new) + data[start + length :]
        return data

    return st.one_of(st.binary(max_size=LONGEST), st.lists(edit, min_size=1, max_size=4).map(apply))


VALUES = st.recursive(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(),
        st.floats(),
        st.text(max_size=8),
        st.sampled_from(["", "a\nb", "/", "../..", "tiny_p2", "x" * 5000, "\ud800", "\x00", 10**400, -1, 0, 1e308]),
    ),
    lambda inner: st.one_of(st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=5), inner, max_size=3)),
    max_leaves=5,
)


def paths(content):
    """Every place in an object, as its keys."""
    found = [()]
    if isinstance(content, dict):
        found += [(key, *rest) for key, value in content.items() for rest in paths(value)]
    return found


def altered(content):
    """The object with some places put to other values or gone."""
    change = st.tuples(st.sampled_from(paths(content)), st.sampled_from(["set", "remove", "add"]), VALUES)

    def apply(changes):
        box = {"root": copy.deepcopy(content)}
        for path, kind, value in changes:
            place, last = box, "root"
            for key in path:
                if not isinstance(place[last], dict) or key not in place[last]:
                    break
                place, last = place[last], key
            if kind == "add" and isinstance(place[last], dict):
                place[last]["a\nb"] = value
            elif kind == "remove" and place is not box:
                del place[last]
            else:
                place[last] = value
        return json.dumps(box["root"]).encode()

    return st.lists(change, min_size=1, max_size=3).map(apply)


def run_fuzz(strategy, name, use):
    @hypothesis.seed(SEED)
    @hypothesis.settings(
        max_examples=EXAMPLES, deadline=None, database=None, suppress_health_check=list(hypothesis.HealthCheck)
    )
    @hypothesis.given(strategy)
    def fuzz(content):
        refusal(name, content, use)

    print(f"STEREO_TEST_SEED={SEED} STEREO_FUZZ_EXAMPLES={EXAMPLES}")
    fuzz()


# --- tests ------------------------------------------------------------------------------------------------------------


@by_name
def test_the_undamaged_file_is_taken_and_no_file_at_all_refused(name, valid, use):
    assert refusal(name, valid, use) is None
    assert refusal(name, b"", use)


@by_name
def test_damaged_bytes(name, valid, use):
    run_fuzz(damaged(valid), name, use)


@pytest.mark.parametrize("name,content,use", OBJECTS, ids=[entry[0] for entry in OBJECTS])
def test_damaged_objects(name, content, use):
    run_fuzz(altered(content), name, use)
