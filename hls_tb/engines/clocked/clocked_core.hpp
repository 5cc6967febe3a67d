// SPDX-License-Identifier: Apache-2.0
// A core of any family in native code: one call of `clock` is one clock of the hardware.
#pragma once

#include <memory>
#include <vector>

#include "engines/clocked/core_shape.hpp"
#include "engines/clocked/heap_memories.hpp"
#include "engines/clocked/option_list.hpp"
#include "engines/clocked/register_list.hpp"
#include "support/ports.hpp"

namespace stereo {

class ClockedCore {
  public:
   virtual ~ClockedCore() = default;
   /// What the registers show in this clock.
   virtual PostOutput output() const = 0;
   /// The clock edge.
   virtual void clock(const WideInput& in) = 0;
   /// What the ports of the settings show from now on, in the order of CoreShape::settings; until then, what the
   /// configuration says. Nothing where there are no such ports.
   virtual void set(const std::vector<uint32_t>& settings) = 0;
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
   explicit ClockedCoreOf(HeapMemories& memories) : core_(memories) {
      std::vector<uint32_t> start;
      for (const Setting& setting : core_shape<Core>().settings) start.push_back(uint32_t(setting.start));
      set(start);
   }

   PostOutput output() const override {
      if constexpr (std::is_same_v<decltype(core_.output()), PostOutput>) return core_.output();
      else return {core_.output(), {}, {}};
   }
   void clock(const WideInput& in) override {
      if constexpr (kHasSettings) core_.clock(in, settings_);
      else core_.clock(in);
   }
   void set(const std::vector<uint32_t>& settings) override {
      if constexpr (kHasSettings) {
         SettingsReader reader{settings.data()};
         settings_.registers(reader);
      } else {
         static_cast<void>(settings);
      }
   }
   std::vector<RegisterView> registers() override {
      std::vector<RegisterView> list;
      RegisterLister lister(list);
      core_.registers(lister);
      return list;
   }
   const Core& core() const { return core_; }

  private:
   static constexpr bool kHasSettings = kHasSettingPorts<Core::kConfig>;
   struct None {};
   template <class C>
   struct SettingsOf {
      using Type = typename C::Settings;
   };
   struct NoneOf {
      using Type = None;
   };
   struct SettingsReader {
      const uint32_t* next;
      template <class T>
      void operator()(const char*, T& value) {
         value = T(*next++);
      }
   };

   Core core_;
   [[no_unique_address]] typename std::conditional_t<kHasSettings, SettingsOf<Core>, NoneOf>::Type settings_;
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
