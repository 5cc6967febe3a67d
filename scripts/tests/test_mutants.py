# SPDX-License-Identifier: Apache-2.0
"""How mutants are made and counted; no simulator needed."""

import json
from itertools import islice
from pathlib import Path

import pytest

from flow.base.tools import ROOT
from flow.mutation import arguments, mutants, run
from flow.mutation.equivalence import NotSynthesizedError
from flow_commands import call, refused

TEXT = """-- SPDX-License-Identifier: Apache-2.0
entity e is
  port (a : in std_logic);
end entity;
architecture rtl of e is
begin
  process (clock)
  begin
    if rising_edge(clock) and a = '1' then  -- and not b
      count <= count + 1;
      row_0 <= row_1;
      row_1 <= row_2;
    end if;
  end process;
  b <= not a when count < 3 else '0';
end architecture;
"""


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "e.vhd"
    path.write_text(TEXT)
    return path


def test_every_kind_of_fault_is_made(file):
    changes = {mutant.text.strip() for mutant in mutants.mutants_of(file)}
    for expected in (
        "count <= count - 1;",
        "count <= count + 2;",
        "null;",
        "row_0 <= row_2;",
        "if rising_edge(clock) and a /= '1' then",
        "if rising_edge(clock) or a = '1' then",
        "if rising_edge(clock) and a = '0' then",
        "b <= a when count < 3 else '0';",
        "if not (rising_edge(clock) and a = '1') then",
        "b <= not a when count <= 3 else '0';",
        "b <= not a when not (count < 3) else '0';",
        "b <= not a when count < 4 else '0';",
        "b <= not a when count < 3 else '1';",
    ):
        assert expected in changes, expected


@pytest.mark.parametrize(
    "old, new",
    [("x mod 512", "x mod 256"), ("x mod 2", "x mod 4"), ("x / 8", "x / 16"), ("x + 8", "x + 9"), ("x / 3", "x / 4")],
)
def test_a_number_becomes_its_neighbour(tmp_path, old, new):
    """Of a power of two that chooses bits: the next bit or width."""
    path = tmp_path / "e.vhd"
    path.write_text(f"architecture rtl of e is\nbegin\n  y <= {old};\nend architecture;\n")
    assert f"  y <= {new};" in {mutant.text for mutant in mutants.mutants_of(path)}


def test_declarations_and_comments_are_left_alone(file):
    lines = {mutant.line for mutant in mutants.mutants_of(file)}
    assert lines <= {8, 9, 10, 11, 14}
    assert not any("not b" in mutant.text for mutant in mutants.mutants_of(file))


def test_keys_are_unique_and_faults_single(file, tmp_path):
    found = list(mutants.mutants_of(file))
    assert len({mutant.key for mutant in found}) == len(found)
    for number, mutant in enumerate(found):
        changed = mutants.write(mutant, tmp_path / str(number)).read_text().splitlines()
        assert sum(a != b for a, b in zip(changed, TEXT.splitlines())) == 1


def test_same_seed_same_mutants(file):
    keys = [[mutant.key for mutant in islice(mutants.shuffled([file], seed), 8)] for seed in (1, 1, 2)]
    assert keys[0] == keys[1] != keys[2]
    assert len({mutant.kind for mutant in islice(mutants.shuffled([file], 1), 7)}) == 7


class Blind:
    """Tests that notice nothing but one mutant in ten."""

    count = 0
    stimulus = Path(__file__)  # of which the verdicts are

    def __init__(self, *stages):
        pass

    def noticed(self, *files_and_folder):
        Blind.count += 1
        return "a test" if Blind.count % 10 == 0 else ""


class Believer:
    """Takes one survivor in three for equivalent."""

    count = 0

    def __init__(self, *designs_and_files):
        pass

    def objection(self, *files_and_folder):
        Believer.count += 1
        return "" if Believer.count % 3 == 0 else "no proof"


@pytest.fixture
def blind(monkeypatch, tmp_path):
    for name in ("Core", "Shell"):
        monkeypatch.setattr(run, name, Blind)
    monkeypatch.setattr(run, "Prover", Believer)
    monkeypatch.setattr(run, "compiles", lambda files, folder: True)
    monkeypatch.setattr(run, "refuted", lambda mutant, folder: "")
    monkeypatch.setattr(run, "WORK", tmp_path / "work")
    return tmp_path


def test_every_mutant_is_killed_or_equivalent_or_has_survived(blind):
    said = []
    survived = run.Run([1], 20, 20, jobs=1, say=said.append).run().report(blind)
    report = json.loads((blind / "report.json").read_text())
    outcomes = [verdict["outcome"] for verdict in report["verdicts"]]
    assert report["mutants"] == len(outcomes) == 40
    assert report["killed"] == outcomes.count("killed") > 0
    assert report["equivalent"] == outcomes.count("equivalent") > 0
    assert len(report["survivors"]) == outcomes.count("survived") == survived > 0
    assert report["score_percent"] == 100 * (40 - survived) / 40
    for outcome in ("equivalent", "survived"):
        assert sum(line.startswith(outcome) for line in said) == outcomes.count(outcome)


@pytest.fixture
def proving(monkeypatch):
    """What no test notices is proved: what has survived is judged again."""
    monkeypatch.setattr(Believer, "objection", lambda self, *files_and_folder: "")


def test_verdicts_are_remembered(blind, proving):
    reports = []
    for _ in range(2):
        run.Run([1], 20, 20, jobs=1, say=lambda line: None).run().report(blind)
        reports.append(json.loads((blind / "report.json").read_text())["verdicts"])
        judged = Blind.count
    assert reports[0] == reports[1]
    run.Run([1], 20, 20, jobs=1, say=lambda line: None).run()
    assert Blind.count == judged


def test_a_proof_holds_with_another_stimulus(blind, proving, monkeypatch):
    def outcomes():
        run.Run([1], 20, 0, jobs=1, say=lambda line: None).run().report(blind)
        report = json.loads((blind / "report.json").read_text())
        return report["killed"], report["equivalent"]

    first, judged = outcomes(), Blind.count
    monkeypatch.setattr(Blind, "stimulus", blind / "other")
    (blind / "other").write_text("of today")
    killed, equivalent = outcomes()
    assert first[0] > 0 and killed + equivalent == sum(first)
    assert Blind.count - judged == first[0], "what was noticed is asked again, and nothing else"


def test_a_verdict_that_was_broken_off_is_given_again(blind, proving):
    """By Ctrl-C or a full disk, in the middle of a line."""
    run.Run([1], 5, 5, jobs=1, say=lambda line: None).run()
    [kept] = (blind / "work").glob("verdicts_*.jsonl")
    text = kept.read_text()
    kept.write_text(text[: len(text) - 20])
    judged, said = Blind.count, []
    run.Run([1], 5, 5, jobs=1, say=said.append).run().report(blind)
    assert Blind.count - judged in (1, 2) and json.loads((blind / "report.json").read_text())["mutants"] == 10
    judged = Blind.count
    run.Run([1], 5, 5, jobs=1, say=said.append).run()
    assert Blind.count == judged, "the one behind it is whole"


def test_what_has_survived_is_judged_again(blind, monkeypatch):
    monkeypatch.setattr(Blind, "noticed", lambda self, *files_and_folder: "")
    monkeypatch.setattr(Believer, "objection", lambda self, *files_and_folder: "no proof")
    assert run.Run([1], 5, 5, jobs=1, say=lambda line: None).run().report(blind) == 10
    monkeypatch.setattr(Believer, "objection", lambda self, *files_and_folder: "")
    assert run.Run([1], 5, 5, jobs=1, say=lambda line: None).run().report(blind) == 0


def test_what_a_test_notices_is_not_proved(blind, monkeypatch):
    monkeypatch.setattr(Blind, "noticed", lambda self, *files_and_folder: "a test")
    monkeypatch.setattr(Believer, "objection", lambda self, *files_and_folder: pytest.fail("asked for a proof"))
    assert run.Run([1], 5, 5, jobs=1, say=lambda line: None).run().report(blind) == 0


def test_what_synthesis_refuses_is_killed(blind, monkeypatch):
    def refuses(self, *files_and_folder):
        raise NotSynthesizedError("latch inferred")

    monkeypatch.setattr(Blind, "noticed", lambda self, *files_and_folder: "")
    monkeypatch.setattr(Believer, "objection", refuses)
    assert run.Run([1], 5, 5, jobs=1, say=lambda line: None).run().report(blind) == 0
    assert "latch inferred" in json.loads((blind / "report.json").read_text())["verdicts"][0]["by"]


def test_an_argument_names_a_test_and_holds_for_its_statements_only(tmp_path):
    tests = (Path(__file__).parent / "test_mutation_arguments.py").read_text()
    for argument in arguments.ARGUMENTS:
        assert f"def {argument.test}(" in tests
    path = tmp_path / "e.vhd"
    path.write_text(TEXT)
    assert not any(arguments.of(mutant) for mutant in mutants.mutants_of(path))


@pytest.mark.parametrize("options", [["--core", "-1"], ["--core", "0", "--shell", "0"]])
def test_bad_options(options):
    refused(call("mutate.py", *options), 2, "must be")


def test_the_table_of_kept_results_is_up_to_date():
    process = call("mutate.py", "--check")
    assert process.returncode == 0, process.stderr


def argued(core, statement, change):
    key = f"stereo_core_{core}.vhd | {statement} | {change}"
    return arguments.of(mutants.Mutant(Path("core.vhd"), 1, statement, "constant", key))


def test_every_argument_has_its_test():
    tests = (ROOT / "scripts" / "tests" / "test_mutation_arguments.py").read_text()
    assert all(f"def {one.test}(" in tests for one in arguments.ARGUMENTS)


def test_an_argument_from_the_sizes_of_a_core_holds_of_no_other():
    fault = "forward_occluding_5 <= 128;", "assignment dropped"
    assert argued("tiny_trellis", *fault) and not argued("tiny_trellis_w1", *fault)
    everywhere = "raster_place_column <= 0;", "column 31: 0 -> 1"
    assert argued("tiny_trellis", *everywhere) and argued("tiny_trellis_w1", *everywhere)
    assert not argued("tiny_trellis", everywhere[0], "column 31: 0 -> 2")
