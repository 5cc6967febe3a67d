// SPDX-License-Identifier: Apache-2.0
// Names the registers of the chain of slices: shifts, costs, windows and winner trees. See register_names.hpp.
#pragma once

#include <string>

#include "stereo_core.hpp"

namespace stereo::register_names {

template <class Visit, class T, int N>
void visit_array(Visit& visit, const std::string& name, const T (&array)[N]) {
   for (int i = 0; i < N; ++i) {
      const std::string element = name + "_" + std::to_string(i);
      if constexpr (std::is_array_v<T>) {
         visit_array(visit, element, array[i]);
      } else {
         visit(element, static_cast<uint64_t>(array[i]), array[i] < T(0));
      }
   }
}

template <class Visit, class T>
void visit_value(Visit& visit, const std::string& name, T value) {
   visit(name, static_cast<uint64_t>(value), value < T(0));
}

template <class Visit>
void visit_tag(Visit& visit, const std::string& name, const PixelTag& tag) {
   visit_value(visit, name + "_valid", tag.valid);
   visit_value(visit, name + "_row_start", tag.row_start);
   visit_value(visit, name + "_first_group", tag.first_group);
   visit_value(visit, name + "_border_column", tag.border_column);
   visit_value(visit, name + "_first_cost", tag.first_cost);
   visit_value(visit, name + "_leaves_window", tag.leaves_window);
   visit_value(visit, name + "_map_column", tag.map_column);
   visit_value(visit, name + "_output_column", tag.output_column);
   visit_value(visit, name + "_first_column", tag.first_column);
   visit_value(visit, name + "_start_of_frame", tag.start_of_frame);
   visit_value(visit, name + "_end_of_line", tag.end_of_line);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_shift(Visit& visit, const std::string& name, const DisparityShift<C, Count>& shift) {
   visit_array(visit, name + "_search", shift.search);
   visit_array(visit, name + "_reference", shift.reference);
   visit_array(visit, name + "_search_out", shift.search_out);
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
void visit_pixels(Visit& visit, const std::string& name, const PixelCost<C, Count>& pixels) {
   for (int t = 0; t < C.tap_rows(); ++t)
      for (int i = 0; i < Count; ++i) {
         const std::string first = name + "_first_" + std::to_string(t) + "_" + std::to_string(i);
         if constexpr (C.cost == Cost::census) visit_array(visit, first, pixels.first[t][i].count);
         else visit_value(visit, first, pixels.first[t][i]);
      }
   visit_tag(visit, name + "_first_tag", pixels.first_tag);
   visit_array(visit, name + "_cost", pixels.cost);
   visit_tag(visit, name + "_tag", pixels.tag);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_cost(Visit& visit, const std::string& name, const DirectColumn<C, Count>& cost) {
   visit_pixels(visit, name + "_pixels", cost.pixels);
   visit_array(visit, name + "_column", cost.column);
   visit_tag(visit, name + "_tag", cost.tag);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_cost(Visit& visit, const std::string& name, const RecursiveColumn<C, Count>& cost) {
   visit_pixels(visit, name + "_pixels", cost.pixels);
   visit_value(visit, name + "_read_column", cost.read_column);
   visit_array(visit, name + "_read_words", cost.read_words);
   visit_value(visit, name + "_change_column", cost.change_column);
   visit_array(visit, name + "_change", cost.change);
   visit_array(visit, name + "_ready_words", cost.ready_words);
   visit_value(visit, name + "_ready_column", cost.ready_column);
   visit_tag(visit, name + "_ready_tag", cost.ready_tag);
   visit_array(visit, name + "_column", cost.column);
   visit_value(visit, name + "_write_column", cost.write_column);
   visit_array(visit, name + "_write_words", cost.write_words);
   visit_tag(visit, name + "_tag", cost.tag);
}

template <class Visit, const StereoConfig& C>
void visit_centre(Visit& visit, const std::string& name, const CentreTag<C>& centre) {
   for (int j = 0; j < CentreTag<C>::kAfter; ++j) {
      const std::string place = name + "_" + std::to_string(j);
      visit_value(visit, place + "_map_column", centre.map_column[j]);
      visit_value(visit, place + "_output_column", centre.output_column[j]);
      visit_value(visit, place + "_first_column", centre.first_column[j]);
      visit_value(visit, place + "_start_of_frame", centre.start_of_frame[j]);
      visit_value(visit, place + "_end_of_line", centre.end_of_line[j]);
   }
}

template <class Visit, const StereoConfig& C, int Count>
void visit_window(Visit& visit, const std::string& name, const WindowSum<C, Count>& window) {
   visit_array(visit, name + "_partial", window.partial);
   visit_centre(visit, name + "_centre", window.centre);
   visit_array(visit, name + "_sum", window.sum);
   visit_tag(visit, name + "_tag", window.tag);
}

template <class Visit, const StereoConfig& C, int Count>
void visit_window(Visit& visit, const std::string& name, const RunningWindowSum<C, Count>& window) {
   visit_value(visit, name + "_read_address", window.ring.read_address);
   visit_value(visit, name + "_write_address", window.ring.write_address);
   visit_array(visit, name + "_leaving", window.leaving);
   visit_array(visit, name + "_entering", window.entering);
   visit_tag(visit, name + "_entering_tag", window.entering_tag);
   visit_array(visit, name + "_change", window.change);
   visit_tag(visit, name + "_change_tag", window.change_tag);
   visit_array(visit, name + "_sum", window.sum);
   visit_centre(visit, name + "_centre", window.centre);
   visit_tag(visit, name + "_tag", window.tag);
}

template <class Visit, const StereoConfig& C, int N>
void visit_candidates(Visit& visit, const std::string& name, const Candidates<C, N>& candidates) {
   visit_array(visit, name + "_cost", candidates.cost);
   visit_array(visit, name + "_index", candidates.index);
   if constexpr (Candidate<C>::kHasNeighbours) {
      visit_array(visit, name + "_below", candidates.below);
      visit_array(visit, name + "_above", candidates.above);
      visit_array(visit, name + "_first", candidates.first);
      visit_array(visit, name + "_last", candidates.last);
   }
   if constexpr (Candidate<C>::kHasSecond) {
      visit_array(visit, name + "_second", candidates.second);
      visit_array(visit, name + "_but_first", candidates.but_first);
      visit_array(visit, name + "_but_last", candidates.but_last);
   }
}

template <class Visit, const StereoConfig& C, int N, int Levels, int Span>
void visit_winner(Visit& visit, const std::string& slice, const WinnerTree<C, N, Levels, Span>& winner, int level) {
   if constexpr (Levels > 0) {
      const std::string name = slice + "winner" + std::to_string(level);
      visit_candidates(visit, name, winner.best);
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
   if constexpr (C.has_left_right_check()) {
      visit_array(visit, name + "other_cost", slice.other.cost);
      visit_array(visit, name + "other_winner", slice.other.winner);
      visit_array(visit, name + "other_cost_out", slice.other.cost_out);
      visit_array(visit, name + "other_winner_out", slice.other.winner_out);
   }
   visit_winner(visit, name, slice.winner, 1);
   visit_candidates(visit, name + "best", slice.best);
   visit_tag(visit, name + "best_tag", slice.best_tag);
   if constexpr (!DisparitySlice<C, Disparities>::kIsLast) visit_slices(visit, slice.next, number + 1);
}

}  // namespace stereo::register_names
