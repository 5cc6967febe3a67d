# SPDX-License-Identifier: Apache-2.0
"""How every command of this project ends."""

from __future__ import annotations

import argparse
import difflib
import io
import os
import signal
import sys
from collections.abc import Callable, Iterable
from typing import Any, NoReturn

EXIT_OK = 0
EXIT_MISMATCH = 1  # the job ran, and its answer is no: outputs differ, or the VHDL is stale
EXIT_USAGE = 2  # wrong options or unusable input
EXIT_MISSING_TOOL = 3  # a program this step needs is not installed
EXIT_TOOL_FAILED = 4  # a tool crashed, hung, or gave something this flow does not understand
EXIT_INTERRUPTED = 128 + signal.SIGINT

EXIT_CODES_HELP = (
    "exit codes: 0 done, 1 the answer is no (outputs differ, nothing fits), 2 bad usage or input, 3 missing tool, "
    "4 a tool failed"
)


def alike(name: str, known: Iterable[str]) -> str:
    """A sentence that names those of the known names that may be meant; empty where there are none."""
    found = difflib.get_close_matches(name, sorted(known), cutoff=0.8)
    return f"did you mean {' or '.join(found)}?" if found else ""


class FlowError(Exception):
    """One sentence for the user and the exit code that goes with it."""

    def __init__(self, message: str, exit_code: int = EXIT_USAGE) -> None:
        super().__init__(message)
        self.exit_code = exit_code


class _Once(argparse.Action):
    """Takes the values of an option, which must not be given again: the last one would win without a word."""

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: object,
        option_string: str | None = None,
    ) -> None:
        assert isinstance(parser, ArgumentParser)
        if option_string and self.dest in parser.given:
            parser.error(f"{option_string} appears twice")
        parser.given.add(self.dest)
        setattr(namespace, self.dest, values)


class ArgumentParser(argparse.ArgumentParser):
    """argparse that says one sentence on stderr instead of the whole usage."""

    def __init__(self, prog: str, description: str | None) -> None:
        super().__init__(prog=prog, description=description, epilog=EXIT_CODES_HELP)
        self.given: set[str] = set()  # options of one value, so far
        self.register("action", None, _Once)
        self.register("action", "store", _Once)

    def parse_args(self, args: Any = None, namespace: Any = None) -> argparse.Namespace:  # type: ignore[override]
        self.given = set()
        parsed: argparse.Namespace = super().parse_args(args, namespace)
        return parsed

    def error(self, message: str) -> NoReturn:
        raise FlowError(f"{message} (see {self.prog} --help)")

    def refuse_beside(self, mode: str, *allowed: str) -> None:
        """Raises FlowError where the command line gives an option that has no effect beside the option `mode`.
        `allowed`: those that have one."""
        saved = {action: action.default for action in self._actions}
        try:
            for action in self._actions:
                action.default = argparse.SUPPRESS  # what is in the result was given
            given = vars(self.parse_args())
        finally:
            for action, default in saved.items():
                action.default = default
        for action in self._actions:
            option = action.option_strings[-1] if action.option_strings else action.dest
            if action.dest in given and option not in (mode, *allowed):
                raise FlowError(f"{option} has no effect beside {mode}")


def _interrupt(number: int, _: object) -> NoReturn:
    raise KeyboardInterrupt(number)


def run_command(main: Callable[[], int]) -> NoReturn:
    """Runs a command's main function and turns FlowError, OSError and a missing package into one line on stderr and
    the exit code."""
    program = sys.argv[0].rsplit("/", 1)[-1]
    signal.signal(signal.SIGTERM, _interrupt)  # of `timeout` or a CI service: what we started ends with us
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")  # names of files need not be text
    try:
        if sys.stdout is None:
            raise FlowError("standard output is closed")
        code = main()
        sys.stdout.flush()
        sys.exit(code)
    except FlowError as error:
        print(f"{program}: {error}", file=sys.stderr)
        sys.exit(error.exit_code)
    except ModuleNotFoundError as error:
        print(
            f"{program}: the Python package {error.name} is missing for {sys.executable}; on Debian: apt-get install "
            f"python3-{error.name}, then /usr/bin/python3 {sys.argv[0]}; else: pip install {error.name}",
            file=sys.stderr,
        )
        sys.exit(EXIT_MISSING_TOOL)
    except BrokenPipeError:  # whoever read our output has seen enough, as `head` does
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())  # nothing is left to be flushed into the pipe
        sys.exit(128 + signal.SIGPIPE)
    except OSError as error:  # a file or folder that is not what the command needs
        print(f"{program}: {error.filename or 'a file'}: {error.strerror or error}", file=sys.stderr)
        sys.exit(EXIT_USAGE)
    except KeyboardInterrupt as interruption:
        print(f"{program}: interrupted", file=sys.stderr)
        sys.exit(128 + interruption.args[0] if interruption.args else EXIT_INTERRUPTED)
