# SPDX-License-Identifier: Apache-2.0
"""What the tests of camera systems play and compare."""

import random
import re

from flow.system import play, streams, template


def played(simulation, scene, out, pairs=None, **conditions):
    """Frames without faults; `conditions`: of streams.streams, and `sink`."""
    sink = conditions.pop("sink", 0)
    left, right = streams.streams(scene.pairs[:pairs], random.Random(1), **conditions)
    return simulation.play(play.table_writes(scene.tables, scene.depths), left, right, out, (sink, 3))


def check_all_exact(seen, frames):
    assert [shown.error for shown in seen.frames] == [False] * len(frames)
    for number, (shown, words) in enumerate(zip(seen.frames, frames)):
        assert shown.words == words, f"frame {number}"


def changed(system, path, pattern, replacement, folder):
    """The files of a system, one of them with a fault."""
    text, count = re.subn(pattern, replacement, path.read_text(), count=1)
    assert count == 1
    (folder / path.name).write_text(text)
    return [folder / path.name if file == path else file for file in template.vhdl_files(system)]
