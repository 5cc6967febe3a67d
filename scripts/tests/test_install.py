# SPDX-License-Identifier: Apache-2.0
"""cmake --install: the program runs from its new place, a project of one's own finds the cores' headers, and the VHDL
is complete."""

from pathlib import Path

import pytest

from flow.base.tools import ROOT, find_stereo_hls, run

PROJECT = """\
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
find_package(stereo_hls REQUIRED)
add_executable(consumer main.cpp)
target_link_libraries(consumer PRIVATE stereo_hls::cores)
"""
SOURCE = """\
#include <cstdio>
#include "block_matching/family.hpp"
#include "engines/clocked/heap_memories.hpp"
int main() {
   stereo::HeapMemories memories;
   stereo::block_matching::Core<stereo::block_matching::configurations::tiny> core(memories);
   int disparities = 0;
   for (int clock = 0; clock < 1000; ++clock, disparities += core.output().valid)
      core.clock({.left = {9}, .right = {9}, .start_of_frame = clock % 384 == 0, .valid = true});
   std::printf("%d\\n", disparities);
}
"""


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("prefix") / "usr"
    run(["cmake", "--install", Path(find_stereo_hls()).parent, "--prefix", folder])
    return folder


def test_the_program_runs_from_there(prefix, tmp_path):
    program = prefix / "bin" / "stereo_hls"
    assert program.is_symlink() and program.resolve().is_relative_to(prefix.resolve())
    assert run([program, "--version"]) == run([find_stereo_hls(), "--version"])
    installed = {path.stem for path in (prefix / "lib" / "stereo_hls" / "cores").glob("*.so")}
    built = {path.stem for path in (Path(find_stereo_hls()).parent / "cores").glob("*.so")}
    assert installed == built
    assert "tiny" in built, "the target cores makes it"
    run([program, "trace", "--config", "tiny", "--clocks", 20, "--out", tmp_path])
    assert (tmp_path / "trace.txt").stat().st_size > 0


def test_a_project_finds_the_headers(prefix, tmp_path):
    (tmp_path / "CMakeLists.txt").write_text(PROJECT)
    (tmp_path / "main.cpp").write_text(SOURCE)
    run(["cmake", "-S", tmp_path, "-B", tmp_path / "build", f"-DCMAKE_PREFIX_PATH={prefix}"])
    run(["cmake", "--build", tmp_path / "build"])
    assert int(run([tmp_path / "build" / "consumer"])) > 0


def test_the_vhdl_is_all_there(prefix):
    data = prefix / "share" / "stereo_hls"
    for folder, pattern in (("generated_rtl", "*.vhd"), ("generated_rtl", "manifest.json"), ("hls/rtl", "*.vhd")):
        source = ROOT / folder
        expected = {path.relative_to(source): path.read_bytes() for path in source.rglob(pattern)}
        target = data / source.name
        assert expected and {path.relative_to(target): path.read_bytes() for path in target.rglob(pattern)} == expected
