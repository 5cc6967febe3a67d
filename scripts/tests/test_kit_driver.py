# SPDX-License-Identifier: Apache-2.0
"""The C driver of the kits: in C99 without a warning, on a model of the registers, and on the registers of the VHDL."""

import subprocess

import pytest

import kits
from conftest import need
from cover import with_slow
from flow.base.tools import ROOT
from flow.kit import naming
from flow.simulation.simulators import Design, Verilator

BENCHES = ROOT / "hls_tb" / "kit"
STRICT = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]


@pytest.fixture
def gcc():
    return need("gcc")


def named(kit, folder, bench):
    """A bench of hls_tb/kit with the names of a kit's driver."""
    path = folder / bench
    path.write_text(naming.of_c(kit.config, (BENCHES / bench).read_text()))
    return path


def source(kit, name):
    return kit.folder / "software" / naming.of_c(kit.config, name)


def compiled(gcc, kit, out, *words):
    """Compiles the driver with `words` into `out`."""
    software = kit.folder / "software"
    command = [gcc, *STRICT, "-I", software, source(kit, "stereo_driver.c"), *words, "-o", out]
    process = subprocess.run(command, capture_output=True, text=True)
    assert process.returncode == 0, process.stderr
    return out


def on_the_model(gcc, kit, folder):
    program = compiled(gcc, kit, folder / "test", named(kit, folder, "driver_model_test.c"))
    return subprocess.run([program], capture_output=True, text=True)


@pytest.mark.parametrize(
    "config", ["tiny", "tiny_p4", "tiny_sgm", "tiny_sgm_settings", "tiny_trellis_settings", "example"]
)
def test_driver_on_a_model(gcc, tmp_path, config):
    process = on_the_model(gcc, kits.make(tmp_path / "kit", "vivado", config), tmp_path)
    assert process.returncode == 0 and process.stdout == "0 wrong\n", process.stdout


FAULTS = [  # (file, what, instead, what the test says)
    ("stereo_driver.c", "!= STEREO_ID_VALUE", "== 0", "an empty bus"),
    ("stereo_driver.c", "version >> 16 == wanted >> 16 && ", "", "another major version"),
    ("stereo_driver.c", "!= STEREO_CORE_VALUE", "== 0", "another core"),
    ("stereo_driver.c", "if (errors != 0) set", "if (errors == 0) set", "not cleared"),
    ("stereo_driver.c", " & STEREO_STATUS_CLEARED_BY_1", "", "busy is one"),
    ("stereo_driver.c", "OFFSET, control | ", "OFFSET, (control ^ 1u) | ", "changes enable"),
    ("stereo_driver.c", "return STEREO_NO_ANSWER;", "return STEREO_OK;", "does not end is not noticed"),
    ("stereo_driver.c", "get(device, offset) >> 16", "get(device, offset) >> 8", "the largest value of a setting"),
    ("stereo_driver.c", " || value > largest", "", "beyond the limit is taken"),
    ("stereo_driver.c", "largest == 0 || ", "", "a core without a setting takes 0"),
    ("stereo_driver.c", "INTERRUPT_OFFSET, value)", "INTERRUPT_OFFSET, 0)", "not cleared"),
    ("stereo_registers.h", "HEIGHT_PX_SHIFT 16", "HEIGHT_PX_SHIFT 8", "size of the image"),
]


@pytest.mark.parametrize("file, what, instead, said", FAULTS)
def test_the_model_notices_a_fault(gcc, tmp_path, file, what, instead, said):
    kit = kits.make(tmp_path / "kit", "vivado", "tiny")
    path, text = source(kit, file), source(kit, file).read_text()
    what, instead = (naming.of_c(kit.config, words) for words in (what, instead))
    assert what in text
    path.write_text(text.replace(what, instead))
    process = on_the_model(gcc, kit, tmp_path)
    assert process.returncode == 1 and said in process.stdout, process.stdout


@pytest.mark.parametrize("config", with_slow(["tiny", "tiny_settings"], ["tiny_settings"]))
def test_driver_on_the_vhdl(gcc, ghdl, verilator, tmp_path, config):
    """Frames go through the top of a kit in Verilator meanwhile. Then again with one that does not clear errors."""
    kit = kits.make(tmp_path / "kit", "vivado", config)
    driver = compiled(gcc, kit, tmp_path / "driver.o", "-c")
    options = ["-CFLAGS", f"-I{kit.folder / 'software'}"]
    bench_files = [named(kit, tmp_path, "driver_bench.cpp"), driver]
    Verilator().build(tmp_path, Design(kit.top, kit.sources(), bench_files, options=options))
    bench = Verilator.program(tmp_path)
    process = subprocess.run([bench], capture_output=True, text=True)
    assert process.returncode == 0 and process.stdout == "288 of 288 disparities right, 0 wrong\n", process.stdout

    path = source(kit, "stereo_driver.c")
    path.write_text(path.read_text().replace("if (errors != 0) set", "if (errors == 0) set"))
    compiled(gcc, kit, driver, "-c")
    bench.unlink()
    subprocess.run(["make", "-C", bench.parent, "-f", "Vdesign.mk"], check=True, capture_output=True)
    process = subprocess.run([bench], capture_output=True, text=True)
    assert process.returncode == 1 and "errors are not cleared" in process.stdout, process.stdout
