# SPDX-License-Identifier: Apache-2.0
"""hls/rtl/registers.json against the settings that the cores have (hls/FAMILY/settings.hpp)."""

import pytest

from flow.base import rtl
from flow.base.configurations import designs
from flow.shell import registers


def settings_by_family():
    """{family: {setting: bits of its port}}, of all configurations; the families without settings are left out."""
    found = {}
    for row in designs().values():
        settings = {setting.name: setting.bits for setting in rtl.settings_of(row)}
        if settings:
            found.setdefault(row["family"], {}).update(settings)
    return found


def value_bits(family):
    """{register of a setting: bits of its value}"""
    found = {}
    for register in registers.description_of(family):
        fields = {field["name"]: field for field in register.get("fields", [])}
        if "largest" in fields:
            found[register["name"]] = fields["value"]["high"] - fields["value"]["low"] + 1
    return found


FAMILIES = settings_by_family()


def test_families_have_settings():
    assert len(FAMILIES) >= 4


@pytest.mark.parametrize("family", sorted(FAMILIES))
def test_each_setting_is_a_register_that_holds_it(family):
    registered = value_bits(family)
    assert {name for name, bits in FAMILIES[family].items() if bits <= registered.get(name, 0)} == set(FAMILIES[family])


@pytest.mark.parametrize("family", sorted(FAMILIES))
def test_each_register_of_a_family_is_one_of_its_settings(family):
    named = {register["name"] for register in registers.description() if register.get("family") == family}
    assert named <= set(FAMILIES[family])


def test_each_register_of_a_setting_is_one_of_some_family():
    assert set(registers.settings()) == set().union(*FAMILIES.values())


@pytest.mark.parametrize("family", sorted(FAMILIES))
def test_each_setting_has_an_address_of_its_own(family):
    offsets = [r["offset"] for r in registers.description_of(family) if r["name"] in FAMILIES[family]]
    assert len(offsets) == len(set(offsets)) == len(FAMILIES[family])
