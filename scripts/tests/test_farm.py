# SPDX-License-Identifier: Apache-2.0
"""Jobs on the workers of a Dask scheduler: a real one with two workers on this machine, of which one is ended in the
middle;
workers that are not like this machine; what is said where there is none."""

import csv
import json
import os
import signal
import subprocess
import sys
import time

import pytest

from conftest import need, where_reachable
from cover import with_slow
from flow.base import farm, venv
from flow.base.errors import FlowError
from flow.base.tools import ROOT
from flow_commands import call, refused

CONFIGS = ["tiny", "tiny_p2", "tiny_p4", "example"]


def failing(message):
    raise FlowError(message, 3)


@pytest.fixture(scope="module")
def python():
    """One that has Dask."""
    requirements = ROOT / farm.REQUIREMENTS
    return where_reachable(lambda: venv.ensure("venv-farm", requirements, "Dask")) / "python3"


class Cluster:
    def __init__(self, python, folder):
        self.python, self.folder, self.processes = python, folder, []
        file = folder / "scheduler.json"
        self.start("scheduler", "--port", "0", "--no-dashboard", "--scheduler-file", file)
        while not file.is_file() or not file.read_text():
            assert self.processes[0].poll() is None, (folder / "0.log").read_text()
            time.sleep(0.05)
        self.address = json.loads(file.read_text())["address"]

    def start(self, what, *words, environment=None):
        with (self.folder / f"{len(self.processes)}.log").open("w") as log:
            command = [self.python, "-m", "distributed.cli.dask_" + what, *words]
            variables = {**os.environ, **(environment or {})}
            made = subprocess.Popen(list(map(str, command)), stdout=log, stderr=log, cwd=self.folder, env=variables)
        self.processes.append(made)
        return made

    def worker(self, **environment):
        """A process without a nanny, which would start another one in its place."""
        words = ["--no-nanny", "--no-dashboard", "--nthreads", 1, "--local-directory", self.folder]
        log = self.folder / f"{len(self.processes)}.log"
        made = self.start("worker", self.address, *words, environment=environment)
        while "Registered to" not in log.read_text():
            assert made.poll() is None, log.read_text()
            time.sleep(0.05)
        return made

    def call(self, command, *words):
        command = [self.python, ROOT / "scripts" / command, *words, "--scheduler", self.address]
        return subprocess.run(list(map(str, command)), capture_output=True, text=True)

    def stop(self):
        for process in self.processes:
            process.kill()
            process.wait()


@pytest.fixture
def cluster(python, tmp_path):
    made = Cluster(python, tmp_path)
    yield made
    made.stop()


def test_no_result_is_lost_when_a_worker_ends(ghdl, cluster, tmp_path):
    """Of a regression: a worker is ended while it runs its first job, whichever of the two gets one first."""
    workers = [cluster.worker(), cluster.worker()]
    out = tmp_path / "out"
    words = ["--config", *CONFIGS, "--stimulus", "scene", "--out", out, "--scheduler", cluster.address]
    command = list(map(str, [cluster.python, ROOT / "scripts" / "cosim.py", *words]))
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    while not (busy := [worker for worker in workers if children(worker.pid)]):
        assert process.poll() is None, process.stdout.read()
        time.sleep(0.02)
    busy[0].send_signal(signal.SIGKILL)
    said = process.communicate(timeout=300)[0]
    assert process.returncode == 0, said
    summary = json.loads((out / "summary.json").read_text())
    assert {run["config"]: run["outcome"] for run in summary["runs"]} == dict.fromkeys(CONFIGS, "pass")
    assert summary["compared"] == summary["expected"] > 600


def children(number):
    """The cosim.py that a worker runs."""
    lines = subprocess.run(
        ["ps", "-ww", "-eo", "ppid,args"], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    return [line for line in lines if line.split()[0] == str(number) and "cosim.py" in line]


@pytest.mark.slow
def test_other_commands_run_there(cluster, tmp_path):
    cluster.worker()
    process = cluster.call("random_configurations.py", "--family", "absolute_difference", "--count", 2, "--seed", 1)
    assert process.returncode == 0 and "2 of 2 configurations exact" in process.stdout, process.stdout + process.stderr


@pytest.fixture
def two_workers(cluster):
    cluster.worker()
    cluster.worker()
    return cluster


@pytest.mark.slow
def test_two_workers_implement(ghdl, yosys, two_workers, tmp_path):
    words = ["--config", "tiny", "--config", "tiny_p2", "--target", "xc7", "--out", tmp_path / "out"]
    process = two_workers.call("implement.py", *words)
    assert process.returncode == 0, process.stdout + process.stderr
    made = {name: json.loads((tmp_path / "out" / name / "implementation.json").read_text()) for name in CONFIGS[:2]}
    luts = [entry["targets"]["xc7"]["luts"] for entry in made.values()]
    assert 0 < luts[0] < luts[1], made


def explored(folder):
    """The rows of a table, without what differs from run to run: times and, in the commands, folders."""
    with (folder / "explore.csv").open() as file:
        rows = list(csv.DictReader(file))
    return [{key: row[key] for key in row if key not in ("milliseconds", "command")} for row in rows]


@pytest.mark.slow
def test_two_workers_explore(two_workers, tmp_path):
    """The evaluations are those of this machine."""
    words = ["--scenes", 1, "--window", 3, 5, "--cost", "sad", "--range", 16, "--switch", "--config"]
    process = two_workers.call("explore.py", *words, "--out", tmp_path / "there")
    assert process.returncode == 0, process.stdout + process.stderr
    here = call("explore.py", *words, "--jobs", 2, "--out", tmp_path / "here")
    assert here.returncode == 0, here.stdout + here.stderr
    tables = [explored(tmp_path / name) for name in ("there", "here")]
    assert tables[0] == tables[1] and len(tables[0]) == 2


@pytest.mark.slow
def test_two_workers_synthesize(two_workers, tmp_path):
    need("bambu", "BAMBU")
    process = two_workers.call("synthesize.py", "--config", "example", "--config", "tiny", "--out", tmp_path / "out")
    assert process.returncode == 0, process.stdout + process.stderr
    for name in ("example", "tiny"):
        assert (tmp_path / "out" / name / f"stereo_core_{name}.vhd").read_text().count("architecture ") > 0


@pytest.mark.slow
def test_a_worker_with_another_tool_is_refused(ghdl, cluster, tmp_path):
    """A stand-in that says another version."""
    tool = tmp_path / "ghdl"
    tool.write_text("#!/bin/sh\necho GHDL 0.1 of yesterday\n")
    tool.chmod(0o755)
    cluster.worker(GHDL=str(tool))
    process = cluster.call("cosim.py", "--config", "tiny", "tiny_p2", "--out", tmp_path / "out")
    refused(process, 1, "has ghdl GHDL 0.1 of yesterday, this machine")


@pytest.mark.slow
def test_no_workers_are_said(cluster, tmp_path):
    process = cluster.call("cosim.py", "--config", "tiny", "tiny_p2", "--out", tmp_path / "out")
    refused(process, 3, "the scheduler has no workers")


ADDRESSES = [("nonsense://x", "is tcp://HOST:PORT"), ("tcp://localhost:1", "refused"), ("tcp://x:y", "Port")]


@pytest.mark.parametrize("address, why", with_slow(ADDRESSES, ADDRESSES[1:2]))
def test_no_scheduler_is_said(python, tmp_path, address, why):
    words = [python, ROOT / "scripts" / "cosim.py", "--config", "tiny", "tiny_p2", "--out", tmp_path]
    process = subprocess.run([*words, "--scheduler", address], capture_output=True, text=True)
    refused(process, 3, f"no scheduler answers at {address}: ", why)


def test_a_missing_package_is_said(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(FlowError, match="pip install -r scripts/requirements-farm.txt") as caught:
        farm.Farm(1, "tcp://localhost:1")
    assert caught.value.exit_code == 3


def test_threads_give_what_jobs_give():
    with farm.Farm(2) as workers:
        futures = [workers.submit(pow, 2, number) for number in range(10)]
        assert [farm.result_of(future) for future in futures] == [2**number for number in range(10)]
        with pytest.raises(FlowError, match="no such tool") as caught:
            farm.result_of(workers.submit(failing, "no such tool"))
    assert caught.value.exit_code == 3


def test_bad_options():
    refused(call("random_configurations.py", "--jobs", 0), 2, "--jobs: '0' is no whole number, 1 or more")
    refused(call("cosim.py", "--config", "tiny", "--scheduler", "tcp://x:1"), 2, "are for several configurations")
