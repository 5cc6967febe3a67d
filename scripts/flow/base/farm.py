# SPDX-License-Identifier: Apache-2.0
"""Where independent jobs run: in threads of this machine, or on the workers of a Dask scheduler (docs/farms.md). A job
is a function of a module of flow/ with its arguments; what it reads and writes stands in a folder that all workers see
at the same path. A job whose worker dies runs again on another one."""

from __future__ import annotations

import hashlib
import pickle
import socket
import subprocess
import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor, as_completed
from functools import cache
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import urlsplit

from .errors import EXIT_MISMATCH, EXIT_MISSING_TOOL, EXIT_OK, EXIT_TOOL_FAILED, FlowError
from .options import one_or_more
from .tools import ROOT, find_stereo_hls

Result = TypeVar("Result")
Versions = Callable[[], "dict[str, str]"]  # {tool: its version}, of a module of flow/

REQUIREMENTS = "scripts/requirements-farm.txt"
SECONDS_TO_CONNECT = 20
_running: set[subprocess.Popen[bytes]] = set()  # in this process, of `run_logged`


def add_options(parser: ArgumentParser, jobs: int, what: str) -> None:
    parser.add_argument(
        "--jobs", type=one_or_more, default=jobs, metavar="N", help=f"{what} at a time on this machine (default {jobs})"
    )
    parser.add_argument(
        "--scheduler",
        metavar="ADDRESS",
        help=f"run on the workers of this Dask scheduler, such as tcp://host:8786 (docs/farms.md; {REQUIREMENTS})",
    )


def no_tools() -> dict[str, str]:
    return {}


def of(options: Namespace, versions: Versions = no_tools) -> Farm:
    """`versions`: of the tools that the jobs call, which must be the same on each worker."""
    return Farm(options.jobs, options.scheduler, versions)


class Farm:
    """`with Farm(...) as farm:`"""

    def __init__(self, jobs: int, scheduler: str | None = None, versions: Versions = no_tools) -> None:
        self.jobs, self._versions = jobs, versions
        self._client = None if scheduler is None else _connect(scheduler)
        self._pool: Any = ThreadPoolExecutor(jobs) if self._client is None else self._client.get_executor(pure=False)
        self._waited_for: set[Future[Any]] = set()
        if self._client is not None:
            self._facts = facts(versions)
            self._check_workers()

    def __enter__(self) -> Farm:
        return self

    def __exit__(self, kind: type | None, *_: object) -> None:
        if kind is not None:
            self.stop()
        self._pool.shutdown(wait=self._client is None)
        if self._client is not None:
            self._client.close()

    @property
    def threads(self) -> int:
        """That hand out jobs by `call`: so many that no worker waits."""
        return self.jobs if self._client is None else max(2 * sum(self._client.nthreads().values()), 1)

    def submit(self, function: Callable[..., Result], *arguments: Any) -> Future[Result]:
        """A job. `result_of` gives what it returns."""
        made: Future[Result]
        if self._client is None:
            made = self._pool.submit(function, *arguments)
        else:
            job = pickle.dumps((self._versions, function, arguments))
            made = self._pool.submit(_worker_side(), str(ROOT), self._facts, job)
        self._waited_for.add(made)
        made.add_done_callback(self._waited_for.discard)
        return made

    def call(self, function: Callable[..., Result], *arguments: Any) -> Result:
        """A job, waited for: of a thread that does other things before and behind it."""
        return function(*arguments) if self._client is None else result_of(self.submit(function, *arguments))

    def stop(self) -> None:
        """Nothing begins any more; what has begun ends where it runs on this machine."""
        for future in list(self._waited_for):
            future.cancel()
        for process in list(_running):
            process.terminate()

    def _check_workers(self) -> None:
        """Refuses workers that are none or not like this machine."""
        assert self._client is not None
        try:
            found = self._client.run(
                _worker_side(), str(ROOT), None, pickle.dumps((no_tools, facts, (self._versions,)))
            )
        except RuntimeError as error:
            raise FlowError(str(error), EXIT_MISMATCH) from None
        if not found:
            raise FlowError("the scheduler has no workers", EXIT_MISSING_TOOL)
        for worker, theirs in sorted(found.items()):
            _check(self._facts, theirs, worker)


def result_of(future: Future[Result]) -> Result:
    """Of a job. Raises FlowError where the workers that ran it died."""
    try:
        return future.result()
    except FlowError:
        raise
    except CancelledError:
        raise FlowError("the job was cancelled, or the scheduler is gone", EXIT_TOOL_FAILED) from None
    except Exception as error:
        if type(error).__module__.partition(".")[0] != "distributed":
            raise
        raise FlowError(f"the farm gave up on a job: {type(error).__name__}: {error}", EXIT_TOOL_FAILED) from None


def _connect(address: str) -> Any:
    try:
        import distributed
    except ImportError as error:
        raise FlowError(
            f"--scheduler needs the Python package {error.name}; {sys.executable} -m pip install -r {REQUIREMENTS}",
            EXIT_MISSING_TOOL,
        ) from None
    try:
        place = urlsplit(address)
        if place.scheme not in ("tcp", "tls") or not place.hostname or not place.port:
            raise ValueError("an address is tcp://HOST:PORT or tls://HOST:PORT")
        socket.create_connection((place.hostname, place.port), SECONDS_TO_CONNECT).close()
        return distributed.Client(address, timeout=SECONDS_TO_CONNECT, set_as_default=False)
    except (OSError, ValueError) as error:
        raise FlowError(f"no scheduler answers at {address}: {error}", EXIT_MISSING_TOOL) from None


def _worker_side() -> Callable[[str, dict[str, str] | None, bytes], Any]:
    """What runs on a worker: it makes the modules of flow/ known, compares what the worker has, and runs the job. It
    has no name to be imported by, so that it is sent as code: the scheduler does not know flow/."""

    def work(root: str, expected: dict[str, str] | None, job: bytes) -> Any:
        import pickle
        import sys
        from pathlib import Path

        scripts = Path(root) / "scripts"
        if not scripts.is_dir():
            raise RuntimeError(f"this worker has no {root}: the folder must stand at the same path on all")
        if str(scripts) not in sys.path:
            sys.path.insert(0, str(scripts))
        from flow.base import farm

        versions, function, arguments = pickle.loads(job)
        if expected is not None:
            farm._check(expected, farm.facts(versions), "a worker")
        return function(*arguments)

    return work


@cache
def facts(versions: Versions) -> dict[str, str]:
    """What must be the same on all machines: the sources of the flow, the native program, the tools."""
    digest = hashlib.sha256()
    for path in sorted((ROOT / "scripts").rglob("*.py")):
        digest.update(path.read_bytes())
    found = {"scripts/": digest.hexdigest()[:12]}
    try:
        found["stereo_hls"] = hashlib.sha256(Path(find_stereo_hls()).read_bytes()).hexdigest()[:12]
    except FlowError:
        found["stereo_hls"] = "none"
    return found | versions()


def _check(ours: dict[str, str], theirs: dict[str, str], worker: str) -> None:
    for name, version in ours.items():
        if theirs.get(name) != version:
            raise FlowError(f"{worker} has {name} {theirs.get(name)}, this machine {version}", EXIT_MISMATCH)


def run_each(workers: Farm, script: str, commands: Mapping[str, Sequence[str]], logs: Path) -> int:
    """A command of scripts/ for each name, with what each prints when it ends; the highest exit code. Those behind one
    that fails run all the same."""
    futures = {
        workers.submit(run_logged, [str(ROOT / "scripts" / script), *words], logs / f"{name}.log"): name
        for name, words in commands.items()
    }
    codes = [EXIT_OK]
    for future in as_completed(futures):
        try:
            codes.append(result_of(future))
            print((logs / f"{futures[future]}.log").read_text(), end="", flush=True)
        except FlowError as error:
            codes.append(error.exit_code)
            print(f"{futures[future]}: {error}", flush=True)
    return max(codes)


def run_logged(command: Sequence[str], log: Path) -> int:
    """A command of this project with what it prints in a file; its exit code. `command`: without the Python."""
    log.parent.mkdir(parents=True, exist_ok=True)
    with (
        log.open("w") as copy,
        subprocess.Popen(
            [sys.executable, *command], stdin=subprocess.DEVNULL, stdout=copy, stderr=subprocess.STDOUT
        ) as process,
    ):
        _running.add(process)
        try:
            return process.wait()
        finally:
            _running.discard(process)
