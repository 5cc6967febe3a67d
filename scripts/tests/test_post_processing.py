# SPDX-License-Identifier: Apache-2.0
"""docs/post_processing.md: each stage makes the maps better, and the page says what was measured."""

import pytest

from flow.pages import post_processing, quality
from flow.rendering import pictures
from flow_commands import call, refused

PAIR = quality.default_pair()
DENSE = {rows[0].config: rows[-1] for rows in post_processing.FAMILIES.values()}


def bad(method, measure, mask="all", share="invalid_bad"):
    return 100 * method["masks"][mask][measure][share]


@pytest.fixture(scope="module")
def teddy():
    missing = quality.missing_files(PAIR)
    if missing:
        pytest.skip(f"SKIP: the stereo pair teddy is missing ({missing[0]}); set STEREO_DATA to its folder")
    return quality.pair_images(PAIR)


@pytest.fixture(scope="module")
def scenes(tmp_path_factory):
    return [post_processing.scene(seed, tmp_path_factory.mktemp("scene")) for seed in (1, 2)]


# Bad 1 and bad 2 of all pixels, and bad 1 of the surest 80 percent.
@pytest.mark.parametrize(
    ("config", "bad_1", "bad_2", "surest"), [("sgm_450_dense", 8.7, 5.2, 2.4), ("census_450_dense", 13.2, 8.6, 3.6)]
)
def test_teddy_has_no_holes_and_few_bad_pixels(teddy, config, bad_1, bad_2, surest):
    dense = post_processing.measure(teddy, DENSE[config])
    assert bad(dense, "bad_1") <= bad_1
    assert bad(dense, "bad_2") <= bad_2
    sure = post_processing.measure(teddy, DENSE[config], "--surest", 80)
    assert sure["masks"]["all"]["density"] >= 0.79
    assert bad(sure, "bad_1", share="valid_only") <= surest


@pytest.mark.parametrize("config", list(DENSE))
def test_all_stages_beat_the_winners_on_scenes(scenes, config):
    rows = next(rows for rows in post_processing.FAMILIES.values() if rows[0].config == config)
    for images in scenes:
        winners, dense = (post_processing.measure(images, row) for row in (rows[0], rows[-1]))
        assert bad(dense, "bad_2") < 0.5 * bad(winners, "bad_2")


def test_all_stages_beat_the_winners_outdoors():
    """By D1; what no fill can know is how a road slants (docs/post_processing.md)."""
    pairs = post_processing.outdoor_pairs()
    if missing := [path for pair in pairs for path in pair.missing]:
        pytest.skip(f"SKIP: a stereo pair is missing ({missing[0]}); set STEREO_DATA to its folder")
    rows = (post_processing.OUTDOORS[1], post_processing.OUTDOORS[-1])
    for pair in pairs:
        more = ("--border", 0, "--set", f"disparities={pair.disparities}")
        winners, dense = (post_processing.measure(pair.images, row, *more) for row in rows)
        assert bad(dense, "d1") < 0.8 * bad(winners, "d1")


def test_confidence_sorts_pixels_by_their_error(scenes):
    for row in DENSE.values():
        shares = [
            bad(post_processing.measure(scenes[0], row, "--surest", percent), "bad_2", share="valid_only")
            for percent in (50, 70, 90)
        ]
        assert shares == sorted(shares) and shares[0] < shares[-1]


def test_the_committed_page_shows_what_is_measured(teddy):
    text = post_processing.PAGE.read_text()
    for part in (
        *(post_processing.stages_table(rows, [teddy]) for rows in post_processing.FAMILIES.values()),
        post_processing.confidence_table([teddy]),
    ):
        assert part in text, "run scripts/post_processing.py"
    assert "Do not edit" in text and "scripts/post_processing.py" in text


def test_a_missing_pair_is_said(tmp_path):
    process = call("post_processing.py", "--check", environment={"STEREO_DATA": str(tmp_path)})
    refused(process, 2, "the pair Teddy is missing", "left.png")


def test_the_picture_is_told_by_what_it_shows(tmp_path):
    png = tmp_path / "one.png"
    png.write_bytes(pictures.png(pictures.blank(9, 8)))
    shown = [post_processing.Shown("left image", png, "0123"), post_processing.Shown("winners", png, "4567")]
    assert "<!-- drawn from: left_image=0123 winners=4567 -->" in post_processing._svg(shown)
