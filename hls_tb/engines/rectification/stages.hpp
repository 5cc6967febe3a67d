// SPDX-License-Identifier: Apache-2.0
// The rectification in native code, and its named configurations: a stage in front of a matching core, with ports of
// its own.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engines/clocked/core_shape.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/register_list.hpp"
#include "engines/configurations.hpp"
#include "rectification/core.hpp"

namespace stereo {

/// A rectification core of any configuration: one call of `clock` is one clock of the hardware.
class ClockedRectification {
  public:
   virtual ~ClockedRectification() = default;
   /// What the registers show in this clock.
   virtual WideInput output() const = 0;
   /// The clock edge.
   virtual void clock(const WideInput& in, const rectification::TableWrite& node) = 0;
   /// All registers, in data-flow order.
   virtual std::vector<RegisterView> registers() = 0;
};

template <const rectification::Config& C>
class ClockedRectificationOf final : public ClockedRectification {
  public:
   explicit ClockedRectificationOf(HeapMemories& memories) : core_(memories) {}

   WideInput output() const override { return core_.output(); }
   void clock(const WideInput& in, const rectification::TableWrite& node) override { core_.clock(in, node); }
   std::vector<RegisterView> registers() override {
      std::vector<RegisterView> list;
      RegisterLister lister(list);
      core_.registers(lister);
      return list;
   }

  private:
   rectification::Core<C> core_;
};

/// A named configuration of a stage.
struct Stage {
   std::string name;
   std::string use;            ///< what it is there for, as its row says
   std::string family;         ///< the folder of its sources
   std::string source_folder;  ///< in which that folder stands, from the project's root
   rectification::Config config;
   CoreShape shape;  ///< a pixel pair leaves as a word of 2 pixel_bits, the left camera's in the lower half
   std::vector<OptionValue> options;
   std::vector<OptionValue> changed;  ///< those that are not the defaults, but for the images' size
   /// In the state after a reset; `memories` as with CoreModule::make.
   std::unique_ptr<ClockedRectification> (*make)(HeapMemories& memories);

   /// Such as "640x480, a node every 16 pixels, 16 rows above and 16 below".
   std::string description() const;
};

template <const rectification::Config& C>
Stage stage_entry(std::string name, std::string use, std::string family, std::string source_folder) {
   using Core = rectification::Core<C>;
   return {std::move(name),
           std::move(use),
           std::move(family),
           std::move(source_folder),
           C,
           {C, C.width_px, 2 * C.pixel_bits, 1, Core::kSchedule, {}, C.pixel_bits},
           option_values(C),
           changed_options(C),
           [](HeapMemories& memories) -> std::unique_ptr<ClockedRectification> {
              return std::make_unique<ClockedRectificationOf<C>>(memories);
           }};
}

/// Those of hls/rectification/configurations.hpp, sorted by name.
const std::vector<Stage>& stages();

/// nullptr when there is none of that name.
const Stage* find_stage(const std::string& name);

}  // namespace stereo
