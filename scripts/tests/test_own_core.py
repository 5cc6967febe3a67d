# SPDX-License-Identifier: Apache-2.0
"""examples/own_core: a project that uses an installed stereo_hls has a configuration of its own, and its clocked core
gives the map of the fast model. From the folder of its rows, a clone makes VHDL."""

import re
import struct
import subprocess
import tempfile
from pathlib import Path

import pytest

from conftest import need
from flow.base.python_module import of_native_build
from flow.base.tools import ROOT, find_stereo_hls, run
from flow_commands import call, random_pair, refused

EXAMPLE = ROOT / "examples" / "own_core"
WIDTH, HEIGHT, DISPARITIES = 96, 48, 24
SIZE = {"width_px": WIDTH, "height_px": HEIGHT}


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prefix") / "usr"
    run(["cmake", "--install", Path(find_stereo_hls()).parent, "--prefix", folder])
    return folder


@pytest.fixture(scope="module")
def program(prefix, tmp_path_factory):
    folder = tmp_path_factory.mktemp("own_core")
    run(["cmake", "-S", EXAMPLE, "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}"])
    run(["cmake", "--build", folder])
    return folder / "own_core"


@pytest.fixture
def pair(tmp_path, monkeypatch):
    """Few grey levels, so that many disparities are equally good."""
    monkeypatch.setattr("flow_commands.configuration", lambda name, table: SIZE)
    monkeypatch.setattr("flow_commands.designs", dict)
    return random_pair(tmp_path / "pair", "own_96", levels=5)


def pgm(path):
    head, columns, rows, pixels = re.match(rb"(P5) (\d+) (\d+) 255\n(.*)", path.read_bytes(), re.DOTALL).groups()
    assert len(pixels) == int(columns) * int(rows) and head == b"P5"
    return [list(pixels[y * int(columns) : (y + 1) * int(columns)]) for y in range(int(rows))]


def pfm(path):
    scale, pixels = re.match(rb"Pf\s\d+\s\d+\s(\S+)\s(.*)", path.read_bytes(), re.DOTALL).groups()
    assert float(scale) < 0, "little endian"
    values = struct.unpack(f"<{WIDTH * HEIGHT}f", pixels)
    return [list(values[y * WIDTH : (y + 1) * WIDTH]) for y in reversed(range(HEIGHT))]


def test_its_map_is_that_of_the_fast_model(prefix, program, pair, tmp_path):
    run([program, *pair, tmp_path / "map.pgm"])
    options = [f"--set={option}" for option in (f"disparities={DISPARITIES}", "window_px=5", "cost=census")]
    images = ["--left", pair[0], "--right", pair[1]]
    run(
        [
            prefix / "bin" / "stereo_hls",
            "match",
            "--config",
            "tiny",
            *options,
            *images,
            "--write=pfm",
            "--out",
            tmp_path,
        ]
    )
    own, fast = pgm(tmp_path / "map.pgm"), pfm(tmp_path / "disparity.pfm")
    assert len(own[0]) == WIDTH - DISPARITIES and len({value for row in own for value in row}) == DISPARITIES
    assert own == [row[: WIDTH - DISPARITIES] for row in fast]


def test_wrong_images_are_refused(program, pair, tmp_path):
    """One sentence, exit code 2, no map."""
    short = tmp_path / "short.pgm"
    short.write_bytes(pair[0].read_bytes()[:-1])
    other = tmp_path / "other.pgm"
    other.write_bytes(b"P5 2 2 255\n1234")
    for left, words in ((short, "is truncated"), (other, "96x48"), (tmp_path / "none.pgm", "96x48")):
        process = subprocess.run([program, left, pair[1], tmp_path / "map.pgm"], capture_output=True, text=True)
        assert process.returncode == 2 and words in process.stderr and len(process.stderr.splitlines()) == 1
    assert not (tmp_path / "map.pgm").exists()


def test_the_page_has_the_options_of_the_row():
    row = re.search(r"STEREO_ROW\(own_96, (.*?)\);", (EXAMPLE / "rows" / "block_matching.hpp").read_text(), re.DOTALL)[
        1
    ]
    page = (EXAMPLE / "README.md").read_text()
    for option, value in re.findall(r"(?<!\w)(disparities|window_px|cost) = (?:Cost::)?(\w+)", row):
        assert f"--set {option}={value}" in page


def configure(rows, build):
    as_native = [f"-D{name}={value}" for name, value in of_native_build().items()]
    command = ["cmake", "--preset", "release", "-B", build, "-Wno-dev", f"-DSTEREO_OWN_ROWS={rows}", *as_native]
    return subprocess.run(list(map(str, command)), cwd=ROOT, capture_output=True, text=True)


ROWS = (EXAMPLE / "rows" / "block_matching.hpp").read_text()
REFUSED = {  # {file: (its text, words)}
    "block_matching.hpp": (ROWS.replace("own_96, own,", "own_96, system,"), "own_96: the use of a row of your own"),
    "semi_global.hpp": (ROWS.replace("own_96,", "tiny,"), "tiny: another configuration has this name"),
    "stereo.hpp": (ROWS, "no family stereo"),
    "rows.txt": (ROWS, "has no FAMILY.hpp"),
}


@pytest.fixture
def build():
    """A build folder inside the clone."""
    with tempfile.TemporaryDirectory(dir=ROOT / "build", prefix="own_rows_") as folder:
        yield Path(folder)


@pytest.mark.slow
@pytest.mark.parametrize("file", REFUSED)
def test_rows_that_cannot_be_taken_are_refused(build, tmp_path, file):
    text, words = REFUSED[file]
    (tmp_path / file).write_text(text)
    process = configure(tmp_path, build)
    assert process.returncode == 1 and words in " ".join(process.stderr.split()), process.stderr


@pytest.mark.slow
def test_a_build_folder_elsewhere_is_refused(tmp_path):
    process = configure(EXAMPLE / "rows", tmp_path / "build")
    assert process.returncode == 1 and "must stand in the project's folder" in " ".join(process.stderr.split())


@pytest.mark.slow
def test_vhdl_of_ones_own_rows(ghdl, build, tmp_path):
    rows = tmp_path / "rows"
    rows.mkdir()
    table = rows / "block_matching.hpp"
    table.write_text(ROWS)
    assert configure(rows, build).returncode == 0
    run(["cmake", "--build", build, "--target", "stereo_hls", "core_own_96", "core_tiny"])
    own = {"STEREO_HLS": str(build / "stereo_hls")}
    refused(call("cosim.py", "--config", "own_96", environment=own), 2, "no generated VHDL for 'own_96'")
    assert call("cosim.py", "--config", "tiny", "--out", tmp_path / "tiny", environment=own).returncode == 0
    reference = call("reference.py", "--check", environment=own)
    assert reference.returncode == 0, "the pages know the named configurations only: " + reference.stderr

    need("bambu", "BAMBU")
    made = call("synthesize.py", "--config", "own_96", environment=own)
    assert made.returncode == 0, made.stderr
    kept = rows / "rtl" / "block_matching" / "own_96"
    names = {"manifest.json", "stereo_core_own_96.vhd", "stereo_ip_own_96.vhd"}
    assert {path.name for path in kept.iterdir()} == names
    compared = call("cosim.py", "--config", "own_96", "--out", tmp_path / "cosim", environment=own)
    assert compared.returncode == 0 and "0 mismatches" in compared.stdout
    tried = call("try_tools.py", "--config", "own_96", "--out", tmp_path / "tools", environment=own)
    assert tried.returncode == 0 and tried.stdout.count(": 3 of 3 designs\n") == 3, tried.stderr
    kit = call("instantiate.py", "--config", "own_96", "--kit", "vivado", "--out", tmp_path / "kit", environment=own)
    assert kit.returncode == 0 and (tmp_path / "kit" / "rtl" / "stereo_ip_own_96.vhd").is_file()
    checked = call("synthesize.py", "--config", "own_96", "--check", environment=own)
    assert checked.returncode == 0 and checked.stdout == "own_96: up to date\n"
    table.write_text(ROWS.replace("slice_disparities = 12", "slice_disparities = 8"))
    refused(call("synthesize.py", "--config", "own_96", "--check", environment=own), 1, "build it again")
    run(["cmake", "--build", build, "--target", "stereo_hls"])
    refused(call("synthesize.py", "--config", "own_96", "--check", environment=own), 1, "stale", "own_96")
