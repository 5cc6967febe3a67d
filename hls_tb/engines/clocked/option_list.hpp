// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "support/options.hpp"

namespace stereo {

/// Takes the options of a core. Texts, so that a module holds no more than it must.
class OptionSink {
  public:
   virtual ~OptionSink() = default;
   virtual void number(const char* name, int value) = 0;
   /// A flag or a choice.
   virtual void word(const char* name, const char* value) = 0;
};

/// The visitor that hands all options of a list on.
struct OptionLister {
   OptionSink& sink;

   void operator()(const char* name, int value, int, int, const char*) { sink.number(name, value); }
   template <class Choice>
   void operator()(const char* name, const Choice& value) {
      sink.word(name, Words<Choice>::kWords[static_cast<int>(value)]);
   }
};

}  // namespace stereo
