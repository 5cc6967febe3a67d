# SPDX-License-Identifier: Apache-2.0
"""How mutants are made and counted; no simulator needed."""

import json
from itertools import islice

import pytest

from flow.mutation import mutants, run
from flow.shell import design
from flow.synthesis import manifest
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

    def __init__(self, *stages):
        pass

    def noticed(self, *files_and_folder):
        Blind.count += 1
        return "a test" if Blind.count % 10 == 0 else ""


@pytest.fixture
def blind(monkeypatch, tmp_path):
    for name in ("Core", "Shell"):
        monkeypatch.setattr(run, name, Blind)
    monkeypatch.setattr(run, "compiles", lambda files, folder: True)
    monkeypatch.setattr(run, "refuted", lambda mutant, folder: "")
    monkeypatch.setattr(run, "WORK", tmp_path / "work")
    monkeypatch.setattr(run, "EXPLANATIONS", tmp_path / "equivalent.json")
    return tmp_path


def test_survivors_are_reported(blind):
    (blind / "equivalent.json").write_text("{}")
    said = []
    score, unexplained = run.Run(1, 20, 20, jobs=1, say=said.append).run().report(blind)
    report = json.loads((blind / "report.json").read_text())
    assert report["mutants"] == 40 and report["killed"] + len(report["survivors"]) == 40
    assert report["survivors"] == unexplained and score < 20
    assert sum(line.startswith("survived") for line in said) == len(unexplained)


def test_explained_survivors_do_not_count(blind):
    (blind / "equivalent.json").write_text("{}")
    _, unexplained = run.Run(1, 20, 20, jobs=1, say=lambda line: None).run().report(blind)
    (blind / "equivalent.json").write_text(json.dumps(dict.fromkeys(unexplained, "a reason")))
    # The verdicts are remembered: nothing is judged again.
    score, left = run.Run(1, 20, 20, jobs=1, say=lambda line: None).run().report(blind)
    assert (score, left) == (100.0, [])


def test_an_explanation_of_a_killed_mutant_is_reported(blind):
    (blind / "equivalent.json").write_text("{}")
    run.Run(1, 20, 20, jobs=1, say=lambda line: None).run().report(blind)
    killed = next(
        verdict["key"]
        for verdict in json.loads((blind / "report.json").read_text())["verdicts"]
        if verdict["outcome"] == "killed"
    )
    (blind / "equivalent.json").write_text(json.dumps({killed: "wrong"}))
    _, left = run.Run(1, 20, 20, jobs=1, say=lambda line: None).run().report(blind)
    assert killed in left


def test_each_explanation_names_a_mutant_and_gives_a_reason():
    keys = {
        mutant.key
        for path in (*manifest.core_files("tiny"), *design.shell_files())
        for mutant in mutants.mutants_of(path)
    }
    explanations = json.loads(run.EXPLANATIONS.read_text())
    assert set(explanations) <= keys, set(explanations) - keys
    assert all(len(reason) > 20 for reason in explanations.values())


@pytest.mark.parametrize("options", [["--core", "-1"], ["--core", "0", "--shell", "0"], ["--jobs", "0"]])
def test_bad_options(options):
    refused(call("mutate.py", *options), 2, "must be")
