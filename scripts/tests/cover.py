# SPDX-License-Identifier: Apache-2.0
"""A few configurations that stand for all in the fast set of the tests: together they have every option that any
has."""

import pytest

BY_VALUE = {"pixels_per_clock"}  # numbers that are choices


def choices(row):
    """What of a configuration a test should meet: each option that is not its family's default, of a number whatever it
    is."""
    found = set()
    for option in row["options"]:
        name, _, value = option.partition(" ")
        is_number = value.lstrip("-").isdigit() and name not in BY_VALUE
        found.add((row["family"], name if is_number else option))
    return found


def cover(table):
    """The names of so few rows as a greedy choice finds, each time the one with most of what is left."""
    left, chosen = set().union(*map(choices, table.values())), []
    while left:
        chosen.append(max(sorted(table), key=lambda name: len(choices(table[name]) & left)))
        left -= choices(table[chosen[-1]])
    return chosen


def with_slow(values, fast):
    """Parameters of a test, a tuple where it has several: those that are not in `fast` run only in the slow set."""
    assert all(value in values for value in fast), "what is not there is no guard"

    def slow(value):
        return pytest.param(*(value if isinstance(value, tuple) else (value,)), marks=pytest.mark.slow)

    return [value if value in fast else slow(value) for value in values]
