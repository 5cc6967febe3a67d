# SPDX-License-Identifier: Apache-2.0
"""camera_tables of the camera system in GHDL against a model of its registers, in every clock: tables, depths, and each
bit of the faults that a processor reads and clears."""

import random
from dataclasses import dataclass, field

import pytest

from flow.base import ghdl
from flow.base.errors import FlowError
from flow.base.tools import ROOT, find_ghdl, run
from flow.mutation import mutants
from flow.system import template

TABLES = template.FOLDER / "camera_tables.vhd"
BENCH = ROOT / "hls_tb" / "shell" / "tb_camera_tables.vhd"
COLUMNS, ROWS, ENTRIES = 5, 3, 9
PLACE, OFFSETS, DEPTH, SIZE, CAMERAS, DEPTHS = range(0, 24, 4)
OKAY, ERROR = "00", "10"
DROPS_LEFT, DROPS_RIGHT, DIFFERS = 1, 2, 4  # of the joiner's faults


@dataclass
class Clock:
    """What comes in."""

    aresetn: int = 1
    awvalid: int = 0
    wvalid: int = 0
    bready: int = 1
    arvalid: int = 0
    rready: int = 1
    awaddr: int = 0
    wdata: int = 0
    araddr: int = 0
    skew: int = 0
    faults: int = 0

    def line(self):
        bits = (self.aresetn, self.awvalid, self.wvalid, self.bready, self.arvalid, self.rready)
        flags = sum(bit << number for number, bit in enumerate(bits))
        return f"{flags:02x} {self.awaddr:02x} {self.wdata:08x} {self.araddr:02x} {self.skew:04x} {self.faults:x}"


def write(address, data, **others):
    return Clock(awvalid=1, wvalid=1, awaddr=address, wdata=data, **others)


def read(address, **others):
    return Clock(arvalid=1, araddr=address, **others)


@dataclass
class Model:
    """Of the registers, from the table in the file's first lines."""

    sixteenths: int
    answer: str = ""  # bresp that waits to be taken
    shown: tuple = ()  # rresp and rdata that wait
    place: int = 0
    faults: int = 0
    node: tuple = ()  # right, column, row, x, y: in one clock
    depth: tuple = (0, 0)
    values: list = field(default_factory=list)

    def clock(self, i):
        """What is to be seen in this clock, then what it changes."""
        writes, reads = i.awvalid and i.wvalid and not self.answer, i.arvalid and not self.shown
        seen = (bool(writes), self.answer, bool(reads), self.shown, self.node, self.depth)
        known = self.faults  # before this clock
        self.faults |= i.faults
        self.node = ()
        if i.bready:
            self.answer = ""
        if i.rready:
            self.shown = ()
        if reads:
            self.shown = self._read(i.araddr & ~3, known, i.skew)
        if writes:
            self.answer = self._write(i.awaddr & ~3, i.wdata, i.faults)
        if not i.aresetn:
            self.answer, self.shown, self.node, self.faults, self.depth = "", (), (), 0, (0, 0)
        return seen

    def _write(self, address, data, faults):
        low, high = data & 0xFFFF, data >> 16
        if address == PLACE:
            self.place = data
        elif address == OFFSETS:
            column, row = self.place & 0xFFFF, self.place >> 16 & 0x7FFF
            if column >= COLUMNS or row >= ROWS:
                return ERROR
            self.node = (self.place >> 31, column, row, low, high)
        elif address == DEPTH and high < ENTRIES:
            self.depth = (high, low)
        elif address == CAMERAS:
            self.faults = faults
        else:
            return ERROR
        return OKAY

    def _read(self, address, faults, skew):
        value = {
            SIZE: ROWS << 16 | COLUMNS,
            CAMERAS: faults << 16 | skew,
            DEPTHS: self.sixteenths << 16 | ENTRIES,
        }.get(address)
        return (ERROR, 0) if value is None else (OKAY, value)


def value_of(word):
    """None where registers are not known yet."""
    return None if set(word) & {*"UX"} else int(word, 16)


class Tables:
    def __init__(self, work, text=None):
        self.work = work
        (work / TABLES.name).write_text(text or TABLES.read_text())
        ghdl.analyse([work / TABLES.name, BENCH], work)
        ghdl.elaborate(work, BENCH.stem)

    def play(self, clocks, sixteenths=0):
        """What is seen of each clock, in the model's form; a read's value where it failed is not looked at."""
        (self.work / "stimulus.txt").write_text("".join(f"{clock.line()}\n" for clock in clocks))
        names = {"stimulus_file": "stimulus.txt", "observed_file": "observed.txt", "sixteenths": sixteenths}
        names |= {"table_columns": COLUMNS, "table_rows": ROWS, "depth_entries": ENTRIES}
        run([find_ghdl(), "-r", ghdl.STANDARD, BENCH.stem, *ghdl.options_of(names)], cwd=self.work)
        seen = []
        for line in (self.work / "observed.txt").read_text().splitlines():
            bits, bresp, rresp, *words = line.split()
            aw, w, b, ar, r, node, right = bits
            rdata, column, row, x, y, disparity, mm = map(value_of, words)
            assert aw == w, "an address and its word are taken together"
            shown = (rresp, rdata if rresp == OKAY else 0) if r == "1" else ()
            found = (int(right), column, row, x, y) if node == "1" else ()
            seen.append((aw == "1", bresp if b == "1" else "", ar == "1", shown, found, (disparity, mm)))
        return seen


RESET = [Clock(aresetn=0)] * 2


def wrong(seen, clocks, sixteenths=0):
    """The first clock whose outputs are not the model's, behind the first one: registers are unknown before it."""
    model = Model(sixteenths)
    for number, (clock, shown) in enumerate(zip(clocks, seen)):
        wanted = model.clock(clock)
        if number and shown != wanted:
            return f"clock {number}: {shown} instead of {wanted}"
    return "" if len(seen) == len(clocks) else f"{len(seen)} of {len(clocks)} clocks"


def bit_clocks(bit):
    """One bit of the faults for one clock: read twice, cleared, read again; and one that comes in the clock of the
    write, which must not be lost."""
    steps = [Clock(faults=bit), Clock(), read(CAMERAS, skew=0x8001), Clock(), read(CAMERAS), Clock()]
    steps += [write(CAMERAS, 0), Clock(), read(CAMERAS), Clock()]
    return RESET + steps + [write(CAMERAS, 0, faults=bit), Clock(), read(CAMERAS), Clock()]


def random_clocks(generator, count=4000):
    """Everything at random, most of it near the ends of the tables."""
    clocks = list(RESET)
    for _ in range(count):
        low = generator.choice([*range(COLUMNS + 2), generator.getrandbits(16)])
        high = generator.choice([*range(ROWS + 2), ENTRIES - 1, ENTRIES, generator.getrandbits(15)])
        high |= generator.getrandbits(1) << 15 if generator.random() < 0.3 else 0
        often = [int(generator.random() < 0.7) for _ in range(5)]
        addresses = [4 * generator.randrange(8) | generator.choice([0, 0, generator.randrange(4)]) for _ in range(2)]
        faults = generator.getrandbits(3) if generator.random() < 0.1 else 0
        reset = int(generator.random() > 0.01)
        data = high << 16 | low
        clocks.append(Clock(reset, *often, addresses[0], data, addresses[1], generator.getrandbits(16), faults))
    return clocks


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    return Tables(tmp_path_factory.mktemp("tables"))


@pytest.mark.parametrize("bit", [DROPS_LEFT, DROPS_RIGHT, DIFFERS])
def test_each_bit_of_the_faults(ghdl, tables, bit):
    clocks = bit_clocks(bit)
    seen = tables.play(clocks)
    assert wrong(seen, clocks) == ""
    values = [shown[1] >> 16 for _, _, _, shown, _, _ in seen if shown]
    assert values == [bit, bit, 0, bit]


@pytest.mark.parametrize("sixteenths", [0, 1])
def test_random_accesses(ghdl, tables, sixteenths):
    clocks = random_clocks(random.Random(sixteenths))
    assert wrong(tables.play(clocks, sixteenths), clocks, sixteenths) == ""


FAULTS = {
    "a fault shows for one clock only": ("seen <= seen or faults;", "seen <= faults;"),
    "the first fault is overwritten": ("seen <= seen or faults;", 'seen <= faults when faults /= "000" else seen;'),
    "the bits stand elsewhere": ("seen & skew_lines", "seen(0) & seen(2 downto 1) & skew_lines"),
    "a fault in the clock of the write is lost": ("seen <= faults;", 'seen <= "000";'),
    "nothing clears": ("          seen <= faults;", "          null;"),
    "every write clears": ("        answers <= '1';\n", "        answers <= '1';\n        seen <= faults;\n"),
    "a reset keeps the faults": ('        seen <= "000";\n', ""),
    "one column too many": ("< table_columns", "<= table_columns"),
    "one depth too many": ("< depth_entries", "<= depth_entries"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_fault_is_found(ghdl, tmp_path, fault):
    old, new = FAULTS[fault]
    text = TABLES.read_text()
    assert text.count(old) == 1
    assert found(Tables(tmp_path, text.replace(old, new)))


def found(tables):
    """Whether the streams of the tests show that these tables are not as they should be."""
    streams = [(0, bit_clocks(DROPS_LEFT)), *((one, random_clocks(random.Random(one))) for one in (0, 1))]
    try:
        return any(wrong(tables.play(clocks, one), clocks, one) for one, clocks in streams)
    except FlowError:  # a value outside its range
        return True


@pytest.mark.slow
def test_every_mutant_is_found(ghdl, tmp_path):
    """Single faults of all kinds at all places."""
    survivors, compiled = [], 0
    for count, mutant in enumerate(mutants.mutants_of(TABLES)):
        work = tmp_path / str(count)
        text = mutants.write(mutant, work / "changed").read_text()
        try:
            tables = Tables(work, text)
        except FlowError:
            continue
        compiled += 1
        survivors += [] if found(tables) else [mutant.key]
    assert compiled > 80 and survivors == []
