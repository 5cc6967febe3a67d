// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dynamic_range/config.hpp"
#include "dynamic_range/window_targets.hpp"
#include "frontend/raster.hpp"
#include "support/memory_bank.hpp"

namespace stereo::dynamic_range {

/// The rows of a window for which it must be known where the search windows stand.
enum Row { kEntering, kLeaving, kCentre, kRowKinds };
/// The search windows: one along the lowest surfaces, one along the highest.
enum Track { kLow, kHigh, kTracks };

/// Where the search windows stand: their first disparity in the newest column, for the row that enters the matching
/// windows, the one that leaves them and that of the centres. Memory: three times 8 x W/8 x 16 bits.
template <const Config& C>
struct WindowBases {
   static constexpr int kClocks = 5;
   using Targets = WindowTargets<C>;
   using Memory = MemoryBank<uint16_t, Targets::kPlaces, kRowKinds>;
   static constexpr int kMemories = Memory::kMemories;
   static constexpr int kLanes = C.window_disparities;
   static constexpr int kLastColumn = C.width_px - kLanes;  ///< the last one that has costs
   /// What of the newest column goes along.
   struct Place {
      uint16_t column;  ///< of the searched image, as far as the lowest base would be searched
      uint16_t limit;   ///< of the bases: the window must end in the image
      bool head;        ///< the bases are those of column 0
      bool frame_starts;
      bool valid;

      template <class Visitor>
      HLS_INLINE void registers(Visitor& visit) {
         visit("column", column);
         visit("limit", limit);
         visit("head", head);
         visit("frame_starts", frame_starts);
         visit("valid", valid);
      }
   };

   Memory memory;
   uint16_t address[kRowKinds];  // clock 1
   Place asked;
   uint16_t read_targets[kRowKinds];  // clock 2
   Place read;
   uint16_t ready_targets[kRowKinds];  // clock 3
   Place ready;
   uint16_t goal[kTracks][kRowKinds];  // clock 4
   Place wanted;
   uint16_t base[kTracks][kRowKinds];  // clock 5
   uint16_t from[kTracks][kRowKinds];  ///< the base of the column before, from which searched pixels come
   bool rises[kTracks][kRowKinds], falls[kTracks][kRowKinds];
   Place stands;

   template <class Source, int First>
   HLS_INLINE WindowBases(Source& memories, MemoryId<First> first) : memory(memories, first) {
      start(*this);
   }

   template <class Visitor>
   HLS_INLINE void registers(Visitor& visit) {
      visit("address", address);
      visit("asked", asked);
      visit("read_targets", read_targets);
      visit("read", read);
      visit("ready_targets", ready_targets);
      visit("ready", ready);
      visit("goal", goal);
      visit("wanted", wanted);
      visit("base", base);
      visit("from", from);
      visit("rises", rises);
      visit("falls", falls);
      visit("stands", stands);
   }

   template <class Place>
   HLS_INLINE void clock(bool valid, const Place& place, const Targets& targets) {
      uint16_t stored[kRowKinds], newest[kRowKinds];
      memory.read_each(address, stored);
      fill(newest, uint16_t(targets.low | targets.high << kTargetBits));
      memory.write(targets.place, newest);
      step();
      HLS_UNROLL
      for (int row = 0; row < kRowKinds; ++row) {
         goal[kLow][row] = smaller(uint16_t(ready_targets[row] & kTargetMask), ready.limit);
         goal[kHigh][row] = smaller(uint16_t(ready_targets[row] >> kTargetBits), ready.limit);
         ready_targets[row] = read_targets[row];
         read_targets[row] = stored[row];
      }
      wanted = ready;
      ready = read;
      read = asked;
      ask(valid, place);
   }

  private:
   static constexpr int kTargetBits = 8;
   static constexpr uint16_t kTargetMask = (1 << kTargetBits) - 1;
   static HLS_INLINE uint16_t smaller(uint16_t a, uint16_t b) { return select<uint16_t>(a < b, a, b); }

   /// Clock 5.
   HLS_INLINE void step() {
      HLS_UNROLL
      for (int track = 0; track < kTracks; ++track) {
         HLS_UNROLL
         for (int row = 0; row < kRowKinds; ++row) {
            const uint16_t target = goal[track][row], before = base[track][row];
            const bool up = !wanted.head & (target >= before + C.kRise), down = !wanted.head & (target < before);
            const uint16_t still = select<uint16_t>(down, uint16_t(before - C.kFall), before);
            const uint16_t next = select<uint16_t>(up, uint16_t(before + C.kRise), still);
            from[track][row] = select<uint16_t>(wanted.head, target, before);
            rises[track][row] = up;
            falls[track][row] = down;
            base[track][row] = select<uint16_t>(wanted.valid, select<uint16_t>(wanted.head, target, next), before);
         }
      }
      stands = wanted;
   }

   /// Clock 1. Rows outside the image have no costs: where the windows stand there does not matter.
   template <class Place>
   HLS_INLINE void ask(bool valid, const Place& place) {
      constexpr int kOffset[kRowKinds] = {0, C.window_px, (C.window_px - 1) / 2};
      const bool head = place.column < kLanes;
      const uint16_t column = select<uint16_t>(head, 0, uint16_t(place.column - (kLanes - 1)));
      HLS_UNROLL
      for (int row = 0; row < kRowKinds; ++row) {
         const uint16_t band = uint16_t(uint16_t(place.group - kOffset[row]) / C.kBlock);
         address[row] = at_most<Targets::kPlaces - 1>(unsigned((band & (Targets::kBands - 1)) << Targets::kColumnBits) +
                                                      column / C.kBlock);
      }
      asked.column = place.column;
      asked.limit = select<uint16_t>(head, kLastColumn, uint16_t(C.width_px - 1 - place.column));
      asked.head = head;
      asked.frame_starts = (place.group == 0) & (place.column == 0);
      asked.valid = valid;
   }
};

}  // namespace stereo::dynamic_range
