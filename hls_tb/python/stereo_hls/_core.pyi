# SPDX-License-Identifier: Apache-2.0
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

version: str

class CoreNotBuilt(RuntimeError): ...

def set_core_folder(folder: Path) -> None: ...
def configurations() -> str: ...
def families() -> str: ...
def match(
    left: NDArray[Any],
    right: NDArray[Any],
    configuration: str,
    settings: list[tuple[str, str]],
    clocked: bool,
    threads: int,
    /,
) -> dict[str, Any]: ...
def match_deep(
    left: NDArray[Any],
    right: NDArray[Any],
    configuration: str,
    settings: list[tuple[str, str]],
    clocked: bool,
    threads: int,
    /,
) -> dict[str, Any]: ...
def shown(name: str, image: NDArray[Any], bits: int, /) -> NDArray[Any]: ...
def evaluate(
    found: NDArray[Any],
    truth: NDArray[Any],
    other_truth: NDArray[Any] | None,
    image: NDArray[Any] | None,
    reference: str,
    search: tuple[int, int] | None,
    border_px: int,
    /,
) -> str: ...
def scene(
    width: int, height: int, disparities: int, seed: int, noise: int, pixel_bits: int, /
) -> dict[str, NDArray[Any]]: ...
def trace(configuration: str, clocks: int, /) -> dict[str, NDArray[Any]]: ...
