# SPDX-License-Identifier: Apache-2.0
"""The Tcl of the kits in a Tcl interpreter, with stand-ins for the vendors' commands."""

import re
from pathlib import Path

import pytest

import kits
import vendor_commands
from conftest import need
from flow.base import committed
from flow.shell import registers

CONFIGURATIONS = ["tiny", "tiny_p4", "tiny_sgm", "example"]
ROLES = {
    "axi4stream": "tvalid tready tdata tuser tlast",
    "axi4lite": "awaddr awprot awvalid awready wdata wstrb wvalid wready bresp bvalid bready araddr arprot arvalid "
    "arready rdata rresp rvalid rready",
    "clock": "clk",
    "reset": "reset_n",
    "interrupt": "irq",
}


@pytest.fixture
def tclsh():
    return need("tclsh")


def arguments(found, *head):
    """What follows `head` in the calls that begin with it."""
    return [call[len(head) :] for call in found if tuple(call[: len(head)]) == head]


def check_vivado(kit):
    found = vendor_commands.calls(kit.folder / "package_ip.tcl", vendor_commands.VIVADO)
    top = kits.entity(kit.sources()[-1])
    [files] = arguments(found, "add_files", "-norecurse")[:1]
    assert [Path(name) for name in files] == kit.sources()
    [[_, *constraints]] = arguments(found, "add_files", "-norecurse", "-fileset")
    assert len(constraints) == 1 and Path(constraints[0]).is_file(), constraints
    for words in arguments(found, "get_files"):
        assert words and all(Path(name).is_file() for name in words), words
    [top_set] = arguments(found, "set_property", "top")
    assert top_set[0] == kit.sources()[-1].stem == kit.top
    buses = arguments(found, "ipx::associate_bus_interfaces", "-busif")
    assert len(buses) == 3
    for bus, *rest in buses:
        assert any(port.startswith((f"{bus}_t", f"{bus}_aw")) for port in top.ports), bus
        assert rest[0] == "-clock" and rest[1] in top.ports
    [[clock, _, reset, _]] = arguments(found, "ipx::associate_bus_interfaces", "-clock")
    assert clock in top.ports and reset in top.ports
    inferred = arguments(found, "ipx::infer_bus_interface")
    assert len(inferred) == 1, "irq is no interrupt"
    irq, kind, _ = inferred[0]
    assert top.ports[irq] == ("out", None) and kind == "xilinx.com:signal:interrupt_rtl:1.0"
    [level] = arguments(found, "ipx::add_bus_parameter", "SENSITIVITY")
    assert ["set_property", "value", "LEVEL_HIGH", "ipx::add_bus_parameter:" + level[-1]] in found
    assert ["ipx::get_bus_interfaces", irq, "-of_objects"] in [call[:3] for call in found]
    [[span, _]] = arguments(found, "set_property", "range")
    component = (kit.folder / "component.xml").read_text()
    assert f"<ipxact:range>{span}</ipxact:range>" in component
    assert int(span) > max(register["offset"] for register in registers.description())
    names = [call[0] for call in arguments(found, "ipx::add_register")]
    known = registers.description_of(committed.folder(kit.config).parent.name)
    assert names == [register["name"] for register in known]
    assert arguments(found, "ipx::remove_memory_map"), "what Vivado guessed stays"
    fields = sum(len(register.get("fields", [0])) for register in known)
    assert len(arguments(found, "ipx::add_field")) == fields
    cleared = [call for call in found if call[:3] == ["set_property", "modified_write_value", "oneToClear"]]
    errors = [f for f in registers.by_name()["status"]["fields"].values() if f["text"].startswith("error:")]
    assert len(cleared) == len(errors) + 1, "and the interrupt's frame_done"
    assert found[-2][0] == "ipx::save_core"


def check_quartus(kit):
    found = vendor_commands.calls(kit.folder / f"{kit.top}_hw.tcl", vendor_commands.PLATFORM_DESIGNER)
    top = kits.entity(kit.sources()[-1])
    filesets = [call[1] for call in arguments(found, "add_fileset")]
    assert filesets == ["QUARTUS_SYNTH", "SIM_VHDL", "SIM_VERILOG"]
    files = arguments(found, "add_fileset_file")
    assert [kit.folder / words[3] for words in files] == kit.sources() * len(filesets)
    assert [words[0] for words in files if "TOP_LEVEL_FILE" in words] == [f"{kit.top}.vhd"] * len(filesets)
    assert {words[2] for words in arguments(found, "set_fileset_property")} == {kit.top}
    assert {words[0] for words in arguments(found, "add_parameter")} == top.generics

    kinds = {name: kind for name, kind, _ in arguments(found, "add_interface")}
    ports = {}
    for interface, port, role, direction, bits in arguments(found, "add_interface_port"):
        assert role in ROLES[kinds[interface]].split(), role
        ports[port] = (direction, int(bits))
    expected = {name: ({"in": "Input", "out": "Output"}[way], bits or 1) for name, (way, bits) in top.ports.items()}
    assert ports == expected
    vectors = {port for port, _, kind in arguments(found, "set_port_property") if kind == "STD_LOGIC_VECTOR"}
    assert vectors == {name for name, (_, bits) in top.ports.items() if bits}
    for words in arguments(found, "set_interface_property"):
        if words[1] in ("associatedClock", "associatedReset"):
            assert kinds[words[2]] == words[1].removeprefix("associated").lower()
    for path in kit.sources():
        assert path.read_text().startswith("-- synthesis VHDL_INPUT_VERSION VHDL_2008\n")


def check_qip(kit):
    before = f"array set quartus {{qip_path {{{kit.folder}}}}}"
    found = vendor_commands.calls(kit.folder / f"{kit.top}.qip", vendor_commands.QUARTUS, before)
    assert [Path(words[2]) for words in arguments(found, "set_global_assignment")] == kit.sources()
    assert all(words[3:] == ["-hdl_version", "VHDL_2008"] for words in arguments(found, "set_global_assignment"))


def check_constraints(kit):
    [path] = (kit.folder / "constraints").iterdir()
    found = vendor_commands.calls(path, {"create_clock": "-name -period", "get_ports": ""})
    assert found == [["get_ports", "aclk"], ["create_clock", "-name", "aclk", "-period", "10.000", "get_ports:aclk"]]
    assert "aclk" in kits.entity(kit.sources()[-1]).ports


CHECKS = {"vivado": [check_vivado, check_constraints], "quartus": [check_quartus, check_qip, check_constraints]}


@pytest.mark.parametrize("config", CONFIGURATIONS)
@pytest.mark.parametrize("tool", CHECKS)
def test_scripts_run_and_fit_the_vhdl(tclsh, tmp_path, tool, config):
    kit = kits.make(tmp_path / "a kit", tool, config)  # a blank splits what Tcl takes for a list
    for check in CHECKS[tool]:
        check(kit)


FAULTS = [  # (kit, file, what, instead)
    ("vivado", "package_ip.tcl", r"rtl/stereo_axis_tiny.vhd", "rtl/stereo_axes_tiny.vhd"),
    ("vivado", "package_ip.tcl", r"(?s)(rtl/stream_fifo_tiny.vhd)\n(.*?)(rtl/stream_credit_tiny.vhd)", r"\3\n\2\1"),
    ("vivado", "package_ip.tcl", r"-reset aresetn", "-reset reset"),
    ("vivado", "package_ip.tcl", r"register frames", "register frame"),
    ("vivado", "package_ip.tcl", r"oneToClear", ""),
    ("vivado", "package_ip.tcl", r"ipx::add_register", "ipx::new_register"),
    ("vivado", "package_ip.tcl", r"-import_files", "-import"),
    ("vivado", "package_ip.tcl", r"ipx::infer_bus_interface.*", ""),
    ("vivado", "package_ip.tcl", r"LEVEL_HIGH", "EDGE_RISING"),
    ("vivado", "package_ip.tcl", r"range 128", "range 4096"),
    ("vivado", "package_ip.tcl", r"constrs_1 \[list \$constraints\]", "constrs_1 $constraints"),
    ("vivado", "package_ip.tcl", r"get_files \[list \$constraints\]", "get_files $constraints"),
    ("vivado", "package_ip.tcl", r"lrange \$paths end end", "lindex $paths end"),
    ("vivado", "constraints/clock.xdc", r"get_ports aclk", "get_ports clk"),
    ("quartus", "stereo_plain_tiny_hw.tcl", r"m_axis_tdata tdata Output 16", "m_axis_tdata tdata Output 8"),
    ("quartus", "stereo_plain_tiny_hw.tcl", r"tlast Input 1", "last Input 1"),
    ("quartus", "stereo_plain_tiny_hw.tcl", r"add_interface_port s_axil s_axil_rready.*", ""),
    ("quartus", "stereo_plain_tiny_hw.tcl", r"add_parameter enabled_at_reset", "add_parameter enabled"),
    ("quartus", "stereo_plain_tiny_hw.tcl", r"associatedClock clock", "associatedClock aclk"),
    (
        "quartus",
        "stereo_plain_tiny_hw.tcl",
        r"s_axis_tuser VHDL_TYPE STD_LOGIC_VECTOR",
        "s_axis_tuser VHDL_TYPE STD_LOGIC",
    ),
    ("quartus", "stereo_plain_tiny.qip", r"rtl/line_memory_tiny.vhd", "line_memory_tiny.vhd"),
    ("quartus", "rtl/line_memory_tiny.vhd", r"-- synthesis.*", ""),
]


@pytest.mark.parametrize("tool, file, what, instead", FAULTS)
def test_the_checks_notice_a_fault(tclsh, tmp_path, tool, file, what, instead):
    kit = kits.make(tmp_path / "a kit", tool, "tiny")
    path = kit.folder / file
    text, count = re.subn(what, instead, path.read_text(), count=1)
    assert count == 1
    path.write_text(text)
    with pytest.raises((AssertionError, KeyError)):
        for check in CHECKS[tool]:
            check(kit)
