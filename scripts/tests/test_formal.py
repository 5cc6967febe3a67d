# SPDX-License-Identifier: Apache-2.0
"""The memory cell, the stream blocks of the shell and the boards' serial line are proved for all inputs, and the proofs
can fail."""

import shutil

import pytest

from conftest import need
from cover import with_slow
from flow.shell import formal


@pytest.fixture
def abc():
    return need("yosys-abc", "YOSYS_ABC")


@pytest.mark.parametrize("proof", formal.PROOFS, ids=lambda proof: proof.name.replace(" ", "-"))
def test_proof(ghdl, yosys, abc, tmp_path, proof):
    assert formal.prove(proof, tmp_path) == ("proved", "")


FAULTS = {
    "a column keeps another one's bits": (
        "line_memory",
        "std_logic_vector(write_data(high downto low))",
        "std_logic_vector(write_data(bits - 1 downto 0))",
    ),
    "a write comes first": (
        "line_memory",
        "word <= memory(to_integer(read_address));",
        "word <= to_bitvector(std_logic_vector(write_data(high downto low))) when read_address = write_address "
        "else memory(to_integer(read_address));",
    ),
    "a word is lost": ("stream_register", "next_valid <= last_valid or (arrives", "next_valid <= (arrives"),
    "the order is changed": ("stream_register", "next_flags <= last_flags;", "null;"),
    "a full register takes a word": (
        "stream_register",
        "not (last_valid or (arrives and next_valid))",
        "not last_valid",
    ),
    "data of another word": ("stream_register", "main_valid = '1' and out_ready = '1'", "out_ready = '1'"),
    "a reset leaves a word": ("stream_register", "next_valid <= '0';", "null;"),
    "a word comes twice": ("stream_fifo", "read_address <= following(read_address);", "null;"),
    "a word is written over": ("stream_fifo", "return address + 1;", "return address;"),
    "a word stays in the memory": ("stream_fifo", "or (stored = 1 and not leaves)", "or false"),
    "a beat changes while it waits": ("stream_fifo", "(shows = '0' or out_ready = '1')", "true"),
    "one credit too many": ("stream_credit", "lent < words - 2", "lent < words - 1"),
    "a full queue is forgotten": ("stream_credit", "if lent < words - 2 then", "if true then"),
    "a disparity is due early": ("stream_credit", "due <= flight(latency);", "due <= flight(latency - 1);"),
    "a credit is lost": (
        "stream_credit",
        "unused <= flight(latency) and not result;",
        "unused <= flight(latency) and result;",
    ),
    "a credit comes back early": (
        "stream_credit",
        "unused <= flight(latency) and not result;",
        "unused <= flight(latency);",
    ),
    "a bit is sampled late": ("uart_receiver", "clocks_per_bit / 2 - 1;", "clocks_per_bit - 1;"),
    "the order of the bits": ("uart_receiver", "history(1) & data(7 downto 1)", "data(6 downto 0) & history(1)"),
    "no stop bit": ("uart_transmitter", "'1' & in_data & '0'", "'0' & in_data & '0'"),
    "a byte is taken early": ("uart_transmitter", "bits_left = 1 and clocks_left = 0", "bits_left = 1"),
}


# One of each block.
FAST = [
    "a write comes first",
    "a full register takes a word",
    "a word comes twice",
    "one credit too many",
    "no stop bit",
]


@pytest.mark.parametrize("fault", with_slow(FAULTS, FAST))
def test_fault_is_refuted(ghdl, yosys, abc, tmp_path, fault):
    block, old, new = FAULTS[fault]
    proofs = [proof for proof in formal.PROOFS if block in {path.stem for path in proof.files}]
    for path in proofs[0].files:
        shutil.copy(path, tmp_path)
    text = (tmp_path / f"{block}.vhd").read_text()
    assert old in text
    (tmp_path / f"{block}.vhd").write_text(text.replace(old, new, 1))
    outcomes = [formal.prove(proof, tmp_path / proof.name, tmp_path)[0] for proof in proofs]
    assert "refuted" in outcomes, outcomes
