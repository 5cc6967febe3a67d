// SPDX-License-Identifier: Apache-2.0
// Names every register of the clocked core. The VHDL writer gives a register of the netlist the name of the C++ member
// that shows the same values clock for clock.
#pragma once

#include "vectors/slice_register_names.hpp"

namespace stereo {

namespace register_names {

template <class Visit, class Counter>
void visit_counter(Visit& visit, const std::string& name, const Counter& counter) {
   visit_value(visit, name + "_column", counter.column);
   visit_value(visit, name + "_group", counter.group);
   visit_value(visit, name + "_next_frame", counter.next_frame);
}

/// `Rows` is a RowBuffer.
template <class Visit, class Rows>
void visit_row_buffer(Visit& visit, const std::string& name, const Rows& rows) {
   visit_array(visit, name + "_read_words", rows.read_words);
   visit_array(visit, name + "_read_newest", rows.read_newest);
   visit_array(visit, name + "_ready_words", rows.ready_words);
   visit_array(visit, name + "_ready_newest", rows.ready_newest);
   visit_array(visit, name + "_write_words", rows.write_words);
}

/// `Place` is that of a Transform.
template <class Visit, class Place>
void visit_transform_place(Visit& visit, const std::string& name, const Place& place) {
   visit_value(visit, name + "_column", place.column);
   visit_array(visit, name + "_row_inside", place.row_inside);
   visit_array(visit, name + "_column_inside", place.column_inside);
   visit_value(visit, name + "_start_of_frame", place.start_of_frame);
   visit_value(visit, name + "_valid", place.valid);
}

template <class Visit>
void visit_transform(Visit&, const Absent&) {}
template <class Visit, const StereoConfig& C>
void visit_transform(Visit& visit, const Transform<C>& transform) {
   visit_array(visit, "transform_left", transform.left);
   visit_array(visit, "transform_right", transform.right);
   visit_value(visit, "transform_valid", transform.valid);
   visit_counter(visit, "transform_counter", transform.counter);
   visit_row_buffer(visit, "transform_left_rows", transform.left_rows);
   visit_row_buffer(visit, "transform_right_rows", transform.right_rows);
   visit_transform_place(visit, "transform_read", transform.read);
   visit_transform_place(visit, "transform_ready", transform.ready);
   visit_value(visit, "transform_write_column", transform.write_column);
   visit_array(visit, "transform_left_column", transform.left_column);
   visit_array(visit, "transform_right_column", transform.right_column);
   visit_transform_place(visit, "transform_columns", transform.columns);
   visit_array(visit, "transform_left_filter_column", transform.left_filter.column);
   visit_array(visit, "transform_left_filter_feature", transform.left_filter.feature);
   visit_array(visit, "transform_right_filter_column", transform.right_filter.column);
   visit_array(visit, "transform_right_filter_feature", transform.right_filter.feature);
   visit_transform_place(visit, "transform_filtering", transform.filtering);
   visit_transform_place(visit, "transform_filtered", transform.filtered);
}

template <class Visit, const StereoConfig& C>
void visit_raster(Visit& visit, const Raster<C>& raster) {
   visit_array(visit, "raster_search", raster.features.search);
   visit_array(visit, "raster_reference", raster.features.reference);
   // Where only the packed lanes are used, the tool keeps them as words.
   typename PairDelay<C>::Word words[PairDelay<C>::Pack::kWords];
   PairDelay<C>::Pack::pack(raster.features.search, words);
   visit_array(visit, "raster_search_words", words);
   PairDelay<C>::Pack::pack(raster.features.reference, words);
   visit_array(visit, "raster_reference_words", words);
   visit_value(visit, "raster_valid", raster.features.valid);
   visit_counter(visit, "raster", raster.place);
}

template <class Visit, const StereoConfig& C>
void visit_delay(Visit& visit, const PairDelay<C>& delay) {
   visit_value(visit, "delay_read_address", delay.ring.read_address);
   visit_value(visit, "delay_write_address", delay.ring.write_address);
   visit_array(visit, "delay_ahead", delay.ahead);
   visit_array(visit, "delay_delayed", delay.delayed);
   visit_value(visit, "delay_column", delay.column);
   visit_array(visit, "delay_row_inside", delay.row_inside);
   visit_tag(visit, "delay_tag", delay.tag);
}

/// `Place` is LineBuffer<C>::Place.
template <class Visit, class Place>
void visit_place(Visit& visit, const std::string& name, const Place& place) {
   visit_value(visit, name + "_column", place.column);
   visit_array(visit, name + "_inside", place.inside);
   visit_tag(visit, name + "_tag", place.tag);
}

template <class Visit, const StereoConfig& C>
void visit_rows(Visit& visit, const LineBuffer<C>& rows) {
   visit_row_buffer(visit, "rows_search_rows", rows.search_rows);
   visit_row_buffer(visit, "rows_reference_rows", rows.reference_rows);
   visit_place(visit, "rows_read", rows.read);
   visit_place(visit, "rows_ready", rows.ready);
   visit_value(visit, "rows_write_column", rows.write_column);
   visit_array(visit, "rows_search", rows.search);
   visit_array(visit, "rows_reference", rows.reference);
   visit_array(visit, "rows_inside", rows.inside);
   visit_tag(visit, "rows_tag", rows.tag);
}

template <class Visit>
void visit_texture(Visit&, const Absent&) {}
template <class Visit, const StereoConfig& C>
void visit_texture(Visit& visit, const Texture<C>& texture) {
   visit_array(visit, "texture_taps_search", texture.taps.search);
   visit_array(visit, "texture_taps_reference", texture.taps.reference);
   visit_tag(visit, "texture_taps_tag", texture.taps.tag);
   visit_cost(visit, "texturecost", texture.cost);
   visit_window(visit, "texturewindow", texture.window);
   visit_array(visit, "texture_passes", texture.passes);
}

template <class Visit, const StereoConfig& C>
void visit_refinement(Visit& visit, const Refinement<C>& refinement) {
   if constexpr (Refinement<C>::kClocks > 0) {
      visit_array(visit, "refinement_disparity", refinement.disparity);
      visit_array(visit, "refinement_passed", refinement.passed);
      for (int stage = 0; stage < Refinement<C>::kClocks; ++stage)
         visit_tag(visit, "refinement_tag_" + std::to_string(stage), refinement.tag[stage]);
      visit_array(visit, "refinement_cost", refinement.cost);
      visit_array(visit, "refinement_gap", refinement.gap);
      visit_array(visit, "refinement_alone", refinement.alone);
      visit_array(visit, "refinement_scaled_gap", refinement.scaled_gap);
      visit_array(visit, "refinement_scaled_cost", refinement.scaled_cost);
      visit_array(visit, "refinement_remainder", refinement.remainder);
      visit_array(visit, "refinement_divisor", refinement.divisor);
      visit_array(visit, "refinement_quotient", refinement.quotient);
      visit_array(visit, "refinement_negative", refinement.negative);
      visit_array(visit, "refinement_fraction", refinement.fraction);
   }
}

template <class Visit, const StereoConfig& C>
void visit_winners(Visit& visit, const std::string& name, const Winners<C>& winners) {
   visit_array(visit, name + "_disparity", winners.disparity);
   visit_array(visit, name + "_fraction", winners.fraction);
   visit_array(visit, name + "_passed", winners.passed);
   visit_tag(visit, name + "_tag", winners.tag);
}

template <class Visit>
void visit_left_right(Visit&, const Absent&) {}
template <class Visit, const StereoConfig& C>
void visit_left_right(Visit& visit, const LeftRightCheck<C>& check) {
   visit_array(visit, "leftright_other", check.other);
   visit_value(visit, "leftright_read_address", check.ring.read_address);
   visit_value(visit, "leftright_write_address", check.ring.write_address);
   visit_value(visit, "leftright_position", check.position);
   visit_array(visit, "leftright_held", check.held);
   visit_value(visit, "leftright_held_position", check.held_position);
   visit_value(visit, "leftright_held_valid", check.held_valid);
   visit_value(visit, "leftright_holds_winners", check.holds_winners);
   visit_array(visit, "leftright_address", check.address);
   visit_winners(visit, "leftright_asking", check.asking);
   visit_array(visit, "leftright_found", check.found);
   visit_winners(visit, "leftright_answered", check.answered);
   visit_winners(visit, "leftright_checked", check.checked);
}

/// `Place` is that of a Median.
template <class Visit, class Place>
void visit_median_place(Visit& visit, const std::string& name, const Place& place) {
   visit_value(visit, name + "_column", place.column);
   visit_value(visit, name + "_arrives", place.arrives);
   visit_value(visit, name + "_behind", place.behind);
   visit_value(visit, name + "_top", place.top);
   visit_value(visit, name + "_bottom", place.bottom);
   visit_value(visit, name + "_output", place.output);
}

template <class Visit, const StereoConfig& C>
void visit_map_group(Visit& visit, const std::string& name, const MapGroup<C>& group) {
   visit_array(visit, name + "_disparity", group.disparity);
   visit_array(visit, name + "_passed", group.passed);
   visit_value(visit, name + "_valid", group.valid);
   visit_value(visit, name + "_start_of_frame", group.start_of_frame);
   visit_value(visit, name + "_end_of_line", group.end_of_line);
}

template <class Visit>
void visit_map_block(Visit&, const Absent&) {}
template <class Visit, const StereoConfig& C>
void visit_map_block(Visit& visit, const MapRegister<C>& map) {
   visit_map_group(visit, "map_out", map.out);
}
template <class Visit, const StereoConfig& C>
void visit_map_block(Visit& visit, const Median<C>& median) {
   visit_counter(visit, "median_counter", median.counter);
   visit_array(visit, "median_newest", median.newest);
   visit_value(visit, "median_arrives", median.arrives);
   visit_value(visit, "median_behind", median.behind);
   visit_value(visit, "median_line_ended", median.line_ended);
   visit_row_buffer(visit, "median_rows", median.rows);
   visit_median_place(visit, "median_read", median.read);
   visit_median_place(visit, "median_ready", median.ready);
   visit_value(visit, "median_write_column", median.write_column);
   visit_array(visit, "median_column", median.column);
   // Of the rows around the group nobody needs the validity.
   for (const int row : {0, C.pixels_per_clock + 1})
      visit_value(visit, "median_column_" + std::to_string(row) + "_value", uint32_t(median.column[row] & ~1u));
   visit_median_place(visit, "median_at", median.at);
   visit_array(visit, "median_low", median.low);
   visit_array(visit, "median_middle", median.middle);
   visit_array(visit, "median_high", median.high);
   visit_array(visit, "median_passed", median.passed);
   visit_value(visit, "median_complete", median.complete);
   visit_value(visit, "median_first", median.first);
   visit_value(visit, "median_last", median.last);
   visit_array(visit, "median_largest_low", median.largest_low);
   visit_array(visit, "median_median_middle", median.median_middle);
   visit_array(visit, "median_smallest_high", median.smallest_high);
   visit_map_group(visit, "median_waiting", median.waiting);
   visit_map_group(visit, "median_out", median.out);
}

}  // namespace register_names

/// Calls visit(name, value, negative) for each register in data-flow order; `value` is a uint64_t, of a negative
/// register in two's complement. The part of a name before its first '_' is the block, which in slice number s (from 0,
/// in the order in which they get the pixels) begins with "slice<s>". Where C.cost_clocks joins steps, registers
/// between them are named too, though the hardware has only wires there.
template <const StereoConfig& C, class Visit>
void for_each_register(const StereoCore<C>& core, Visit visit) {
   using namespace register_names;
   visit_transform(visit, core.transform);
   visit_raster(visit, core.raster);
   visit_delay(visit, core.delay);
   visit_rows(visit, core.rows);
   visit_slices(visit, core.slices, 0);
   visit_texture(visit, core.texture);
   visit_refinement(visit, core.refinement);
   visit_left_right(visit, core.left_right);
   visit_map_block(visit, core.map_block);
}

}  // namespace stereo
