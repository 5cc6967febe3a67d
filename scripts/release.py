#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check-list of a release. Refuses when the tree is not clean, the changelog has no entry for the version, a link
is broken, a page or core is stale, or the tests of .ci/run did not all pass at this commit or were skipped without a
reason. Run .ci/run first. Changes nothing."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
from flow.base.errors import EXIT_MISMATCH, EXIT_OK, ArgumentParser, FlowError, run_command
from flow.release import conditions


def main() -> int:
    ArgumentParser(prog="release.py", description=__doc__).parse_args()
    refused = 0
    for name, condition in conditions.CONDITIONS:
        found = condition()
        print(f"{'REFUSED' if found else 'ok':8} {name}", flush=True)
        for sentence in found:
            print(f"         {sentence}")
        refused += bool(found)
    if refused:
        raise FlowError(f"no release: {refused} of {len(conditions.CONDITIONS)} conditions do not hold", EXIT_MISMATCH)
    version = conditions.version()
    print(f'ready: git tag -a v{version} -m "{version}"')
    return EXIT_OK


if __name__ == "__main__":
    run_command(main)
