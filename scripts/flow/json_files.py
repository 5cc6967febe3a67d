# SPDX-License-Identifier: Apache-2.0
"""JSON from files that anyone may have damaged."""

import json
from pathlib import Path


def load(path):
    """The content of a JSON file. Raises OSError, or ValueError with one sentence on what cannot be read or written again."""
    try:
        content = json.loads(Path(path).read_text(encoding="utf-8"))
        json.dumps(content, ensure_ascii=False).encode()  # JSON can name halves of characters that no file can hold
    except RecursionError:
        raise ValueError("nested too deeply") from None
    return content
