# SPDX-License-Identifier: Apache-2.0
"""Files that are there whole or as they were before."""

import os
import tempfile
from pathlib import Path

from .errors import FlowError


def write(path, content):
    """The whole file or none. `content`: text, or bytes."""
    path, temporary = Path(path), None
    data = content.encode() if isinstance(content, str) else content
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("wb", dir=path.parent, prefix=f".{path.name}.", delete=False) as file:
            temporary = Path(file.name)
            file.write(data)
        temporary.chmod(0o644)
        os.replace(temporary, path)
    except OSError as error:
        if temporary is not None:
            temporary.unlink(missing_ok=True)
        raise FlowError(f"cannot write {path}: {error.strerror}") from None
