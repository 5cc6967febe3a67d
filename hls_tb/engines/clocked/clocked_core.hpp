// SPDX-License-Identifier: Apache-2.0
// A core of any family in native code: one call of `clock` is one clock of the hardware.
#pragma once

#include <memory>
#include <vector>

#include "engines/clocked/core_shape.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/register_list.hpp"
#include "engines/clocked/option_list.hpp"
#include "support/ports.hpp"

namespace stereo {

class ClockedCore {
  public:
   virtual ~ClockedCore() = default;
   /// What the registers show in this clock.
   virtual StereoOutput output() const = 0;
   /// The clock edge.
   virtual void clock(const StereoInput& in) = 0;
   /// All registers, in data-flow order.
   virtual std::vector<RegisterView> registers() = 0;
};

/// What the module of a configuration holds. `make`: a core in the state after a reset; `memories` may hold what a core
/// before the reset has left there, and must live as long as the core.
struct CoreModule {
   const char* interface;  ///< digest of the headers that a program and its modules share
   const char* family;
   const char* name;
   CoreShape shape;
   void (*options)(OptionSink& sink);  ///< gives all of the configuration
   std::unique_ptr<ClockedCore> (*make)(HeapMemories& memories);
};

/// `Core`: the core of a family for one configuration. This class is all that the project asks of a family's core.
template <class Core>
class ClockedCoreOf final : public ClockedCore {
  public:
   explicit ClockedCoreOf(HeapMemories& memories) : core_(memories) {}

   StereoOutput output() const override { return core_.output(); }
   void clock(const StereoInput& in) override { core_.clock(in); }
   std::vector<RegisterView> registers() override {
      std::vector<RegisterView> list;
      RegisterLister lister(list);
      core_.registers(lister);
      return list;
   }
   const Core& core() const { return core_; }

  private:
   Core core_;
};

template <class Core>
void list_options(OptionSink& sink) {
   OptionLister lister{sink};
   std::remove_cvref_t<decltype(Core::kConfig)>::options(Core::kConfig, lister);
}

template <class Core>
std::unique_ptr<ClockedCore> make_clocked_core(HeapMemories& memories) {
   return std::make_unique<ClockedCoreOf<Core>>(memories);
}

}  // namespace stereo
