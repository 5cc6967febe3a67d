# SPDX-License-Identifier: Apache-2.0
"""Whether sources still say what they said when VHDL was made of them, in two steps: the same words without comments;
else the same intermediate code of clang, whose front end is Bambu's, without the names of C++."""

from __future__ import annotations

import ast
import hashlib
import re
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import TypedDict

from ..base.errors import FlowError
from ..base.tools import ROOT, find_tool, run

_CPP = re.compile(
    r"//[^\n]*|/\*.*?\*/"  # comments
    r"|((?:u8|[uUL])?R\"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'"
    r"|\d[\w.']*|\w+|\n"
    r"|&&|\|\||\+\+|--|<<|>>|->|::|\.\.\.|##|[-=!<>+*/%&|^]=|[^\s\w])",
    re.DOTALL,
)
_DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
# Names of the file and of the compiler, which say nothing of the code.
_NO_CODE = re.compile(r"^(; ModuleID|source_filename|!llvm\.ident|!\d+ = !\{!\"[^\"]*clang version).*\n", re.MULTILINE)
# Names of C++ types, functions and objects; those of the top and of its ports are C.
_CPP_NAME = re.compile(
    r"%\"(?:struct|class|union)\.[^\"]*\"|%(?:struct|class|union)\.[\w.]+|[@$]_Z[\w.]+|[@$]\"_Z[^\"]*\""
)


class Code(TypedDict, total=False):
    """What clang makes of the hardware top with its first optimisations, which leave nothing of the configuration but
    its numbers; empty where it was not there."""

    compiler: str
    digest: str  # without the names of C++
    interface: str  # of the pragmas of the top, which are not in clang's code


def words_digest(path: Path) -> str:
    """SHA-256 of the words of a C++ or Python file: comments, blanks and docstrings do not count."""
    return _words_digest(path.suffix, path.read_bytes())


@cache
def _words_digest(suffix: str, content: bytes) -> str:
    text = content.decode()
    words = _python_words(text) if suffix == ".py" else "\0".join(_cpp_words(text))
    return hashlib.sha256(words.encode()).hexdigest()


def _python_words(text: str) -> str:
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, _DOCUMENTED) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:]
        if isinstance(node, ast.JoinedStr):  # Python 3.12 has an empty text behind the last value of a format
            node.values = [value for value in node.values if getattr(value, "value", None) != ""]
    return _plain(tree)


def _plain(node: object) -> str:
    """As ast.dump, whose text differs from one release of Python to the next: here, what is empty is left out."""
    if isinstance(node, ast.AST):
        fields = ((name, getattr(node, name, None)) for name in node._fields)
        shown = [f"{name}={_plain(value)}" for name, value in fields if value is not None and value != []]
        return f"{type(node).__name__}({', '.join(shown)})"
    if isinstance(node, list):
        return f"[{', '.join(map(_plain, node))}]"
    return repr(node)


def _cpp_words(text: str) -> Iterable[str]:
    """The end of a line counts behind a directive only."""
    directive, at_start = False, True
    for match in _CPP.finditer(text.replace("\\\n", " ")):
        word = match[1]
        if word == "\n":
            if directive:
                yield word
            directive, at_start = False, True
        elif word:
            directive = directive or (at_start and word == "#")
            at_start = False
            yield word


def find_clang() -> str:
    return find_tool("clang++-16", "CLANG", "on Debian 12: apt-get install clang-16")


def code(options: Sequence[str]) -> Code:
    """Of the hardware top that `options` compile, its file first, in the project's root. Empty where there is no
    clang."""
    try:
        clang = find_clang()
    except FlowError:
        return {}
    text = run([clang, *options, "-O1", "-S", "-emit-llvm", "-Wno-everything", "-o", "-"], cwd=ROOT)
    pragmas = [line for line in (ROOT / options[0]).read_text().splitlines() if line.startswith("#pragma HLS")]
    return {
        "compiler": run([clang, "--version"]).splitlines()[0],
        "digest": hashlib.sha256(without_names(text).encode()).hexdigest(),
        "interface": hashlib.sha256("\n".join(pragmas).encode()).hexdigest(),
    }


def without_names(code: str) -> str:
    """The intermediate code with the names of C++ replaced by their order."""
    order: dict[str, str] = {}
    return _CPP_NAME.sub(lambda name: order.setdefault(name[0], f"{name[0][0]}{len(order)}"), _NO_CODE.sub("", code))


def is_same_code(then: Code, options: Sequence[str]) -> bool:
    """Whether clang makes the same of the sources as when `then` was kept; False where nobody can tell, or where they
    do not compile."""
    try:
        return bool(then) and code(options) == then
    except FlowError:
        return False
