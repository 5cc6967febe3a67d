# SPDX-License-Identifier: Apache-2.0
"""What was built is found again by the content of its files only, and runs side by side do not disturb each other."""

import multiprocessing
import os
import threading

import pytest

from flow.base import builds, ghdl, locks
from flow.base.errors import FlowError


def build(root, file, made=None, text="option"):
    def make(folder, sources):
        (folder / "made").write_text(sources[0].read_text())
        if made is not None:
            made.append(folder)

    return builds.build_once(root, [file], [], text, make)


def test_the_content_decides(tmp_path):
    file, made = tmp_path / "core.vhd", []
    file.write_text("good")
    first = build(tmp_path / "root", file, made)
    time = file.stat().st_mtime
    file.write_text("evil")  # as long
    os.utime(file, (time, time))
    second = build(tmp_path / "root", file, made)
    assert (first.is_new, second.is_new) == (True, True) and first.folder != second.folder
    assert (second.folder / "made").read_text() == "evil"
    file.rename(tmp_path / "elsewhere")
    (tmp_path / "new").mkdir()
    (tmp_path / "new" / "core.vhd").write_text("good")
    third = build(tmp_path / "root", tmp_path / "new" / "core.vhd", made)
    assert not third.is_new and third.folder == first.folder and len(made) == 2
    assert build(tmp_path / "root", tmp_path / "new" / "core.vhd", made, "another").is_new


def test_a_maker_that_changes_builds_again(tmp_path):
    (tmp_path / "core").write_text("core")
    (tmp_path / "bench").write_text("1")
    for expected in (True, False):
        made = builds.build_once(tmp_path / "root", [tmp_path / "core"], [tmp_path / "bench"], 0, lambda *_: None)
        assert made.is_new is expected
    (tmp_path / "bench").write_text("2")
    assert builds.build_once(tmp_path / "root", [tmp_path / "core"], [tmp_path / "bench"], 0, lambda *_: None).is_new


def test_what_failed_is_not_there(tmp_path):
    (tmp_path / "core").write_text("core")

    def fail(folder, sources):
        raise FlowError(f"{sources[0]}: error", 4)

    for _ in range(2):
        with pytest.raises(FlowError, match=f"^{tmp_path / 'core'}: error$"):
            builds.build_once(tmp_path / "root", [tmp_path / "core"], [], 0, fail)
    assert build(tmp_path / "root", tmp_path / "core", text=0).is_new


class Kept(Exception):
    """Its traceback keeps the frames of a build that broke off, as pytest and a debugger do."""


@pytest.mark.parametrize("error", [FlowError("no", 4), Kept(), KeyboardInterrupt()])
def test_a_build_that_fails_twice_does_not_wait_for_itself(tmp_path, error):
    (tmp_path / "core").write_text("core")

    def fail(folder, sources):
        raise error

    def twice():
        kept = []
        for _ in range(2):
            try:
                builds.build_once(tmp_path / "root", [tmp_path / "core"], [], 0, fail)
            except BaseException as raised:
                kept.append(raised)
        os._exit(0 if len(kept) == 2 else 1)

    process = multiprocessing.get_context("fork").Process(target=twice)
    process.start()
    process.join(20)
    if process.is_alive():
        process.kill()
    assert process.exitcode == 0, "the second build waits for the first"


def hold(path, kind, ready, done):
    with locks.Lock(path) as lock:
        lock.take(kind)
        ready.set()
        done.wait(20)


@pytest.mark.parametrize("kind", [locks.SHARED, locks.EXCLUSIVE])
@pytest.mark.parametrize("name", ["a folder", "file.lock"])
def test_a_wait_that_lasts_says_for_whom(tmp_path, monkeypatch, capfd, kind, name):
    path = tmp_path / name
    if name == "a folder":
        path.mkdir()
    monkeypatch.setattr(locks, "PATIENCE_SECONDS", 0.2)
    context = multiprocessing.get_context("fork")
    ready, done = context.Event(), context.Event()
    holder = context.Process(target=hold, args=(path, kind, ready, done))
    holder.start()
    assert ready.wait(20)
    threading.Timer(1, done.set).start()
    with locks.exclusive(path):
        pass
    holder.join()
    said = capfd.readouterr().err.splitlines()
    assert len(said) == 1 and said[0].startswith(f"{locks.NOTICE}{path}, which process {holder.pid} (")
    with locks.exclusive(path):
        pass
    assert capfd.readouterr().err == "", "a short wait is not told"


def test_a_lock_is_given_back_on_every_way_out(tmp_path):
    for error in (FlowError("no"), KeyboardInterrupt()):
        with pytest.raises(type(error)), locks.exclusive(tmp_path / "lock"):
            raise error
        with locks.Lock(tmp_path / "lock") as lock:
            assert lock.take_at_once()


def test_only_folders_that_nobody_uses_are_removed(tmp_path):
    file, held = tmp_path / "core", []
    for number in range(2 * builds.KEPT):
        file.write_text(str(number))
        held.append(build(tmp_path / "root", file))
    assert all((one.folder / "made").is_file() for one in held)
    held = held[:1]
    file.write_text("last")
    build(tmp_path / "root", file)
    assert (held[0].folder / "made").is_file()
    assert len(list((tmp_path / "root").glob("*/made"))) <= builds.KEPT + 1
    assert len(list((tmp_path / "root").glob("*.lock"))) <= builds.KEPT + 1


def build_and_look(root, file, failures):
    for _ in range(40):
        made = build(root, file)
        if (made.folder / "made").read_text() != file.read_text():
            failures.put(f"{file.name}: another content")


def test_many_processes_at_once(tmp_path):
    """More contents than are kept, so that folders come and go all the time."""
    context = multiprocessing.get_context("fork")
    failures = context.Queue()
    workers = []
    for number in range(3 * builds.KEPT):
        file = tmp_path / str(number % (2 * builds.KEPT)) / "core"
        file.parent.mkdir(exist_ok=True)
        file.write_text(f"content {number % (2 * builds.KEPT)}")
        workers.append(context.Process(target=build_and_look, args=(tmp_path / "root", file, failures)))
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert failures.empty(), failures.get()
    assert [worker.exitcode for worker in workers] == [0] * len(workers)


def test_one_run_at_a_time_writes_into_a_folder(tmp_path):
    context = multiprocessing.get_context("fork")

    def count():
        for _ in range(20):
            with locks.exclusive(tmp_path):
                file = tmp_path / "count"
                value = int(file.read_text()) if file.is_file() else 0
                file.write_text(str(value + 1))

    workers = [context.Process(target=count) for _ in range(4)]
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    assert (tmp_path / "count").read_text() == "80"


@pytest.mark.parametrize("generator", ["mcode", "llvm 14.0.6"])
def test_what_one_code_generator_of_ghdl_built_is_not_taken_for_another(tmp_path, monkeypatch, generator):
    program = tmp_path / "ghdl"
    program.write_text(f"#!/bin/sh\necho 'GHDL 2.0.0'\necho ' Compiled with X'\necho ' {generator} code generator'\n")
    program.chmod(0o755)
    monkeypatch.setenv("GHDL", str(program))
    assert ghdl.full_version() == f"GHDL 2.0.0, {generator} code generator"
