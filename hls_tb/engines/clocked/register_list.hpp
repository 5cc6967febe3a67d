// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace stereo {

/// One register of a core: a member of one of its blocks.
struct RegisterView {
   std::string name;     ///< BLOCK_MEMBER_INDEX; the part before the first '_' is the block
   const void* address;  ///< the member, as long as the core lives
   /// Its value as a number: `bits` in two's complement.
   struct Value {
      uint64_t bits;
      bool negative;
   };
   Value (*read)(const void*);

   Value value() const { return read(address); }
};

/// The visitor that lists the registers of a block and of the blocks inside it, in the order of their lists.
class RegisterLister {
  public:
   explicit RegisterLister(std::vector<RegisterView>& list) : list_(list) {}

   template <class T>
   void operator()(const char* name, T& value, int = 0) {
      add(joined(name), value);
   }
   template <class Block>
   void block(const char* name, Block& inner, int number = -1) {
      const std::string outer = prefix_;
      prefix_ += name + (number < 0 ? std::string() : std::to_string(number));
      inner.registers(*this);
      prefix_ = outer;
   }

  private:
   std::string joined(const std::string& name) const { return prefix_.empty() ? name : prefix_ + "_" + name; }

   template <class T>
   void add(const std::string& name, T& value) {
      if constexpr (std::is_array_v<T>) {
         for (std::size_t i = 0; i < std::extent_v<T>; ++i) add(name + "_" + std::to_string(i), value[i]);
      } else if constexpr (std::is_class_v<T>) {
         const std::string outer = prefix_;
         prefix_ = name;
         value.registers(*this);
         prefix_ = outer;
      } else {
         list_.push_back({name, &value, &read<T>});
      }
   }

   template <class T>
   static RegisterView::Value read(const void* address) {
      const T value = *static_cast<const T*>(address);
      return {static_cast<uint64_t>(value), value < T(0)};
   }

   std::vector<RegisterView>& list_;
   std::string prefix_;
};

}  // namespace stereo
