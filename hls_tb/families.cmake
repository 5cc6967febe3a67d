# SPDX-License-Identifier: Apache-2.0
# The stages in front of a matching core.
stereo_add_stage(NAME rectification SOURCES hls HEADER engines/rectification/stages.hpp)

# The algorithm families, one row each.
stereo_add_family(NAME block_matching SOURCES hls MODELS definition/block_matching/models.hpp LINK stereo_models)
stereo_add_family(NAME semi_global SOURCES hls MODELS definition/semi_global/models.hpp LINK stereo_models)
stereo_add_family(NAME trellis SOURCES hls MODELS definition/trellis/models.hpp LINK stereo_models)
stereo_add_family(NAME phase_correlation SOURCES hls MODELS definition/phase_correlation/models.hpp LINK stereo_models)
stereo_add_family(NAME dynamic_range SOURCES hls MODELS definition/dynamic_range/models.hpp LINK stereo_models)
# A family as small as one can be: it goes through every step, so that the tests show what a family needs.
stereo_add_family(NAME absolute_difference SOURCES hls_tb/example_family MODELS absolute_difference/models.hpp LINK stereo_models)
