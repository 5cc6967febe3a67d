# SPDX-License-Identifier: Apache-2.0
"""Maps of true disparities in each kind of file, and pairs that they belong to."""

import json
import random
import struct
import zlib

from stereo_hls_program import HEIGHT, WIDTH, gray_image, succeed


def pfm(path, value, width=WIDTH, height=HEIGHT, order="<"):
    rows = [[value(x, y) for x in range(width)] for y in reversed(range(height))]
    header = f"Pf\n{width} {height}\n{'-1.0' if order == '<' else '1.0'}\n".encode()
    path.write_bytes(header + b"".join(struct.pack(f"{order}{width}f", *row) for row in rows))
    return path


def png16(path, value, width=WIDTH, height=HEIGHT):
    """A grey PNG file of 16 bits, as KITTI's."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + struct.pack(f">{width}H", *(value(x, y) for x in range(width))) for y in range(height))
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 0, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(rows))
        + chunk(b"IEND", b"")
    )
    return path


def npy(path, value, width=WIDTH, height=HEIGHT):
    """As numpy.save writes an array of float32."""
    header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({height}, {width}), }}".ljust(117) + "\n"
    values = (value(x, y) for y in range(height) for x in range(width))
    body = struct.pack(f"<{width * height}f", *values)
    path.write_bytes(b"\x93NUMPY\1\0" + struct.pack("<H", len(header)) + header.encode() + body)
    return path


def float_tiff(path, value, width=WIDTH, height=HEIGHT):
    """A grey TIFF of 32-bit floats in one strip."""
    pixels = struct.pack(f"<{width * height}f", *(value(x, y) for y in range(height) for x in range(width)))
    long, short, start = 4, 3, 8
    tags = [
        (256, long, width),
        (257, long, height),
        (258, short, 32),
        (259, short, 1),
        (262, short, 1),
        (273, long, start),
        (277, short, 1),
        (278, long, height),
        (279, long, len(pixels)),
        (339, short, 3),
    ]
    entries = b"".join(struct.pack("<HHII", tag, kind, 1, number) for tag, kind, number in tags)
    directory = struct.pack("<H", len(tags)) + entries + struct.pack("<I", 0)
    path.write_bytes(b"II*\0" + struct.pack("<I", start + len(pixels)) + pixels + directory)
    return path


def results(tmp_path, *arguments):
    """The printed text and the methods of the JSON."""
    out = succeed(*arguments)
    found = json.loads((tmp_path / "e.json").read_text())
    assert found["format"] == "stereo-hls evaluation 1"
    return out, found["methods"]


def shifted_pair(tmp_path, shift=3, width=WIDTH, height=HEIGHT):
    """Images shifted by `shift`, and the truth of both."""
    ground = [random.Random(y).randbytes(width + shift) for y in range(height)]
    size = {"width": width, "height": height}
    left = gray_image(tmp_path / "ls.pgm", lambda x, y: ground[y][x], **size)
    right = gray_image(tmp_path / "rs.pgm", lambda x, y: ground[y][x + shift], **size)
    truth = pfm(tmp_path / "shift.pfm", lambda x, y: shift, **size)
    images = ["--left", left, "--right", right, "--truth-left", truth, "--truth-right", truth]
    return ["evaluate", *images, "--json", tmp_path / "e.json"]
