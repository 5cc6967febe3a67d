#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Run pytest files for ctest: exit code 0 passed, 77 all skipped, else failed (no test at all is a failure).

Cases that skipped themselves in a file that passed are named in lines SKIPPED CASE, and in the file STEREO_SKIPPED; so
are those that fail as expected, for they tell of a missed aim. The file STEREO_TIMES gets the processor time of the
test STEREO_TEST, with that of all that it has started."""

import os
import resource
import sys

SKIPPED = 77


class Tally:
    """Counts how the tests ended, as pytest's exit code does not tell a skipped run from a passed one."""

    def __init__(self):
        self.passed = 0
        self.skipped = []  # reasons
        self.cases = []  # (name, reason) of each

    def _record_skip(self, report):
        reason = report.longrepr[2] if isinstance(report.longrepr, tuple) else str(report.longrepr)
        reason = reason.removeprefix("Skipped: ")
        self.skipped.append(reason)
        self.cases.append((report.nodeid.rpartition("/")[2], reason.removeprefix("SKIP: ")))

    def pytest_runtest_logreport(self, report):
        if hasattr(report, "wasxfail"):  # pytest counts it as skipped, but it ran
            self.passed += 1
            self.cases.append((report.nodeid.rpartition("/")[2], f"fails as expected: {report.wasxfail}"))
        elif report.skipped:
            self._record_skip(report)
        elif report.when == "call" and report.passed:
            self.passed += 1

    def pytest_collectreport(self, report):
        if report.skipped:
            self._record_skip(report)


def main():
    if len(sys.argv) < 2 or sys.argv[1] in ("-h", "--help"):
        print(f"usage: {sys.argv[0]} FILE... (files and options of pytest)\n{__doc__}")
        return 0 if len(sys.argv) >= 2 else 2
    try:
        import pytest
    except ImportError:
        print(f"SKIP: the Python package pytest is missing for {sys.executable}")
        return SKIPPED
    tally = Tally()
    code = int(pytest.main(["-q", "-rs", "-p", "no:cacheprovider", *sys.argv[1:]], plugins=[tally]))
    write_time()
    none_ran = code in (pytest.ExitCode.OK, pytest.ExitCode.NO_TESTS_COLLECTED) and tally.passed == 0
    if none_ran and tally.skipped:
        for reason in dict.fromkeys(tally.skipped):
            print(f"SKIP: {reason}")
        return SKIPPED
    for case, reason in tally.cases:
        print(f"SKIPPED CASE: {case}: {reason}")
    write_skipped(tally.cases)
    return code


def write_skipped(cases):
    append("STEREO_SKIPPED", (f"{case}: {reason}\n" for case, reason in cases))


def write_time():
    used = [resource.getrusage(whose) for whose in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    seconds = sum(one.ru_utime + one.ru_stime for one in used)
    append("STEREO_TIMES", [f"{seconds:.1f} {os.environ.get('STEREO_TEST', sys.argv[-1])}\n"])


def append(variable, lines):
    """To the file that a variable names, from which scripts/test.sh makes its summary. One line at a time: tests run
    side by side."""
    path = os.environ.get(variable)
    if path:
        with open(path, "a", buffering=1) as file:
            file.writelines(lines)


if __name__ == "__main__":
    sys.exit(main())
