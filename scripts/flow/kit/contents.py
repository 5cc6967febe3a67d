# SPDX-License-Identifier: Apache-2.0
"""What is in a kit: {file: text}, from manifest.json and the committed VHDL."""

from collections.abc import Callable
from pathlib import Path

from ..base import committed
from ..base.errors import FlowError
from ..base.files import shown
from ..base.tools import ROOT
from ..shell import registers, template
from ..synthesis import manifest
from . import bench, constraints, fusesoc, ipxact, naming, quartus, software, vivado
from .fill import fill
from .subject import Subject, wrapper, wrapper_file

Files = dict[Path, str]
ORDER = Path("compile_order.txt")
TOOLS = {"vivado": "Vivado", "quartus": "Quartus", "fusesoc": "FuseSoC"}
TRIED = {
    "vivado": "Not tried in Vivado: package_ip.tcl ran in a Tcl interpreter with stand-ins for Vivado's commands.",
    "quartus": "Not tried in Quartus: the component ran in a Tcl interpreter with stand-ins for "
    "Platform Designer's commands. The VHDL is valid as VHDL-93, too.",
    "fusesoc": "Tried in FuseSoC with GHDL: targets lint and sim.",
}
START = {
    "vivado": "`vivado -mode batch -source package_ip.tcl` makes packaged/: add it to your project's IP repositories.",
    "quartus": "Add this folder to the IP search path of Platform Designer ({top}_hw.tcl), or {top}.qip to a project.",
    "fusesoc": "`fusesoc --cores-root . run --target sim {top}`; in your core file depend on `:stereo:{top}`.",
}


def of(kit: str, config: str, mhz: float, pads_map: bool = False) -> Files:
    """All files of a kit for the tool `kit`."""
    registers.require_in_step()
    subject = Subject(config, pads_map)
    if not template.is_fresh(config, manifest.read(committed.folder(config))):
        again = f"scripts/synthesize.py --refresh --config {config}"
        raise FlowError(f"{shown(template.path(config))} differs from what its manifest gives; run {again}")
    texts = {path.name: path.read_text() for path in subject.sources} | {wrapper_file(subject): wrapper(subject)}
    rtl = {Path("rtl") / name: text for name, text in naming.of_vhdl(config, subject.own_units, texts).items()}
    if kit == "quartus":
        rtl = {path: quartus.DIRECTIVE + text for path, text in rtl.items()}
    clock = Path("constraints") / ("clock.xdc" if kit == "vivado" else "clock.sdc")
    bench_file = Path("sim") / f"{bench.name(subject)}.vhd"
    sources = [path.as_posix() for path in rtl]
    files = {
        **rtl,
        bench_file: bench.text(subject),
        clock: constraints.text(subject, mhz),
        Path("component.xml"): ipxact.component(subject, rtl, [clock]),
        **{Path("software") / name: text for name, text in software.files(subject).items()},
        Path("manifest.json"): subject.manifest_file.read_text(),
        Path("LICENSE"): (ROOT / "LICENSE").read_text(),
        ORDER: "\n".join(sources) + "\n",
        Path("README.md"): _readme(kit, subject, bench_file, _options(mhz, pads_map)),
    }
    return files | _SCRIPTS[kit](subject, sources, bench_file.as_posix())


def _vivado(subject: Subject, sources: list[str], bench_file: str) -> Files:
    return {Path("package_ip.tcl"): vivado.script(subject, sources)}


def _quartus(subject: Subject, sources: list[str], bench_file: str) -> Files:
    return {
        Path(f"{subject.top}_hw.tcl"): quartus.component(subject, sources),
        Path(f"{subject.top}.qip"): quartus.file_list(subject, sources),
    }


def _fusesoc(subject: Subject, sources: list[str], bench_file: str) -> Files:
    return {Path(f"{subject.top}.core"): fusesoc.core(subject, sources, bench_file)}


_SCRIPTS: dict[str, Callable[[Subject, list[str], str], Files]] = {
    "vivado": _vivado,
    "quartus": _quartus,
    "fusesoc": _fusesoc,
}


def _options(mhz: float, pads_map: bool) -> str:
    """What of the command is not its default."""
    given = "" if mhz == constraints.DEFAULT_MHZ else f" --mhz {mhz:g}"
    return given + (" --pad-map" if pads_map else "")


def _readme(kit: str, subject: Subject, bench_file: Path, options: str) -> str:
    return fill(
        "README.md",
        config=subject.config,
        tool=TOOLS[kit],
        kit=kit,
        options=options,
        top=subject.top,
        start=START[kit].format(top=subject.top),
        tried=TRIED[kit],
        order=ORDER.name,
        bench=bench_file.as_posix(),
        bench_top=bench.name(subject),
    )
