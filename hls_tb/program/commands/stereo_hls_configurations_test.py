# SPDX-License-Identifier: Apache-2.0
"""The commands configurations and options."""

import json

from stereo_hls_program import DISPARITIES, HEIGHT, WIDTH, fail, succeed


def test_configurations_as_json():
    table = json.loads(succeed("configurations", "--json"))
    assert {"ambrosch2007", "tiny"} <= table.keys()
    assert list(table) == sorted(table)
    tiny = table["tiny"]
    assert (tiny["width_px"], tiny["height_px"], tiny["disparities"]) == (WIDTH, HEIGHT, DISPARITIES)
    keys = {
        "width_px",
        "height_px",
        "disparities",
        "pixels_per_clock",
        "disparity_bits",
        "output_width_px",
        "output_height_px",
        "latency_clocks",
        "flush_groups",
        "gap_groups",
    }
    for values in table.values():
        assert keys | {"family", "use", "description", "options"} <= values.keys()
        if values["family"] == "block_matching":
            assert {"window_px", "slice_disparities", "cost_clocks", "winner_group"} <= values.keys()
    for name in ("tiny", "ambrosch2007"):
        assert table[name]["output_width_px"] == table[name]["width_px"] - table[name]["disparities"]
    assert [table[name]["pixels_per_clock"] for name in ("tiny", "tiny_p2", "tiny_p4")] == [1, 2, 4]
    # A row below the image, and of the window that is one column to the right of its centre.
    assert tiny["flush_groups"] == WIDTH and tiny["gap_groups"] == 0
    assert table["tiny_w8_recursive"]["gap_groups"] == 3 * WIDTH, "the rows below the centre of an 8x8 window"


def test_configurations_as_text():
    assert "tiny: 32x12, 8 disparities" in succeed("configurations")


def test_options_as_json():
    table, configurations = (json.loads(succeed(command, "--json")) for command in ("options", "configurations"))
    for row in configurations.values():
        assert table[row["family"]].keys() <= row.keys()
    assert table["block_matching"]["cost"] == {"default": "sad", "words": ["sad", "ssd", "census"]}
    assert table["block_matching"]["window_px"]["low"] == 1 and table["rectification"]["grid_px"]["default"] == 16


def test_options_as_text():
    lines = succeed("options").splitlines()
    assert "block_matching:" in lines and "  cost sad (sad, ssd, census)" in lines
    assert "  cost_clocks 3 (1 ... 3)" in lines and "  window_px 3 (at least 1)" in lines


def test_options_of_one_algorithm(tmp_path):
    """As `match` takes them: what it refuses is refused here, without images."""
    words = ["options", "--config", "tiny_sgm", "--set"]
    shown = json.loads(succeed(*words, "p1=2", "--json"))
    assert shown["p1"] == 2 and shown["subpixel"] is False and "clocks_per_pixel" not in shown
    assert "p1 2" in succeed(*words, "p1=2").splitlines()
    fail(tmp_path, *words, "pixel_bits=9", says=["--set pixel_bits=9", "must be 8, 10 or 12"])
    fail(tmp_path, *words, "clocks_per_pixel=4", says=["there is no such option"])
    fail(tmp_path, "options", "--set", "p1=2", says=["--set", "--config"])
    fail(tmp_path, "options", "--config", "nope", says=["nope", "tiny"])
