# SPDX-License-Identifier: Apache-2.0
"""Runs the program stereo_hls, env STEREO_HLS, on images made here."""

import json
import os
import random
import struct
import subprocess
import zlib

PROGRAM = os.environ.get("STEREO_HLS", "") and os.path.abspath(
    os.environ["STEREO_HLS"]
)  # tests run it in other folders
WIDTH, HEIGHT, DISPARITIES = 32, 12, 8  # configuration tiny, as test_configurations_as_json checks


def run(*arguments, cwd=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=120, cwd=cwd)


def succeed(*arguments):
    result = run(*arguments)
    assert result.returncode == 0, result.stderr
    assert result.stderr == ""
    return result.stdout


def fail(folder, *arguments, says):
    """Exit code 2, one line on stderr with all of `says` in it, nothing written. Runs in the folder: relative paths end
    there."""
    before = sorted(folder.rglob("*"))
    result = run(*arguments, cwd=folder)
    assert result.returncode == 2, result.stderr
    assert result.stderr.count("\n") == 1 and result.stderr.startswith("stereo_hls: "), result.stderr
    for words in says:
        assert str(words) in result.stderr
    assert sorted(folder.rglob("*")) == before


def write_image(path, width=WIDTH, height=HEIGHT, channels=1, maximum=255, seed=1):
    """A random PGM or PPM file."""
    count = width * height * channels * (1 if maximum < 256 else 2)
    kind = b"P5" if channels == 1 else b"P6"
    pixels = random.Random(seed).randbytes(count)
    path.write_bytes(kind + f"\n{width} {height}\n{maximum}\n".encode() + pixels)
    return path


def png(path, channels, values, width=WIDTH, height=HEIGHT):
    """A PNG of 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha channels of 8 bits."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    line = width * channels
    rows = b"".join(b"\0" + values[line * y : line * (y + 1)] for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 2: 4, 3: 2, 4: 6}[channels], 0, 0, 0)
    parts = chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + parts)
    return path


def png_size(path):
    header = path.read_bytes()[:24]
    assert header.startswith(b"\x89PNG")
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")


def png_depth(path):
    """Bits of a channel."""
    return path.read_bytes()[24]


def gray_image(path, value, width=WIDTH, height=HEIGHT):
    """A PGM file with value(x, y) at each pixel."""
    pixels = bytes(value(x, y) for y in range(height) for x in range(width))
    path.write_bytes(f"P5\n{width} {height}\n255\n".encode() + pixels)
    return path


def deep_image(path, value, width=WIDTH, height=HEIGHT):
    """A PGM file of 16 bits with value(x, y) at each pixel."""
    pixels = b"".join(value(x, y).to_bytes(2, "big") for y in range(height) for x in range(width))
    path.write_bytes(f"P5\n{width} {height}\n65535\n".encode() + pixels)
    return path


def gray_as_colour(path, value, width=WIDTH, height=HEIGHT):
    """A PPM file whose three channels are value(x, y)."""
    pixels = bytes(value(x, y) for y in range(height) for x in range(width) for _ in range(3))
    path.write_bytes(f"P6\n{width} {height}\n255\n".encode() + pixels)
    return path


def changed(arguments, option, value):
    arguments = list(arguments)
    arguments[arguments.index(option) + 1] = value
    return arguments


def match_facts(tmp_path):
    return json.loads((tmp_path / "out" / "match.json").read_text())
