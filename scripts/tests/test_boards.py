# SPDX-License-Identifier: Apache-2.0
"""examples/boards: the serial line by itself, the whole board in simulation against the program's map, and the command
that speaks to a board, at a pseudo-terminal with a stand-in for the board. The bit streams: test_example.py."""

import dataclasses
import os
import pty
import shutil
import subprocess
import threading
from pathlib import Path

import pytest

from conftest import ROOT, need
from cover import with_slow
from flow.base.errors import FlowError
from flow.base.ghdl import STANDARD
from flow.boards import compared, line, protocol, record
from flow.boards.boards import BOARDS
from flow.boards.play import NO_STOP_BIT, Played
from flow.shell import board_vhdl
from flow_commands import call, refused, scene

TINY = board_vhdl.sizes("tiny")
WIDTH = TINY["output_width_px"]
PAUSE = -2000  # bits, longer than quiet_ms in the bench
BENCHES = ROOT / "hls_tb" / "boards"


@pytest.fixture(scope="module")
def pair(tmp_path_factory):
    return scene(tmp_path_factory.mktemp("scene"), "tiny")


@pytest.fixture(scope="module")
def grey(pair):
    return [compared.pixels(path, "tiny", TINY) for path in pair]


@pytest.fixture(scope="module")
def expected(grey):
    return compared.of_program("tiny", *grey, TINY)


@pytest.fixture(scope="module")
def board():
    need("ghdl", "GHDL")
    return Played("tiny")


def differences(answer, expected):
    return compared.differences(protocol.read_map(answer, TINY), expected, WIDTH)


def with_fault(folder, file, old, new):
    """The files around the core, one of them changed."""
    paths = [Path(shutil.copy(path, folder)) for path in board_vhdl.BY_HAND]
    path = folder / file
    assert path.read_text().count(old) >= 1
    path.write_text(path.read_text().replace(old, new))
    return paths


# --- the serial line ---


def uart(ghdl, folder, *generics, files=()):
    names = ("uart_receiver.vhd", "uart_transmitter.vhd")
    files = files or [board_vhdl.FOLDER / name for name in names]
    analysed = subprocess.run([ghdl, "-a", STANDARD, *files, BENCHES / "tb_uart.vhd"], cwd=folder, capture_output=True)
    assert analysed.returncode == 0, analysed.stderr
    command = [ghdl, "-r", STANDARD, "tb_uart", *generics]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True)


@pytest.mark.parametrize("permille", [980, 1000, 1020])
@pytest.mark.parametrize("clocks_per_bit", [4, 5, *sorted({b.clock_mhz * 10**6 // b.baud for b in BOARDS.values()})])
def test_uart_takes_all_bytes(ghdl, tmp_path, clocks_per_bit, permille):
    process = uart(ghdl, tmp_path, f"-gclocks_per_bit={clocks_per_bit}", f"-gpermille={permille}")
    assert process.returncode == 0 and "uart passed: 1024 bytes" in process.stdout + process.stderr, process


@pytest.mark.parametrize(
    "file, old, new, word",
    [
        ("uart_receiver", "clocks_per_bit / 2 - 1", "clocks_per_bit - 1", "instead of"),
        ("uart_receiver", "bits_left = 10 and history(1) = '1'", "false", "byte 1024 is"),
        ("uart_receiver", 'history(2 downto 1) = "10"', "history(1) = '0'", "a line at 0"),
        ("uart_transmitter", "'1' & in_data & '0'", "'1' & not in_data & '0'", "byte 0 is"),
    ],
)
def test_uart_bench_notices(ghdl, tmp_path, file, old, new, word):
    """At the fastest clock difference, whose middle of a bit counts most."""
    with_fault(tmp_path, f"{file}.vhd", old, new)
    files = [tmp_path / "uart_receiver.vhd", tmp_path / "uart_transmitter.vhd"]
    process = uart(ghdl, tmp_path, "-gpermille=1020", files=files)
    assert process.returncode != 0 and word in process.stdout + process.stderr, process


# --- the design, in simulation ---


def test_committed_core_follows_from_the_manifest():
    assert (board_vhdl.FOLDER / board_vhdl.CORE_FILE).read_text() == board_vhdl.core_text(board_vhdl.CONFIG)


def test_core_for_a_flow_of_ones_own(tmp_path):
    process = call("build_example.py", "--config", "sgm_320_64_f16", "--core", tmp_path / "core.vhd")
    assert process.returncode == 0, process.stderr
    text = (tmp_path / "core.vhd").read_text()
    assert text == board_vhdl.core_text("sgm_320_64_f16") and "output_width_px : positive := 257" in text


def test_clock_is_a_multiple_of_the_rate():
    for row in BOARDS.values():
        assert row.clock_mhz * 10**6 % row.baud == 0 and line.rate(row.baud) > 0
        text = (board_vhdl.FOLDER / row.constraints).read_text()
        assert all(f"led[{number}]" in text for number in range(row.leds)) and f"led[{row.leds}]" not in text


def test_self_test_shows_the_right_disparities(board):
    board.play([], self_test=True)  # the bench fails where it does not


def test_self_test_notices_wrong_disparities(ghdl, tmp_path):
    files = with_fault(tmp_path, "board_top.vhd", "output_width_px * height_px, shift => shift", "288, shift => 4")
    with pytest.raises(Exception, match="assertion failed"):
        Played("tiny", files=files).play([], self_test=True)


def test_a_pair_becomes_the_map_of_the_program(ghdl, pair, tmp_path):
    words = ["--left", pair[0], "--right", pair[1], "--out", tmp_path / "map.png"]
    process = call("board.py", "--simulate", "--config", "tiny", *words)
    assert process.returncode == 0, process.stderr
    assert "0 of 288 disparities differ" in process.stdout
    assert (tmp_path / "map.png").read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize("permille", [980, 1020])
def test_the_two_clocks_may_differ(board, grey, expected, permille):
    assert differences(board.play(protocol.frame(*grey), permille=permille).sent, expected) == []


def test_frames_one_after_the_other(board, grey, expected):
    frame = protocol.frame(*grey)
    answer = board.play([*frame, PAUSE, *frame])
    half = len(answer.sent) // 2
    assert [differences(part, expected) for part in (answer.sent[:half], answer.sent[half:])] == [[], []]
    assert answer.leds == "00000011"


# What may come before a frame: the board must not mind it. Some of its own bytes may have come back then.
BEFORE = {
    "bytes outside a frame": lambda frame: [0, 255, *range(0x51, 0x54), PAUSE],
    "a letter twice": lambda frame: [ord("S")],
    "half a frame": lambda frame: [*frame[: len(frame) // 2], PAUSE],
    "half a pair": lambda frame: [*frame[:3], PAUSE],
    "a byte without a stop bit": lambda frame: [*frame[:300], NO_STOP_BIT, *[0] * 20, PAUSE],
    "all but the last byte": lambda frame: [*frame[:-1], PAUSE],
    "a letter alone": lambda frame: [ord("S"), PAUSE],
}


@pytest.mark.parametrize("what", with_slow([*BEFORE], ["half a frame", "a byte without a stop bit", "a letter twice"]))
def test_resynchronises(board, grey, expected, what):
    frame = protocol.frame(*grey)
    answer = board.play([*BEFORE[what](frame), *frame])
    assert differences(answer.sent[-protocol.answer_bytes(TINY) :], expected) == []
    assert answer.leds == "00000011"


def test_an_incomplete_frame_shows_on_the_leds_and_in_the_answer(board, grey):
    answer = board.play([*protocol.frame(*grey)[:-1], PAUSE])
    assert answer.leds == "00000010"
    with pytest.raises(Exception, match="bytes instead of 576"):
        protocol.read_map(answer.sent, TINY)


def test_pairs_that_come_too_fast_end_the_frame(ghdl, grey, tmp_path):
    """A transmitter of half the rate cannot keep up: nothing is lost silently."""
    old = "transmitter : entity work.uart_transmitter\n    generic map (clocks_per_bit => "
    files = with_fault(tmp_path, "board_top.vhd", old, f"{old}2 * ")
    assert Played("tiny", files=files).play(protocol.frame(*grey)).leds == "00000010"


FAULTS = {
    "left and right exchanged": ("serial_source.vhd", "tdata <= byte_data & left;", "tdata <= left & byte_data;"),
    "an old left pixel": ("serial_source.vhd", "left <= byte_data;", 'left <= byte_data and x"7f";'),
    "a bit of the disparity": ("serial_sink.vhd", "tdata(7 downto 0) when", 'tdata(7 downto 0) xor x"01" when'),
    "never valid": ("serial_sink.vhd", "& tdata(8);", "& '0';"),
}


@pytest.mark.parametrize("fault", with_slow([*FAULTS], ["left and right exchanged"]))
def test_a_fault_is_noticed(ghdl, grey, expected, tmp_path, fault):
    answer = Played("tiny", files=with_fault(tmp_path, *FAULTS[fault])).play(protocol.frame(*grey))
    assert differences(answer.sent, expected)


@pytest.mark.slow
@pytest.mark.parametrize("config", sorted({row.config for row in BOARDS.values()}))
def test_whole_images_of_the_cores_of_the_boards(ghdl, verilator, tmp_path, config):
    """Self test and a pair, in Verilator."""
    sizes = board_vhdl.sizes(config)
    grey = [compared.pixels(path, config, sizes) for path in scene(tmp_path, config)]
    answer = Played(config, "verilator").play(protocol.frame(*grey), self_test=True)
    found = protocol.read_map(answer.sent, sizes)
    assert compared.differences(found, compared.of_program(config, *grey, sizes), sizes["output_width_px"]) == []
    assert answer.leds == "00000011"


# --- the command, at a line ---


class StandIn:
    """A board at the other end of a pseudo-terminal: takes a frame and says `answer`."""

    def __init__(self, answer):
        self.master, self.slave = pty.openpty()
        self.port, self.came, self.answer = os.ttyname(self.slave), b"", answer
        self.thread = threading.Thread(target=self.run, daemon=True)
        self.thread.start()

    def run(self):
        wanted = len(protocol.LETTERS) + 2 * TINY["width_px"] * TINY["height_px"]
        while len(self.came) < wanted:
            self.came += os.read(self.master, 4096)
        os.write(self.master, self.answer)

    def close(self):
        os.close(self.slave)
        os.close(self.master)


def right_answer(expected):
    answer = b""
    for number, disparity in enumerate(expected):
        flags = protocol.MARK | protocol.VALID
        flags |= (protocol.START if number == 0 else 0) | (protocol.END if number % WIDTH == WIDTH - 1 else 0)
        answer += bytes([int(disparity), flags])
    return answer


def speak(pair, tmp_path, answer, *options):
    stand_in = StandIn(answer)
    try:
        words = ["--left", pair[0], "--right", pair[1], "--out", tmp_path / "map.png", *options]
        return call("board.py", "--port", stand_in.port, "--config", "tiny", *words), stand_in.came
    finally:
        stand_in.close()


def test_a_pair_goes_over_the_line(pair, grey, expected, tmp_path):
    process, came = speak(pair, tmp_path, right_answer(expected), "--compare")
    assert process.returncode == 0 and "0 of 288" in process.stdout, process.stderr
    assert came == protocol.frame(*grey)
    numpy, image = compared.pictures.libraries()
    with image.open(tmp_path / "map.png") as file:
        assert numpy.asarray(file).ravel().tolist() == expected


def test_another_map_is_told(pair, expected, tmp_path):
    wrong = bytearray(right_answer(expected))
    wrong[2 * (WIDTH * 3 + 5)] ^= 1
    process, _ = speak(pair, tmp_path, bytes(wrong), "--compare")
    assert process.returncode == 1 and "1 of 288" in process.stdout and "x 5, y 3: " in process.stdout


def damaged(answer, place, value):
    return answer[:place] + bytes([value]) + answer[place + 1 :]


@pytest.mark.parametrize(
    "change, words",
    [
        (lambda answer: b"", ["did not answer"]),
        (lambda answer: answer[:-1], ["575 bytes instead of 576"]),
        (lambda answer: answer + b"\xa1", ["577 bytes instead of 576"]),
        (lambda answer: answer[1:] + b"\xa1", ["no map of 24x12", "disparity 0"]),
        (lambda answer: damaged(answer, 575, 0xAD), ["x 23, y 11", "incomplete frame"]),
        (lambda answer: damaged(answer, 101, 0xA3), ["x 2, y 2", "another place"]),
    ],
    ids=["silent", "short", "long", "shifted", "frame error", "start"],
)
def test_an_answer_that_is_no_map(pair, expected, tmp_path, change, words):
    process, _ = speak(pair, tmp_path, change(right_answer(expected)))
    refused(process, 4, *words)
    assert not (tmp_path / "map.png").exists()


def test_what_is_no_line(pair, tmp_path):
    words = ["--config", "tiny", "--left", pair[0], "--right", pair[1], "--out", tmp_path / "map.png"]
    refused(call("board.py", "--port", tmp_path / "nowhere", *words), 2, "nowhere: No such file")
    (tmp_path / "file").write_text("")
    refused(call("board.py", "--port", tmp_path / "file", *words), 2, "file is no serial line")
    refused(call("board.py", "--port", tmp_path / "file", "--baud", "999", *words), 2, "999 baud", "115200")
    refused(call("board.py", *words), 2, "--port", "--simulate")


@pytest.mark.parametrize("board", BOARDS)
def test_each_board_reaches_its_clock_and_the_page_says_it(board):
    """A change of the design needs `scripts/build_example.py --board NAME --record`, also with `--config tiny`."""
    for config in record.configurations(BOARDS[board]):
        kept = record.read(BOARDS[board], config)
        assert kept is not None, f"{config} on {board} has changed since it was measured"
        assert kept["fmax_mhz"] >= BOARDS[board].clock_mhz
        assert kept["lut_sites"] <= BOARDS[board].target.holds.lut_sites
    process = call("build_example.py", "--check")
    assert process.returncode == 0, process.stderr


def test_a_result_of_another_design_is_none(monkeypatch, tmp_path):
    monkeypatch.setattr(record, "FILE", tmp_path / "measured.json")
    board, built = (
        BOARDS["icebreaker"],
        record.Built({"lut_sites": 1, "flip_flops": 2, "block_rams": 3, "fmax_mhz": 4.5}, tmp_path),
    )
    record.keep(board, "tiny", built, record.digest(board, "tiny"))
    assert record.read(board, "tiny") == built.figures
    assert record.read(board, "ambrosch2007_f20") is None
    for change in ({"clock_mhz": 13}, {"constraints": "ulx3s.lpf"}, {"held_high": ("pin",)}, {"leds": 3}):
        assert record.read(dataclasses.replace(board, **change), "tiny") is None
    monkeypatch.setattr(record.manifest, "design", lambda entry: {"structure": "another"})
    assert record.read(board, "tiny") is None
    with pytest.raises(FlowError, match="changed in the meantime"):
        record.keep(board, "tiny", built, "digest of before")


@pytest.mark.parametrize("text", ["{", "[]", '{"format": "stereo-hls boards 1", "builds": {"icebreaker": 3}}'])
def test_damaged_results_of_boards_are_refused(monkeypatch, tmp_path, text):
    path = tmp_path / "measured.json"
    path.write_text(text)
    monkeypatch.setattr(record, "FILE", path)
    with pytest.raises(FlowError, match="damaged"):
        record.read(BOARDS["icebreaker"], "tiny")


@pytest.mark.parametrize(
    "options, words",
    [
        (["--board", "arty"], ["unknown board 'arty'", "ulx3s_85f", "icebreaker"]),
        (["--config", "huge"], ["no generated VHDL for 'huge'"]),
        (["--config", "tiny_p2"], ["pixels_per_clock 2"]),
        (["--config", "census_450"], ["disparity_bits 16"]),
        (["--config", "rectify_vga"], ["stage"]),
    ],
)
@pytest.mark.parametrize("command", ["board.py", "build_example.py"])
def test_what_no_board_takes(pair, tmp_path, command, options, words):
    own = ["--simulate", "--left", pair[0], "--right", pair[1]] if command == "board.py" else []
    refused(call(command, *own, *options, "--out", tmp_path / "out"), 2, *words)
    assert not (tmp_path / "out").exists()


def test_images_of_another_size(pair, tmp_path):
    words = ["--simulate", "--left", pair[0], "--right", pair[1], "--out", tmp_path / "map.png"]
    refused(call("board.py", "--config", "ambrosch2007_f20", *words), 2, "32x12", "takes 320x240")
    words[2] = tmp_path / "nowhere.png"
    refused(call("board.py", "--config", "tiny", *words), 2, "nowhere.png: No such file")


def test_comparing_needs_the_program(pair, tmp_path):
    words = ["--simulate", "--config", "tiny", "--left", pair[0], "--right", pair[1], "--out", tmp_path / "map.png"]
    process = call("board.py", *words, environment={"STEREO_HLS": "/nowhere/stereo_hls"})
    refused(process, 3, "stereo_hls not found at /nowhere/stereo_hls")
