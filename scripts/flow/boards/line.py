# SPDX-License-Identifier: Apache-2.0
"""A serial line of this machine, by the system's own calls."""

from __future__ import annotations

import contextlib
import os
import select
import termios
import time
from collections.abc import Iterator

from ..base.errors import EXIT_TOOL_FAILED, FlowError
from . import protocol

SILENT_SECONDS = 3  # a board that says nothing for so long says nothing more
SURPLUS_SECONDS = 0.1
CHUNK = 4096


def rate(baud: int) -> int:
    """What the system calls it."""
    constant = getattr(termios, f"B{baud}", None)
    if not isinstance(constant, int) or baud <= 0:
        rates = sorted(int(name[1:]) for name in dir(termios) if name[0] == "B" and name[1:].isdigit())
        raise FlowError(f"this system has no rate of {baud} baud; it has {', '.join(map(str, rates[1:]))}")
    return constant


@contextlib.contextmanager
def opened(port: str, baud: int) -> Iterator[int]:
    """The line's descriptor: bytes of 8 bits as they are, no parity, two stop bits. Quiet for so long that the board
    waits for a frame; what came before is dropped."""
    speed = rate(baud)
    line = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        try:
            *_, characters = termios.tcgetattr(line)
            # Two stop bits: a pair takes longer than its disparity, whatever the two clocks are.
            control = termios.CS8 | termios.CREAD | termios.CLOCAL | termios.CSTOPB
            termios.tcsetattr(line, termios.TCSANOW, [0, 0, control, 0, speed, speed, characters])
        except termios.error as error:
            raise FlowError(f"{port} is no serial line of {baud} baud: {error.args[-1]}") from None
        time.sleep(protocol.QUIET_SECONDS)
        termios.tcflush(line, termios.TCIOFLUSH)
        yield line
    finally:
        os.close(line)


def exchange(line: int, sent: bytes, count: int) -> bytes:
    """Sends all, and returns the answer of `count` bytes, which begins to come before all is sent; less than that where
    the board falls silent, more where it says too much."""
    left, answer = memoryview(sent), bytearray()
    while len(answer) < count or left:
        readable, writable, _ = select.select([line], [line] if left else [], [], SILENT_SECONDS)
        if not readable and not writable:
            break
        with contextlib.suppress(BlockingIOError):
            if writable:
                left = left[os.write(line, left[:CHUNK]) :]
        if readable:
            answer += _read(line)
    if len(answer) >= count and select.select([line], [], [], SURPLUS_SECONDS)[0]:
        answer += _read(line)
    if not answer:
        raise FlowError("the board did not answer: is it configured, and is this its line and rate?", EXIT_TOOL_FAILED)
    return bytes(answer)


def _read(line: int) -> bytes:
    try:
        came = os.read(line, CHUNK)
    except BlockingIOError:
        return b""
    except OSError as error:
        raise FlowError(f"the line broke off: {error.strerror}", EXIT_TOOL_FAILED) from None
    if not came:
        raise FlowError("the line broke off", EXIT_TOOL_FAILED)
    return came
