# SPDX-License-Identifier: Apache-2.0
"""The folder that scripts/instantiate.py --kit writes: its files for every configuration, and what it refuses."""

import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest

import kits
from cover import fast, with_slow
from flow.base import committed
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow.kit import access, contents, ipxact, quartus, write
from flow.kit.subject import Subject
from flow.shell import design, registers, template
from flow.synthesis import manifest
from flow_commands import call, refused

SPACE = {"x": ipxact.SPACE}


def texts(element, path):
    return [found.text for found in element.findall(path, SPACE)]


# Names in Arm's abstraction definitions, amba.com AMBA4 AXI4Stream_rtl r0p0_1 and AXI4-Lite_rtl r0p0_0.
LOGICAL = {
    "AXI4Stream": {"ACLK", "ARESETn", *"TVALID TREADY TDATA TUSER TLAST TKEEP TSTRB TID TDEST".split()},
    "AXI4-Lite": {"ACLK", "ARESETn"}
    | {f"A{way}{signal}" for way in "WR" for signal in ("ADDR", "PROT", "VALID", "READY")}
    | {*"WDATA WSTRB WVALID WREADY BRESP BVALID BREADY RDATA RRESP RVALID RREADY".split()},
}


def check_buses(component, top):
    """Each signal of a bus on the port of its name, with the clock and the reset of all."""
    interrupts = []
    for bus in component.findall("x:busInterfaces/x:busInterface", SPACE):
        if bus.find("x:busType", SPACE).attrib["library"] == "signal":
            interrupts.append(bus)
            continue
        [name], kind = texts(bus, "x:name"), bus.find("x:busType", SPACE).attrib["name"]
        logical, physical = texts(bus, ".//x:logicalPort/x:name"), texts(bus, ".//x:physicalPort/x:name")
        assert set(logical) <= LOGICAL[kind] and {"ACLK", "ARESETn"} <= set(logical)
        shared = {"ACLK": "aclk", "ARESETn": "aresetn"}
        assert physical == [shared.get(signal, f"{name}_{signal.lower()}") for signal in logical]
        begins = "TVALID" if kind == "AXI4Stream" else "AWVALID"
        is_master = top.ports[physical[logical.index(begins)]][0] == "out"
        assert (bus.find("x:master", SPACE) is not None) == is_master
    [interrupt] = interrupts
    assert interrupt.find("x:busType", SPACE).attrib["name"] == "interrupt"
    assert texts(interrupt, ".//x:logicalPort/x:name") == ["INTERRUPT"]
    [irq] = texts(interrupt, ".//x:physicalPort/x:name")
    assert top.ports[irq] == ("out", None) and interrupt.find("x:master", SPACE) is not None


def check_component(files, config):
    """component.xml against the VHDL in the same kit and the list of registers."""
    component = xml.fromstring(files[Path("component.xml")])
    top = kits.entity_of(files[Path("rtl") / f"stereo_plain_{config}.vhd"])
    ports = component.findall("x:model/x:ports/x:port", SPACE)
    described = {}
    for port in ports:
        [way], high = texts(port, "x:wire/x:direction"), texts(port, ".//x:left")
        described[texts(port, "x:name")[0]] = (way, int(high[0]) + 1 if high else None)
    assert described == top.ports
    assert set(texts(component, ".//x:physicalPort/x:name")) == set(top.ports)
    assert set(texts(component, "x:model//x:moduleParameter/x:name")) == top.generics
    check_buses(component, top)
    assert [Path(name) for name in texts(component, ".//x:file/x:name")][:-1] == [
        Path(name) for name in files[contents.ORDER].split()
    ]
    assert all(Path(name) in files for name in texts(component, ".//x:file/x:name"))
    known = registers.description_of(committed.folder(config).parent.name)
    assert texts(component, ".//x:register/x:name") == [entry["name"] for entry in known]
    for entry, element in zip(known, component.findall(".//x:register", SPACE)):
        fields = access.fields(entry)
        assert texts(element, "x:field/x:name") == [field["name"] for field in fields]
        assert [int(low) for low in texts(element, "x:field/x:bitOffset")] == [field["low"] for field in fields]
        assert int(texts(element, "x:addressOffset")[0].replace("'h", ""), 16) == entry["offset"]


EVERY = committed.known_configurations()


@pytest.mark.parametrize("config", with_slow(EVERY, fast() & {*EVERY}))
def test_every_configuration_has_its_kits(config):
    for kit in kits.KITS:
        files = contents.of(kit, config, 100)
        order = [Path(name) for name in files[contents.ORDER].split()]
        before = quartus.DIRECTIVE if kit == "quartus" else ""
        committed = design.vhdl_files(config)
        assert [f"rtl/{path.stem.removesuffix(f'_{config}')}_{config}.vhd" for path in committed] == [
            path.as_posix() for path in order[:-1]
        ]
        shared = "|".join(path.stem for path in committed if not path.stem.endswith(f"_{config}"))
        for path, kept in zip(order, committed):
            assert re.sub(rf"\b({shared})_{config}\b", r"\1", files[path]) == before + kept.read_text()
        assert order[-1].stem == f"stereo_plain_{config}" and order[-1] in files
        check_component(files, config)
        assert not any("@{" in text or str(ROOT) in text for text in files.values())
        scripts = "".join(text for path, text in files.items() if path.suffix in (".tcl", ".core"))
        assert all(name.as_posix() in scripts for name in order)


def test_a_component_that_does_not_fit_is_noticed():
    files = contents.of("vivado", "tiny", 100)
    component = Path("component.xml")
    for what, instead in (
        (">m_axis_tuser<", ">m_axis_user<"),
        (">ARESETn<", ">ARESETN<"),
        ("<ipxact:name>irq<", "<ipxact:name>aclk<"),
        (">INTERRUPT<", ">IRQ<"),
        ("<ipxact:master />", "<ipxact:slave />"),
        ("<ipxact:left>15<", "<ipxact:left>7<"),
        (">rtl/stereo_axis_tiny.vhd<", ">stereo_axis_tiny.vhd<"),
        (">broken_frames<", ">frames_broken<"),
        ("<ipxact:bitOffset>8<", "<ipxact:bitOffset>9<"),
    ):
        text = files[component].replace(what, instead)
        assert text != files[component]
        with pytest.raises((AssertionError, KeyError)):
            check_component(files | {component: text}, "tiny")


def test_register_values_are_what_the_core_shows():
    """As scripts/verify_axi.py reads them: size, disparities and rows, map."""
    assert Subject("tiny_p2").register_values() == {
        "id": 0x53544552,
        "version": 0x00010400,
        "core": int(manifest.read(committed.folder("tiny_p2"))["structure"][:8], 16),
        "size": 12 << 16 | 32,
        "matching": 2 << 24 | 8,
        "map": 8 << 16 | 24,
    }


def test_command_needs_no_program_and_no_tool(tmp_path):
    out = tmp_path / "new" / "kit"
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "python3").symlink_to(sys.executable)
    nothing = {"STEREO_HLS": "/nonexistent", "PATH": str(tmp_path / "bin")}
    process = call(
        "instantiate.py", "--kit", "fusesoc", "--config", "tiny", "--mhz", "74.25", "--out", out, environment=nothing
    )
    assert process.returncode == 0 and not process.stdout, process.stderr
    written = {path.relative_to(out): path.read_text() for path in out.rglob("*") if path.is_file()}
    assert written == contents.of("fusesoc", "tiny", 74.25)
    assert "-period 13.468 " in written[Path("constraints/clock.sdc")]
    assert [path.name for path in out.parent.iterdir()] == ["kit"]


def test_clock_says_where_it_comes_from():
    clock = Path("constraints/clock.xdc")
    assert "LFE5U-85F-8BG756, the core alone: " in contents.of("vivado", "ambrosch2007", 100)[clock]
    assert "has not been measured" in contents.of("vivado", "tiny_w5", 100)[clock]


@pytest.mark.parametrize(
    "options, words",
    [
        (["--kit", "vivado", "--config", "nonsense", "--out", "OUT"], ["no generated VHDL for 'nonsense'"]),
        (["--kit", "lattice", "--config", "tiny", "--out", "OUT"], ["invalid choice: 'lattice'"]),
        (["--kit", "vivado", "--config", "tiny"], ["--kit needs --out"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "FULL"], ["is not empty"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "FULL/file"], ["is a file"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "FULL/file/kit"], ["file"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "OUT", "--mhz", "fast"], ["'fast' is no number"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "OUT", "--mhz", "0"], ["'0' is no number from 0.1"]),
        (["--kit", "vivado", "--config", "tiny", "--out", "OUT", "--instance"], ["not allowed with"]),
        (["--config", "tiny", "--mhz", "100"], ["--mhz is for --kit"]),
        (["--config", "tiny", "--pad-map"], ["--pad-map is for --kit"]),
    ],
)
def test_refuses(tmp_path, options, words):
    (tmp_path / "FULL").mkdir()
    (tmp_path / "FULL" / "file").write_text("mine")
    placed = [str(tmp_path / word) if word.startswith(("OUT", "FULL")) else word for word in options]
    refused(call("instantiate.py", *placed), 2, *words)
    assert [path.name for path in tmp_path.rglob("*")] == ["FULL", "file"]


def test_fusesoc_finds_one_core_here():
    """A template is none: FuseSoC would warn of it in every search."""
    folders = [ROOT, *(ROOT / name for name in ("scripts", "hls", "generated_rtl", "examples", "hls_tb"))]
    found = [path for folder in folders for path in (folder.glob if folder == ROOT else folder.rglob)("*.core")]
    assert [path.name for path in found] == ["stereo_hls.core"]


@pytest.mark.parametrize("config, bits", [("tiny", 16), ("tiny_p2", 24), ("tiny_p4", 40)])
def test_map_padded_to_a_power_of_two(config, bits):
    for kit in kits.KITS:
        plain, padded = contents.of(kit, config, 100), contents.of(kit, config, 100, pads_map=True)
        top = Path("rtl") / f"stereo_plain_{config}.vhd"
        assert kits.entity_of(plain[top]).ports["m_axis_tdata"] == ("out", bits)
        check_component(padded, config)
        wide = kits.entity_of(padded[top]).ports["m_axis_tdata"][1]
        assert wide == {16: 16, 24: 32, 40: 64}[bits]
        assert " --pad-map`" in padded[Path("README.md")]
        assert (without_page(plain) == without_page(padded)) == (wide == bits)
        zeros = f"  m_axis_tdata({wide - 1} downto {bits}) <= (others => '0');"
        assert (zeros in padded[top]) == (wide != bits)


def without_page(files):
    return {path: text for path, text in files.items() if path.name != "README.md"}


def test_the_page_says_the_command(tmp_path):
    for options, words in (((), "tiny`"), (("--mhz", 50, "--pad-map"), "tiny --mhz 50 --pad-map`")):
        call("instantiate.py", "--kit", "vivado", "--config", "tiny", *options, "--out", tmp_path / str(len(options)))
        text = (tmp_path / str(len(options)) / "README.md").read_text()
        assert f"Made by `scripts/instantiate.py --kit vivado --config {words}" in text


def test_takes_an_empty_folder(tmp_path):
    (tmp_path / "kit").mkdir()
    kits.make(tmp_path / "kit", "vivado", "tiny")
    assert (tmp_path / "kit" / "package_ip.tcl").is_file()


def test_leaves_nothing_when_it_breaks_off(tmp_path, monkeypatch):
    two = {Path("rtl"): "a file", Path("rtl/a.vhd"): "in it"}
    monkeypatch.setattr(contents, "of", lambda *_: two)
    with pytest.raises(FlowError, match="cannot write .*kit"):
        write.write("vivado", "tiny", tmp_path / "kit", 100)
    assert not list(tmp_path.iterdir())


def test_refuses_a_manifest_without_a_size(tmp_path, monkeypatch):
    entry = manifest.read(committed.folder("tiny"))
    del entry["parameters"]["width_px"], entry["parameters"]["gap_groups"]
    (tmp_path / "family" / "tiny").mkdir(parents=True)
    manifest.write(tmp_path / "family" / "tiny", entry)
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path)
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    with pytest.raises(FlowError, match="manifest of 'tiny' says no width_px, gap_groups"):
        contents.of("vivado", "tiny", 100)


@pytest.mark.parametrize(
    "edited, said",
    [
        ("stereo_core_tiny.vhd", "differs from its manifest"),
        ("stereo_ip_tiny.vhd", "stereo_ip_tiny.vhd differs from what its manifest gives"),
    ],
)
def test_refuses_vhdl_that_was_edited(tmp_path, monkeypatch, edited, said):
    folder = tmp_path / "family" / "tiny"
    folder.mkdir(parents=True)
    for path in committed.folder("tiny").iterdir():
        (folder / path.name).write_text(path.read_text() + ("\n" if path.name == edited else ""))
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path)
    monkeypatch.setattr(committed, "EVIDENCE", tmp_path / "evidence")
    with pytest.raises(FlowError, match=said):
        contents.of("vivado", "tiny", 100)


def test_refuses_a_port_that_it_does_not_know(monkeypatch):
    ports = template.ports
    monkeypatch.setattr(template, "ports", lambda *of: [*ports(*of), template.Port("interrupt", "out", "std_logic")])
    with pytest.raises(FlowError, match="to which interface the port interrupt belongs"):
        Subject("tiny")
