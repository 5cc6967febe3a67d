# SPDX-License-Identifier: Apache-2.0
"""A self-checking bench of a kit's top in VHDL, for whatever simulator its user has."""

from typing import cast

from ..base.configurations import option
from ..shell import registers, template
from .fill import fill
from .subject import CLOCK, Subject

MOVED_PX = 2  # of the left image, from the lowest disparity on
NOT_CHECKED = -1


def name(subject: Subject) -> str:
    return f"tb_{subject.top}"


def _moved(subject: Subject) -> dict[str, int]:
    """How far the left image is moved, the disparity that the map then shows, and how far that may be off: half a
    pixel, where it counts parts of one."""
    lowest = option(subject.entry["parameters"], "min_disparity")
    if lowest is None:
        return {"shift": 0, "expected": NOT_CHECKED, "tolerance": 0}
    steps = 16 if option(subject.entry["parameters"], "subpixel") else 1
    return {"shift": cast(int, lowest) + MOVED_PX, "expected": MOVED_PX * steps, "tolerance": steps // 2}


def _value_bits(subject: Subject) -> int:
    """Of the disparity alone: a row of the map may have `filled` and the confidence above it."""
    of_option = {"fill_holes": 1, "confidence": 8}
    above = sum(bits for name, bits in of_option.items() if option(subject.entry["parameters"], name))
    return subject.generics["disparity_bits"] - above


def text(subject: Subject) -> str:
    sizes = ("width_px", "height_px", "pixels_per_clock", "output_width_px", "disparity_bits")
    constants = {size: subject.generics[size] for size in sizes} | _moved(subject)
    constants["value_bits"] = _value_bits(subject)
    constants |= {"pixel_bits": subject.pixel_bits, "lane_bits": template.lane_bits(subject.pixel_bits)}
    return fill(
        "tb_stereo.vhd",
        config=subject.config,
        top=subject.top,
        name=name(subject),
        constants="\n".join(f"  constant {key} : integer := {value};" for key, value in constants.items()),
        signals="\n".join(
            f"  signal {port.name} : {port.kind} := {_zero(port.kind)};" for port in subject.ports if port.name != CLOCK
        ),
        dut=template.instance("dut", subject.top, {}, {port.name: port.name for port in subject.ports}),
        checks="\n".join(_check(*known) for known in subject.register_values().items()),
        frames=f"{_offset('frames'):#04x}"[2:],
    )


def _zero(kind: str) -> str:
    return "(others => '0')" if "vector" in kind else "'0'"


def _offset(register: str) -> int:
    return next(entry["offset"] for entry in registers.description() if entry["name"] == register)


def _check(register: str, value: int) -> str:
    return f'    expect("{register}", {_offset(register)}, x"{value:08x}");'
