// SPDX-License-Identifier: Apache-2.0
// Names every register of the clocked core. The VHDL writer gives a register of the netlist the name of the C++ member
// that shows the same values clock for clock.
#pragma once

#include <string>

#include "stereo_core.hpp"

namespace stereo {

namespace register_names {

template <class Visit, class T, int N>
void visit_array(Visit& visit, const std::string& name, const T (&array)[N]) {
   for (int i = 0; i < N; ++i) {
      const std::string element = name + "_" + std::to_string(i);
      if constexpr (std::is_array_v<T>) {
         visit_array(visit, element, array[i]);
      } else {
         visit(element, static_cast<int64_t>(array[i]));
      }
   }
}

template <class Visit>
void visit_tag(Visit& visit, const std::string& name, const PixelTag& tag) {
   visit(name + "_valid", tag.valid);
   visit(name + "_border_column", tag.border_column);
   visit(name + "_output_column", tag.output_column);
   visit(name + "_start_of_frame", tag.start_of_frame);
   visit(name + "_end_of_line", tag.end_of_line);
}

template <class Visit, const StereoConfig& C>
void visit_raster(Visit& visit, const Raster<C>& raster) {
   visit_array(visit, "raster_left", raster.left);
   visit("raster_right", raster.right);
   visit("raster_valid", raster.valid);
   visit("raster_column", raster.column);
   visit("raster_group", raster.group);
   visit("raster_next_frame", raster.next_frame);
}

template <class Visit, const StereoConfig& C>
void visit_reference(Visit& visit, const ReferenceDelay<C>& reference) {
   visit("reference_read_address", reference.read_address);
   visit("reference_write_address", reference.write_address);
   visit_array(visit, "reference_left", reference.left);
   visit("reference_right", reference.right);
   visit("reference_column", reference.column);
   visit_array(visit, "reference_row_inside", reference.row_inside);
   visit_tag(visit, "reference_tag", reference.tag);
}

/// `Column` is LineBuffer<C>::Column.
template <class Visit, class Column>
void visit_column(Visit& visit, const std::string& name, const Column& column) {
   visit(name + "_left_word", static_cast<int64_t>(column.left_word));
   visit(name + "_right_word", static_cast<int64_t>(column.right_word));
   visit_array(visit, name + "_left", column.left);
   visit_array(visit, name + "_right", column.right);
   visit(name + "_column", column.column);
   visit_array(visit, name + "_inside", column.inside);
   visit_tag(visit, name + "_tag", column.tag);
}

template <class Visit, const StereoConfig& C>
void visit_rows(Visit& visit, const LineBuffer<C>& rows) {
   visit_column(visit, "rows_read", rows.read);
   visit_column(visit, "rows_ready", rows.ready);
   visit_array(visit, "rows_left", rows.left);
   visit_array(visit, "rows_right", rows.right);
   visit_tag(visit, "rows_tag", rows.tag);
   visit("rows_write_left", static_cast<int64_t>(rows.write_left));
   visit("rows_write_right", static_cast<int64_t>(rows.write_right));
   visit("rows_write_column", rows.write_column);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_shift(Visit& visit, const std::string& name, const DisparityShift<C, Count>& shift) {
   visit_array(visit, name + "_left", shift.left);
   visit_array(visit, name + "_right", shift.right);
   visit_array(visit, name + "_left_out", shift.left_out);
   visit_tag(visit, name + "_tag", shift.tag);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_cost(Visit& visit, const std::string& name, const SadCost<C, Count>& cost) {
   visit_array(visit, name + "_difference", cost.difference);
   visit_array(visit, name + "_reverse", cost.reverse);
   visit_tag(visit, name + "_difference_tag", cost.difference_tag);
   visit_array(visit, name + "_pair", cost.pair);
   visit_array(visit, name + "_single", cost.single);
   visit_array(visit, name + "_negative", cost.negative);
   visit_tag(visit, name + "_pair_tag", cost.pair_tag);
   visit_array(visit, name + "_column", cost.column);
   visit_tag(visit, name + "_tag", cost.tag);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_window(Visit& visit, const std::string& name, const WindowSum<C, Count>& window) {
   visit_array(visit, name + "_partial", window.partial);
   for (int j = 0; j < C.radius_px(); ++j) visit_tag(visit, name + "_centre_" + std::to_string(j), window.centre[j]);
   visit_array(visit, name + "_sum", window.sum);
   visit_tag(visit, name + "_tag", window.tag);
}

template <class Visit, int Pixels, int N, int Group, int Levels>
void visit_winner(Visit& visit, const std::string& slice, const WinnerTree<Pixels, N, Group, Levels>& winner,
                  int level) {
   if constexpr (Levels > 0) {
      const std::string name = slice + "winner" + std::to_string(level);
      visit_array(visit, name + "_cost", winner.cost);
      visit_array(visit, name + "_index", winner.index);
      visit_tag(visit, name + "_tag", winner.tag);
      visit_winner(visit, slice, winner.next, level + 1);
   }
}

template <class Visit, const StereoConfig& C, int Disparities>
void visit_slices(Visit& visit, const DisparitySlice<C, Disparities>& slice, int number) {
   const std::string name = "slice" + std::to_string(number);
   visit_shift(visit, name + "shift", slice.shift);
   visit_cost(visit, name + "cost", slice.cost);
   visit_window(visit, name + "window", slice.window);
   visit_winner(visit, name, slice.winner, 1);
   visit_array(visit, name + "best_cost", slice.best_cost);
   visit_array(visit, name + "best_disparity", slice.best_disparity);
   visit_tag(visit, name + "best_tag", slice.best_tag);
   if constexpr (!DisparitySlice<C, Disparities>::kIsLast) visit_slices(visit, slice.next, number + 1);
}

}  // namespace register_names

/// Calls visit(name, value) for each register in data-flow order; `value` is an int64_t. The part of a name before its
/// first '_' is the block, which in slice number s (from 0, the highest disparities first) begins with "slice<s>".
/// Where C.cost_clocks joins steps, registers between them are named too, though the hardware has only wires there.
template <const StereoConfig& C, class Visit>
void for_each_register(const StereoCore<C>& core, Visit visit) {
   using namespace register_names;
   visit_raster(visit, core.raster);
   visit_reference(visit, core.reference);
   visit_rows(visit, core.rows);
   visit_slices(visit, core.slices, 0);
}

}  // namespace stereo
