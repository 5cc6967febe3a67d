# SPDX-License-Identifier: Apache-2.0
"""What a command says of its progress, and what it says where a Python package is missing."""

import os
import pty
import subprocess
import sys

import pytest

from flow.base import errors, progress
from flow.base.tools import ROOT, run

STEPS = "from flow.base import progress\nwith progress.bar('cores', 3, 'clocks') as bar:\n"
STEPS += "    bar.show(1)\n    bar.say('one differs')\n    bar.show(3, 'all of them')\n"


def test_nothing_is_drawn_where_nobody_watches(capsys):
    with progress.bar("cores", 3) as bar:
        bar.show(2, "half of them")
        bar.say("one differs")
    assert capsys.readouterr().out == "one differs\n"


def test_a_terminal_shows_a_bar():
    pytest.importorskip("rich", reason="SKIP: python3-rich is not installed")
    ours, theirs = pty.openpty()
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "scripts"), "TERM": "xterm", "COLUMNS": "100"}
    subprocess.run([sys.executable, "-c", STEPS], stdout=theirs, env=environment, check=True)
    os.close(theirs)
    shown = b""
    while True:
        try:
            part = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        shown += part
    os.close(ours)
    for words in (b"one differs", b"all of them", b"3/3", b"clocks"):
        assert words in shown, shown


def test_commands_start_without_what_only_some_of_them_need():
    """Loading it takes longer than all else that a command does before its work."""
    words = "import sys; sys.argv = ['x', '--help']; import cosim, synthesize, instantiate; "
    words += "print([name for name in ('rich', 'jinja2', 'numpy', 'matplotlib') if name in sys.modules])"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "scripts")}
    process = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, env=environment)
    assert process.stdout == "[]\n", process.stderr


def test_a_missing_package_is_one_sentence(tmp_path):
    """As in an interpreter that a version manager puts in front of the system's."""
    (tmp_path / "rich.py").write_text("raise ModuleNotFoundError(\"No module named 'rich'\", name='rich')")
    words = "from flow.base.errors import run_command; run_command(lambda: __import__('rich'))"
    environment = {**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{ROOT / 'scripts'}"}
    process = subprocess.run([sys.executable, "-c", words], capture_output=True, text=True, env=environment)
    assert process.returncode == errors.EXIT_MISSING_TOOL
    assert process.stderr.count("\n") == 1 and "the Python package rich is missing for /" in process.stderr
    assert "apt-get install python3-rich" in process.stderr


def test_a_log_grows_while_its_program_runs(tmp_path):
    """On standard output and on stderr, where nextpnr says how far it is; what is returned is standard output alone."""
    log, seen = tmp_path / "tool.log", tmp_path / "seen"
    wait = f"for i in $(seq 100); do [ -s {log} ] && break; sleep 0.05; done; cp {log} {seen}"
    for stream in ("1", "2"):
        output = run(["sh", "-c", f"echo far >&{stream}; {wait}; echo further"], log=log)
        assert seen.read_text() == "far\n" and log.read_text() == "far\nfurther\n"
        assert output == ("far\nfurther\n" if stream == "1" else "further\n")
