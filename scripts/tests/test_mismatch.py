# SPDX-License-Identifier: Apache-2.0
"""A failed co-simulation shows where: both maps, the first pixel that differs, and the signals around that clock."""

import io
import re
import shutil
import subprocess

import pytest

from browser import look
from conftest import need
from cover import with_slow
from flow.base import committed
from flow.base.configurations import configuration
from flow.base.tools import find_stereo_hls
from flow.cosim import frame_maps, job, mismatch, registers, waveform
from flow.cosim.vcd import Values, cut
from flow.rendering import pictures
from flow.synthesis.lowering.naming import read_trace
from flow.synthesis.presentation.present import expand
from flow_commands import altered_rtl, call, complaints, cosim, random_pair, report

pytest.importorskip("matplotlib", reason="SKIP: python3-matplotlib is not installed")
from test_report import fill

numpy, Image = pictures.libraries()
WINNER = (r"(slice2_best_index_0_0 <= )slice1_best_index_0_0;", r"\g<1>slice1_best_index_0_0 / 2;")
LANE = (
    "leftright_checked_disparity_1 <= leftright_answered_disparity_1",
    "leftright_checked_disparity_1 <= leftright_answered_disparity_0",
)


def failed(folder, config, fault, *options, with_arrays=False):
    """(process, folder of the co-simulation) with a fault in a copy of the VHDL."""
    pair = random_pair(folder / "pair", config, levels=4)
    rtl = altered_rtl(folder / "rtl", config, *fault, with_arrays=with_arrays)
    process = cosim(config, pair, folder / "out", "--rtl", rtl, *options)
    assert process.returncode == 1, process.stdout + process.stderr
    return process, folder / "out"


@pytest.fixture(scope="module")
def tiny(tmp_path_factory):
    need("ghdl", "GHDL")
    return failed(tmp_path_factory.mktemp("tiny"), "tiny", WINNER, "--frames", 2)


def first(out):
    """(clock, frame, x, y, expected, got) of the sentence in report.json."""
    words = re.fullmatch(
        r"clock (\d+), frame (\d+), x (\d+), y (\d+): expected disparity (\d+) .* got disparity (\d+) .*",
        report(out)["first_mismatch"],
    )
    return tuple(map(int, words.groups()))


@pytest.mark.parametrize("simulator", with_slow(["ghdl", "verilator"], ["ghdl"]))
def test_elements_of_arrays_are_shown_as_registers(tmp_path, simulator):
    """A fault in the VHDL as it is committed: the names are those of the C++."""
    need(simulator, simulator.upper())
    fault = (r"(slice0shift_search\(i, 0\)) <= slice0shift_search\(i, 1\)", r"\1 <= 0")
    options = ("--simulator", simulator)
    process, out = failed(tmp_path, "tiny", fault, *options, with_arrays=True)
    assert re.search(r"first register that differs: slice0shift_search_\d_\d, clock \d+: ", process.stdout)
    assert re.search(r"\$var \w+ \d+ \S+ slice0shift_search_0_1\[31:0\] ", (out / "failure.vcd").read_text())


def map_of(out, name, frame):
    """{(x, y): disparity} of one frame straight from the vector files, for configurations of one row a clock."""
    wanted = [line.split() for line in (out / "expected.txt").read_text().splitlines()[1:]]
    words = (
        [w[4] for w in wanted]
        if name == "expected"
        else [line.split()[1] for line in (out / "observed.txt").read_text().splitlines()[:-1]]
    )
    return {(int(w[1]), int(w[2])): int(word, 16) for w, word in zip(wanted, words) if int(w[3]) == frame}


def test_stdout_says_where_to_look(tiny):
    process, out = tiny
    assert f"both maps, the first pixel that differs and its signals: {out / 'failure.html'}" in process.stdout
    assert f"gtkwave {out / 'failure.vcd'} {out / 'failure.gtkw'}" in process.stdout
    text = (out / "failure.html").read_text()
    assert report(out)["first_mismatch"] in text and "VHDL and C++ differ" in text
    assert report(out)["command"] in text.replace("&#39;", "'")


def test_maps_are_those_of_the_vector_files(tiny):
    _, out = tiny
    clock, frame, x, y, expected, got = first(out)
    failure = mismatch.read(out, configuration("tiny"))
    want, have = map_of(out, "expected", frame), map_of(out, "observed", frame)
    assert (want[x, y], have[x, y]) == (expected, got) and expected != got
    assert [picture.title for picture in failure.pictures] == ["Expected", "Got", "Difference"]
    shown = [numpy.asarray(Image.open(io.BytesIO(picture.png))) for picture in failure.pictures]
    for picture, values in zip(shown, (want, have)):
        for (column, row), value in values.items():
            assert (picture[row, column] == pictures.disparity_colors(value, 0, 7)).all()
    wrong = {place for place in want if want[place] != have[place]}
    red = pictures.rgb(frame_maps.DIFFERS)
    assert {(column, row) for column, row in want if tuple(shown[2][row, column]) == red} == wrong
    assert min(wrong, key=lambda place: place[::-1]) == (x, y)
    assert {picture.mark for picture in failure.pictures} == {(100 * (x + 0.5) / 24, 100 * (y + 0.5) / 12)}


def test_the_pixel_stands_in_the_table(tiny):
    _, out = tiny
    _, _, x, y, expected, got = first(out)
    table = mismatch.read(out, configuration("tiny")).around
    marked = [
        (row["y"], column, cell)
        for row in table["rows"]
        for column, cell in zip(table["columns"], row["cells"])
        if cell["first"]
    ]
    assert marked == [(y, x, {"expected": str(expected), "got": str(got), "wrong": True, "first": True})]


def test_wave_shows_the_wrong_value_in_that_clock(tiny):
    _, out = tiny
    clock, *_, got = first(out)
    assert waveform.output(out / "failure.vcd", clock) == (1, got)
    observed = {
        int(line.split()[0]): int(line.split()[1], 16) for line in (out / "observed.txt").read_text().splitlines()[:-1]
    }
    begin, end = report(out)["wave_clocks"]
    assert begin <= clock <= end <= begin + 80
    for number in range(begin, end + 1):
        valid, disparity = waveform.output(out / "failure.vcd", number)
        assert valid == (number in observed) and (not valid or disparity == observed[number])


def test_stimulus_stands_in_the_wave(tiny):
    _, out = tiny
    values, lines = Values(out / "failure.vcd"), (out / "stimulus.txt").read_text().splitlines()[1:]
    begin, end = report(out)["wave_clocks"]
    for number in range(begin, end + 1):
        flags, left, right = (int(word, 16) for word in lines[number].split())
        at = {
            name: values.at(waveform.CORE + name, waveform.start_ns(number))
            for name in ("valid", "start_of_frame", "left_pixel", "right_pixel")
        }
        assert at == {"valid": flags & 1, "start_of_frame": flags >> 1, "left_pixel": left, "right_pixel": right}


def test_the_value_in_cpp_stands_beside_the_vhdls(tiny):
    """On the page, in the waveform and in the save file; they are those of `stereo_hls trace`, which has no fault."""
    _, out = tiny
    name, wave = "slice2_best_index_0_0", mismatch.read(out, configuration("tiny")).wave
    assert report(out)["first_registers"] == [name]
    assert wave.groups[0]["title"] == waveform.DIFFER and wave.groups[0]["signals"][0][0] == name
    values = Values(out / "failure.vcd")
    shown = dict(wave.groups[0]["signals"])[name]
    for clock, vhdl, cpp in zip(wave.clocks, shown, wave.cpp[name]):
        there = values.at(f"cpp.{name}", waveform.start_ns(clock))
        assert vhdl == str(values.at(waveform.CORE + name, waveform.start_ns(clock)))
        assert cpp == (str(there) if str(there) != vhdl else None)
    begin, end = report(out)["wave_clocks"]
    trace = tmp_trace(out, begin, end)
    for other in (name, "raster_place_column", "slice0window_sum_0_1"):
        seen = [values.at(f"cpp.{other}", waveform.start_ns(clock)) for clock in range(begin, end)]
        assert seen == list(trace[other][: end - begin]) and len(set(seen)) > 1
    assert '<b class="fail" title="in C++">' in (out / "failure.html").read_text()
    assert f"\ntb_stereo_core.dut.{name}[31:0]\ncpp.{name}[31:0]\n" in (out / "failure.gtkw").read_text()


def tmp_trace(out, begin, end):
    words = ["trace", "--config", "tiny", "--left", out.parent / "pair" / "left.pgm", "--frames", "2"]
    words += ["--right", out.parent / "pair" / "right.pgm", "--out", out / "t", "--first-clock", begin]
    subprocess.run([find_stereo_hls(), *map(str, words), "--clocks", str(end - begin)], check=True, capture_output=True)
    return read_trace(out / "t" / "trace.txt")


def test_registers_that_the_vhdl_resets():
    text = expand((committed.folder("tiny") / "stereo_core_tiny.vhd").read_text())
    assert {"raster_place_group", "slice2_best_tag_valid"} <= registers.reset_in(text)
    assert "slice2_best_index_0_0" not in registers.reset_in(text) and registers.reset_in("") == set()


def test_save_file_names_signals_of_the_dump(tiny):
    """As GTKWave knows them: with the range of a vector, in groups, and the marker where the clock begins."""
    _, out = tiny
    lines, dump = (out / "failure.gtkw").read_text().splitlines(), (out / "failure.vcd").read_text()
    names = [line.removeprefix("tb_stereo_core.dut.") for line in lines if line.startswith("tb_stereo_core.dut.")]
    inside = dump.partition("$scope module dut $end")[2]
    for name in names:
        assert re.search(rf"\$var reg \d+ \S+ {re.escape(name)} \$end", inside), name
    for name in [line.removeprefix("cpp.") for line in lines if line.startswith("cpp.")]:
        assert re.search(rf"\$var reg \d+ \S+ {re.escape(name)} \$end", dump.partition("$scope module cpp $end")[2])
    groups = [line for line in lines if line.startswith("-")]
    assert groups == [group for group in groups[::2] for _ in range(2)], "each group is opened and closed"
    assert groups[0] == "-registers that differ first, VHDL above C++"
    assert groups[::2][1:3] == ["-inputs", "-outputs"] and any(group.startswith("-winner's path") for group in groups)
    assert {"left_pixel[7:0]", "disparity[7:0]", "slice2_best_index_0_0[31:0]", "slice1_best_cost_0_0[31:0]"} <= set(
        names
    )
    marker = next(line for line in lines if line.startswith("*"))
    assert int(marker.split()[1]) == 20 + 10 * first(out)[0]


def test_page_in_a_browser(tiny, tmp_path):
    need("chromium")
    _, out = tiny
    _, _, x, y, *_ = first(out)
    for width in (1280, 390):
        seen = look(out / "failure.html", tmp_path, width)
        assert seen["scroll_width"] == width and seen["too_wide"] == [] and len(seen["marks"]) == 3
        assert all(image["natural"] for image in seen["images"])


def test_lanes_and_rejected_pixels(ghdl, tmp_path):
    """Two rows a clock: the lower one is wrong, and it is the one that is marked."""
    _, out = failed(tmp_path, "tiny_lr_p2", LANE)
    _, _, x, y, expected, got = first(out)
    assert y % 2 == 1
    failure = mismatch.read(out, configuration("tiny_lr_p2"))
    assert failure.pictures[0].mark[1] == pytest.approx(100 * (y + 0.5) / 12)
    assert pictures.REJECTED in [color for color, _, _ in failure.pictures[0].legend]
    cells = [cell for row in failure.around["rows"] for cell in row["cells"] if cell["first"]]
    assert [cell["expected"].strip("()") for cell in cells] == [str(expected)]
    assert [cell["got"].strip("()") for cell in cells] == [str(got)]


def test_missing_and_unknown_outputs(ghdl, tmp_path):
    _, out = failed(tmp_path / "silent", "tiny", (r"disparity_valid <= .*;", "disparity_valid <= '0';"))
    assert "nothing" in (out / "failure.html").read_text()
    _, out = failed(tmp_path / "unknown", "tiny", (r"disparity_valid <= .*;", "disparity_valid <= 'X';"))
    assert "got disparity X" in (out / "failure.html").read_text()


def test_verilators_mismatch_has_ghdls_wave(ghdl, verilator, tmp_path):
    process, out = failed(tmp_path, "tiny", WINNER, "--simulator", "verilator")
    text = (out / "failure.html").read_text()
    assert "The waveform is GHDL&#39;s" in text and "the two simulators differ" not in text
    assert waveform.output(out / "failure.vcd", first(out)[0]) == (1, first(out)[5])


def test_a_pass_removes_the_page_of_an_earlier_failure(ghdl, tmp_path):
    _, out = failed(tmp_path, "tiny", WINNER)
    assert all((out / name).is_file() for name in mismatch.FILES)
    process = cosim("tiny", (tmp_path / "pair" / "left.pgm", tmp_path / "pair" / "right.pgm"), out)
    assert process.returncode == 0 and not any((out / name).exists() for name in mismatch.FILES)


def test_a_late_mismatch_has_a_page_without_a_wave(ghdl, tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(job, "AUTOMATIC_WAVE_CLOCKS", 10)
    left, right = random_pair(tmp_path / "pair", "tiny", levels=4)
    result = job.run_job(
        job.Job(
            "tiny",
            left=left,
            right=right,
            rtl=altered_rtl(tmp_path / "rtl", "tiny", *WINNER),
            out=tmp_path / "out",
        )
    )
    said = "no waveform of the mismatch: it lies beyond clock 10; --wave FILE makes one"
    assert result["passed"] is False and said in capsys.readouterr().out
    assert (tmp_path / "out" / "failure.html").is_file() and not (tmp_path / "out" / "failure.vcd").exists()


def test_a_surplus_output_has_no_place(ghdl, tmp_path):
    """The last expected output is taken away from a run that agreed."""
    out = tmp_path / "out"
    assert cosim("tiny", random_pair(tmp_path / "pair", "tiny", levels=4), out).returncode == 0
    lines = (out / "expected.txt").read_text().splitlines()
    (out / "expected.txt").write_text("\n".join([lines[0].replace("outputs=288", "outputs=287"), *lines[1:-1]]) + "\n")
    failure = mismatch.read(out, configuration("tiny"))
    assert "surplus output" in failure.sentence and failure.around is None and failure.pictures[0].mark is None
    assert "surplus output" in mismatch.write_page(out, configuration("tiny")).read_text()


def test_without_matplotlib_the_verdict_stays(ghdl, tmp_path):
    (tmp_path / "modules").mkdir()
    (tmp_path / "modules" / "matplotlib.py").write_text("raise ImportError('none', name='matplotlib')")
    design = altered_rtl(tmp_path / "rtl", "tiny", *WINNER)
    pair = random_pair(tmp_path / "pair", "tiny", levels=4)
    process = cosim(
        "tiny", pair, tmp_path / "out", "--rtl", design, environment={"PYTHONPATH": str(tmp_path / "modules")}
    )
    assert process.returncode == 1 and not complaints(process)
    assert "no page of the mismatch: the Python package matplotlib is missing" in process.stdout
    assert not (tmp_path / "out" / "failure.html").exists()


def test_page_of_a_demo_shows_the_failure(tiny, tmp_path):
    """The fragment of the failed co-simulation stands in the demo's page."""
    folder = fill(tmp_path / "demo", "tiny")
    shutil.rmtree(folder / "cosim-ghdl")
    shutil.copytree(tiny[1], folder / "cosim-ghdl")
    assert call("report.py", "--demo", folder).returncode == 1
    text = (folder / "report.html").read_text()
    assert "Where ghdl differs" in text and 'class="mark"' in text and "slice2_best_index_0_0" in text


# --- cutting a dump ---------------------------------------------------------------------------------------------------

DUMP = """$date
  today
$end
$timescale
  1 fs
$end
$scope module textio $end
$upscope $end
$scope module tb $end
$var reg 1 ! clock $end
$var reg 1 " pixel_valid[0:0] $end
$scope module dut $end
$var integer 32 # sum $end
$upscope $end
$upscope $end
$enddefinitions $end
#0
0!
b1 "
b101 #
#5000000
1!
#10000000
0!
b111 #
#15000000
1!
#20000000
0!
#25000000
1!
""".splitlines(keepends=True)


@pytest.fixture
def stretch(tmp_path):
    with open(tmp_path / "cut.vcd", "w", encoding="ascii") as file:
        cut(iter(DUMP), file.write, 10, 20)
    return tmp_path / "cut.vcd"


def test_a_stretch_begins_with_all_values(stretch):
    text, values = stretch.read_text(), Values(stretch)
    assert "textio" not in text and "1 ns" in text
    assert re.findall(r"^#\d+$", text, re.MULTILINE) == ["#10", "#15", "#20"]
    assert values.at("tb.dut.sum", 9) is None
    assert [values.at("tb.clock", time) for time in (10, 15, 20)] == [0, 1, 0]
    assert [values.at("tb.dut.sum", time) for time in (10, 20)] == [7, 7] and values.at("tb.pixel_valid", 10) == 1
    assert values.label("tb.dut.sum") == "tb.dut.sum[31:0]" and values.label("tb.pixel_valid") == "tb.pixel_valid"


def test_a_value_that_is_no_number(tmp_path):
    with open(tmp_path / "cut.vcd", "w", encoding="ascii") as file:
        cut(iter([line.replace("b111 #", "b1U1 #") for line in DUMP]), file.write, 10, 20)
    assert Values(tmp_path / "cut.vcd").at("tb.dut.sum", 12) == "X"


class Dump:
    """As vcd.Values: {register: its values, clock by clock}."""

    def __init__(self, values):
        self._values = {waveform.CORE + name: seen for name, seen in values.items()}
        self.names = list(self._values)

    def at(self, name, time):
        return next(
            (seen for clock, seen in enumerate(self._values.get(name, ())) if waveform.start_ns(clock) == time), None
        )

    def bits(self, name):
        return 8


@pytest.mark.parametrize("reset", [(), ("memory", "sum")])
def test_what_a_memory_gives_before_it_was_written_counts_last(reset):
    trace = {"in_valid": [1] * 6, "memory": [0, 0, 0, 7, 8, 9], "sum": [1, 2, 3, 4, 5, 6]}
    shown = {"memory": [0, "X", "X", 7, 8, 9], "sum": [1, 2, 3, 4, 5, 7]}

    def found(values):
        return registers.Registers(Dump(values), trace, 0, ["memory", "sum"], reset).divergence(0)

    assert str(found(shown)) == "first register that differs: sum, clock 5: 6 in C++, 7 in VHDL"
    same = {**shown, "sum": trace["sum"]}
    assert str(found(same)) == "first register that differs: memory, clock 1: 0 in C++, X in VHDL"
    assert found({**same, "memory": trace["memory"]}) is None
