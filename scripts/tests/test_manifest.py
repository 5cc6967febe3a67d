# SPDX-License-Identifier: Apache-2.0
"""The committed VHDL must follow from the committed sources: a change of the C++ without new VHDL fails here."""

import json
import os

import pytest

from cover import simulated, with_slow
from flow.base import committed, rtl, tools
from flow.base.configurations import PLANNED, configuration, designs
from flow.base.errors import FlowError
from flow.synthesis import generate, manifest, sources
from flow_commands import call

TABLE = designs()
CONFIGURATIONS = sorted(name for name, row in TABLE.items() if row["use"] != PLANNED)


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_is_up_to_date(name):
    reasons = manifest.stale_reasons(name, TABLE[name], reads_vhdl=False)
    assert not reasons, f"{name} is stale ({'; '.join(reasons)}); run scripts/synthesize.py --config {name}"


@pytest.mark.parametrize("name", with_slow(CONFIGURATIONS, simulated() & {*CONFIGURATIONS}))
def test_generated_vhdl_is_the_design_that_was_made(name):
    assert manifest.edit_reasons(committed.folder(name)) == []


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_is_what_the_manifest_says(name):
    folder = committed.folder(name)
    assert folder.parent.name == TABLE[name]["family"]
    assert manifest.core_files(name) == [rtl.MEMORY_CELL, folder / f"{committed.entity(name)}.vhd"], "compile order"


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_generated_vhdl_says_where_it_came_from(name):
    head = (committed.folder(name) / f"{committed.entity(name)}.vhd").read_text()[:800]
    for words in (
        "SPDX-License-Identifier: Apache-2.0",
        f"configuration {name}",
        rtl.kind_of(TABLE[name]).top,
        "PandA Bambu",
        "synthesize.py",
    ):
        assert words in head


def test_every_folder_is_a_configuration():
    assert committed.known_designs() == CONFIGURATIONS
    taken = {name for name in CONFIGURATIONS if TABLE[name]["use"] in committed.TAKEN}
    assert {path.name for path in committed.GENERATED_RTL.glob("*/*")} == taken


@pytest.mark.parametrize("name", CONFIGURATIONS)
def test_nothing_of_the_tools_library_is_committed(name):
    for path in committed.folder(name).iterdir():
        text = path.read_text().lower()
        for word in ("politecnico", "lgpl", "panda_pkg", "_expr_fu", "mux_gate", "lesser general"):
            assert word not in text, f"{path.name} has '{word}'"


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A copy of what the digests cover, to be changed."""
    for pattern in (
        "hls/**/*.[hc]pp",
        "hls/rtl/*.vhd",
        "scripts/flow/base/*.py",
        "scripts/flow/synthesis/**/*.py",
        "generated_rtl/*/tiny/*",
        "generated_rtl/*/ambrosch2007/*",
    ):
        for path in tools.ROOT.glob(pattern):
            target = tmp_path / path.relative_to(tools.ROOT)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(path.read_bytes())
    monkeypatch.setattr(manifest, "ROOT", tmp_path)
    monkeypatch.setattr(sources, "ROOT", tmp_path)
    monkeypatch.setattr(committed, "GENERATED_RTL", tmp_path / "generated_rtl")
    monkeypatch.setattr(rtl, "MEMORY_CELL", tmp_path / "hls" / "rtl" / "line_memory.vhd")
    manifest._included.cache_clear()
    yield tmp_path
    manifest._included.cache_clear()


def append(path, text="changed = 1;\n"):
    path.write_text(path.read_text() + text)


def test_a_changed_or_missing_source_makes_the_vhdl_stale(project):
    row = TABLE["tiny"]
    assert manifest.stale_reasons("tiny", row) == []
    append(project / "hls" / "cost" / "sad_cost.hpp")
    append(project / "hls" / "support" / "ring.hpp")
    append(project / "hls" / "rtl" / "line_memory.vhd")
    (project / "scripts" / "flow" / "synthesis" / "lowering" / "rules.py").unlink()
    for path in ("base/rtl.py", "synthesis/bambu.py", "synthesis/generate.py"):
        append(project / "scripts" / "flow" / path)
    assert manifest.stale_reasons("tiny", row) == [
        "hls/cost/sad_cost.hpp changed",
        "hls/rtl/line_memory.vhd changed",
        "hls/support/ring.hpp changed",
        "scripts/flow/base/rtl.py changed",
        "scripts/flow/synthesis/bambu.py changed",
        "scripts/flow/synthesis/generate.py changed",
        "scripts/flow/synthesis/lowering/rules.py is gone",
    ]


def test_only_what_the_hardware_top_includes_counts(project, monkeypatch):
    """A new family changes nothing for the others; a header that joins does."""
    row = TABLE["tiny"]
    monkeypatch.setattr(sources, "is_same_code", lambda *_: False)  # of an empty header it is
    (project / "hls" / "semi_local").mkdir()
    for path in ("semi_local/core.hpp", "cost/mutual_information.hpp", "winner/unused.hpp"):
        (project / "hls" / path).write_text("#pragma once\n")
    assert manifest.stale_reasons("tiny", row) == []
    core = project / "hls" / "block_matching" / "core.hpp"
    core.write_text(
        core.read_text().replace("#pragma once\n", '#pragma once\n#include "cost/mutual_information.hpp"\n')
    )
    manifest._included.cache_clear()
    assert manifest.stale_reasons("tiny", row) == [
        "hls/block_matching/core.hpp changed",
        "hls/cost/mutual_information.hpp is new",
    ]


def test_vhdl_that_is_not_what_was_made_is_said(project):
    design = project / "generated_rtl" / "block_matching" / "tiny" / "stereo_core_tiny.vhd"
    append(design, "-- by hand\n")
    assert manifest.stale_reasons("tiny", TABLE["tiny"]) == ["stereo_core_tiny.vhd was edited"]
    design.unlink()
    assert manifest.stale_reasons("tiny", TABLE["tiny"]) == ["stereo_core_tiny.vhd is missing"]


def edit_manifest(folder, **changes):
    """By hand, not by the flow."""
    path = folder / "manifest.json"
    path.write_text(json.dumps(json.loads(path.read_text()) | changes))


def test_a_manifest_that_was_edited_is_said(project):
    folder = project / "generated_rtl" / "block_matching" / "tiny"
    report = manifest.read(folder)["tool_report"] | {"register_bits": 1}
    edit_manifest(folder, tool_report=report)
    assert manifest.stale_reasons("tiny", TABLE["tiny"]) == ["manifest.json was edited"]


@pytest.mark.parametrize("changes", [{"files": {}}, {"configuration": "tiny_p2"}])
def test_a_manifest_that_does_not_name_the_core_is_said(project, changes):
    folder = project / "generated_rtl" / "block_matching" / "tiny"
    manifest.write(folder, manifest.read(folder) | changes)
    reasons = manifest.stale_reasons("tiny", TABLE["tiny"])
    assert reasons == ["its manifest does not name stereo_core_tiny.vhd as its VHDL"]


def test_vhdl_and_digest_edited_together_are_said(project):
    folder = project / "generated_rtl" / "block_matching" / "tiny"
    design = folder / "stereo_core_tiny.vhd"
    design.write_text(design.read_text().replace("raster_place_group = 11", "raster_place_group = 10"))
    digests = {design.name: manifest.digest(design)}
    edit_manifest(folder, files=digests)
    expected = ["manifest.json was edited", "stereo_core_tiny.vhd is not the design that was made"]
    assert manifest.stale_reasons("tiny", TABLE["tiny"]) == expected
    manifest.write(folder, manifest.read(folder))
    assert manifest.stale_reasons("tiny", TABLE["tiny"]) == expected[1:], "even with another seal"


def test_a_program_that_is_older_than_a_table_is_refused(project, tmp_path, monkeypatch):
    program = tmp_path / "stereo_hls"
    program.write_text("#!/bin/sh\n")
    program.chmod(0o755)
    monkeypatch.setenv("STEREO_HLS", str(program))
    table = project / "hls" / "block_matching" / "configurations.hpp"
    for other in project.glob("hls/*/configurations.hpp"):
        os.utime(other, (1000, 1000))
    manifest.check_program({"tiny": TABLE["tiny"]})
    os.utime(table, (program.stat().st_mtime + 10,) * 2)
    with pytest.raises(
        FlowError, match="is older than hls/block_matching/configurations.hpp; build it again"
    ) as caught:
        manifest.check_program({"tiny": TABLE["tiny"]})
    assert caught.value.exit_code == 1


def test_a_changed_row_of_the_table_makes_only_its_vhdl_stale(project):
    append(project / "hls" / "block_matching" / "configurations.hpp", "// another configuration\n")
    assert manifest.stale_reasons("ambrosch2007", TABLE["ambrosch2007"]) == []
    for change in ({"disparities": 9}, {"use": "system"}):
        reasons = manifest.stale_reasons("tiny", TABLE["tiny"] | change)
        assert reasons == ["its row in block_matching/configurations.hpp changed"]


def test_check_command_needs_no_bambu():
    """Of one row of each kind; the test above looks at every row in the same way."""
    names = ["tiny", "tiny_sgm", "tiny_trellis", "tiny_phase", "rectify_tiny"]
    rows = [word for name in names for word in ("--config", name)]
    process = call("synthesize.py", "--check", *rows, environment={"BAMBU": "/nowhere/bambu"})
    assert process.returncode == 0, process.stderr
    for name in names:
        assert f"{name}: up to date" in process.stdout


STAND_IN = """#!/bin/sh
echo "$@" >> "$0.calls"
case "$1" in
  --version) echo " Version: PandA 2024.10 - Revision 0123456789abcdef-main"; exit 0 ;;
esac
exit 7
"""


def test_a_failing_tool_leaves_nothing_behind(tmp_path):
    bambu = tmp_path / "bambu"
    bambu.write_text(STAND_IN)
    bambu.chmod(0o755)
    process = call("synthesize.py", "--config", "tiny", "--out", tmp_path / "rtl", environment={"BAMBU": str(bambu)})
    assert process.returncode == 4
    assert "bambu failed with exit code 7" in process.stderr
    assert not (tmp_path / "rtl" / "tiny").exists()
    version, command = (tmp_path / "bambu.calls").read_text().splitlines()
    assert version == "--version"
    for option in (
        "hls/top/stereo_top.cpp",
        "-DSTEREO_FAMILY=block_matching",
        "-DSTEREO_CONFIGURATION=tiny",
        "--top-fname=stereo_core",
        "-wH",
        "--generate-components-library",
    ):
        assert option in command.split()


def test_a_log_without_figures_is_refused():
    from flow.synthesis import bambu

    with pytest.raises(FlowError, match="no line 'Number of states"):
        bambu.read_log("nothing of use")


def test_header_fits_the_line():
    assert all(
        len(line) <= 120
        for line in generate.header("x", configuration("tiny"), "PandA Bambu 2024.10 revision 683d87153").splitlines()
    )


def test_a_comment_or_a_layout_makes_nothing_stale(project):
    """Of C++ and of Python, in a header that every core has."""
    header = project / "hls" / "support" / "hls_support.hpp"
    header.write_text(header.read_text().replace("#pragma once\n", "#pragma once  // once\n/* said\n twice */\n\n"))
    step = project / "scripts" / "flow" / "synthesis" / "lowering" / "rules.py"
    step.write_text(f"# what it needs\n{step.read_text()}")
    for name in ("tiny", "ambrosch2007"):
        assert manifest.freshness(name, TABLE[name]) == manifest.Freshness([])


def require_clang():
    try:
        sources.find_clang()
    except FlowError as error:
        pytest.skip(f"SKIP: {error}")


def test_the_same_code_of_clang_makes_nothing_stale(project, monkeypatch):
    """A member that nobody uses; then one that is used."""
    if not manifest.read(committed.folder("tiny"))["code"]:
        pytest.fail("the manifest has no digest of clang's code")
    require_clang()
    row, header = TABLE["tiny"], project / "hls" / "cost" / "pixel_cost.hpp"
    text = header.read_text()
    if (
        sources.code(manifest.compiler_options("tiny", row))["compiler"]
        != manifest.read(committed.folder("tiny"))["code"]["compiler"]
    ):
        pytest.skip("SKIP: another release of clang than that of the manifests")
    header.write_text(text.replace("namespace stereo {", "namespace stereo {\ninline constexpr int kUnused = 3;", 1))
    assert header.read_text() != text
    assert manifest.freshness("tiny", row) == manifest.Freshness([], by_code=True)
    manifest.write(committed.folder("tiny"), manifest.refreshed("tiny", row))
    assert manifest.freshness("tiny", row) == manifest.Freshness([])
    cost = project / "hls" / "cost" / "sad_cost.hpp"
    changed = cost.read_text().replace("kPairs = (kTaps - 1) / 2", "kPairs = (kTaps + 1) / 2")
    assert changed != cost.read_text()
    cost.write_text(changed)
    assert manifest.freshness("tiny", row).reasons == ["hls/cost/sad_cost.hpp changed"]


def test_names_of_cpp_are_not_in_the_code():
    code = """; ModuleID = 'top.cpp'
%"struct.stereo::Tag.7" = type { i8, i16 }
%struct.Plain = type { i8 }
@_ZN6stereo5wordsILi3EE = internal global [4 x i8] zeroinitializer
define void @stereo_core(ptr %0) {
  %2 = alloca %"struct.stereo::Tag.7"
  %3 = alloca %struct.Plain
  store i8 0, ptr @_ZN6stereo5wordsILi3EE
"""
    renamed = code.replace("Tag.7", "PixelTag.12").replace("5wordsILi3EE", "6memoryILi4EE").replace("'top", "'other")
    assert sources.without_names(renamed) == sources.without_names(code)
    for other in (
        code.replace("i16 }", "i32 }"),
        code.replace('alloca %"struct.stereo::Tag.7"', "alloca %struct.Plain"),
        code.replace("@stereo_core", "@stereo"),
    ):
        assert sources.without_names(other) != sources.without_names(code)


def test_a_pragma_of_the_interface_makes_it_stale(project):
    """It is not in clang's code; a macro of the top is."""
    require_clang()
    top = project / "hls" / "top" / "stereo_top.cpp"
    text = top.read_text()
    top.write_text(text.replace("STEREO_PORT", "STEREO_PORT_OF"))
    assert manifest.freshness("tiny", TABLE["tiny"]) == manifest.Freshness([], by_code=True)
    top.write_text(text.replace("port = valid mode = none", "port = valid mode = handshake"))
    assert manifest.freshness("tiny", TABLE["tiny"]).reasons == ["hls/top/stereo_top.cpp changed"]


@pytest.mark.parametrize(
    "before, after, is_same",
    [
        ("int a = 1;  // one\n", "int a =\n   1;", True),
        ("#define A b\nc\n", "#define A b c\n", False),
        ('f("//x");', 'f("//y");', False),
        ("f('\"'); // a\n", "f('\"'); /* b */", True),
        ("a & &b", "a && b", False),
        ('R"(// a)" + 1', 'R"(// b)" + 1', False),
        ("int x = 1'000; // a'b\n", "int x = 1'001; // a'b\n", False),
    ],
)
def test_words_of_cpp(tmp_path, before, after, is_same):
    digests = []
    for name, text in (("a.hpp", before), ("b.hpp", after)):
        (tmp_path / name).write_text(text)
        digests.append(sources.words_digest(tmp_path / name))
    assert (digests[0] == digests[1]) is is_same


PYTHON = """
class Empty: pass

def function(a, /, *, b=None, **more):
    values = [f"{a!r:>{b}}" "text", *[], {None: ()}, {**more}, a[1:2, 0], u"x"]
    return values, lambda: (yield), type(values)()
"""


def test_words_of_python_are_those_of_each_of_its_releases(tmp_path):
    """What ast.dump writes has changed from 3.11 to 3.13."""
    (tmp_path / "a.py").write_text(PYTHON)
    assert sources.words_digest(tmp_path / "a.py").startswith("a1d47dbc0dfcccf2")
    (tmp_path / "b.py").write_text(PYTHON.replace("None: ()", "None: None"))
    assert sources.words_digest(tmp_path / "b.py") != sources.words_digest(tmp_path / "a.py")
