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
         visit(element, static_cast<uint64_t>(array[i]));
      }
   }
}

template <class Visit>
void visit_tag(Visit& visit, const std::string& name, const PixelTag& tag) {
   visit(name + "_valid", tag.valid);
   visit(name + "_cost_column", tag.cost_column);
   visit(name + "_output_column", tag.output_column);
   visit(name + "_start_of_frame", tag.start_of_frame);
   visit(name + "_end_of_line", tag.end_of_line);
}

template <class Visit, int N, int Group>
void visit_winner(Visit& visit, const WinnerTree<N, Group>& winner, int level) {
   if constexpr (N > 1) {
      const std::string name = "winner" + std::to_string(level);
      visit_array(visit, name + "_cost", winner.cost);
      visit_array(visit, name + "_index", winner.index);
      visit_tag(visit, name + "_tag", winner.tag);
      visit_winner(visit, winner.next, level + 1);
   }
}

}  // namespace register_names

/// Calls visit(name, value) for each register in data-flow order. The part of a name before its first '_' is the block.
template <const StereoConfig& C, class Visit>
void for_each_register(const StereoCore<C>& core, Visit visit) {
   using namespace register_names;
   visit("raster_left", core.raster.left);
   visit("raster_right", core.raster.right);
   visit("raster_valid", core.raster.valid);
   visit("raster_column", core.raster.column);
   visit("raster_row", core.raster.row);
   visit("raster_next_frame", core.raster.next_frame);

   visit("reference_read_address", core.reference.read_address);
   visit("reference_write_address", core.reference.write_address);
   visit("reference_left", core.reference.left);
   visit("reference_right", core.reference.right);
   visit("reference_column", core.reference.column);
   visit_array(visit, "reference_row_inside", core.reference.row_inside);
   visit_tag(visit, "reference_tag", core.reference.tag);

   visit("rows_word", core.rows.word);
   visit("rows_newest_left", core.rows.newest_left);
   visit("rows_newest_right", core.rows.newest_right);
   visit("rows_write_column", core.rows.write_column);
   visit_array(visit, "rows_inside_before", core.rows.inside_before);
   visit_tag(visit, "rows_tag_before", core.rows.tag_before);
   visit_array(visit, "rows_left", core.rows.left);
   visit_array(visit, "rows_right", core.rows.right);
   visit_tag(visit, "rows_tag", core.rows.tag);

   visit_array(visit, "shift_left", core.shift.left);
   visit_array(visit, "shift_right", core.shift.right);
   visit_tag(visit, "shift_tag", core.shift.tag);

   visit_array(visit, "cost_difference", core.cost.difference);
   visit_tag(visit, "cost_tag_before", core.cost.tag_before);
   visit_array(visit, "cost_column", core.cost.column);
   visit_tag(visit, "cost_tag", core.cost.tag);

   visit_array(visit, "window_history", core.window.history);
   for (int j = 0; j < C.radius_px(); ++j)
      visit_tag(visit, "window_centre_" + std::to_string(j), core.window.centre[j]);
   visit_array(visit, "window_sum", core.window.sum);
   visit_tag(visit, "window_tag", core.window.tag);

   visit_winner(visit, core.winner, 1);
}

}  // namespace stereo
