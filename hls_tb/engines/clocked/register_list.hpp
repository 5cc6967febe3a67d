// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace stereo {

/// One register of a core: a member of one of its blocks.
struct RegisterView {
   /// The value of a register as a number, in two's complement.
   struct Value {
      uint64_t bits;
      bool negative;
   };

   std::string name;     ///< BLOCK_MEMBER_INDEX; the part before the first '_' is the block
   const void* address;  ///< the member, as long as the core lives
   Value (*read)(const void*);

   Value value() const { return read(address); }
};

/// The visitor that lists the registers of a block and of the blocks inside it, in the order of their lists. Templates only
/// say what a member is; the work is done once for all types (register_list.cpp), as every core is compiled with this.
class RegisterLister {
  public:
   explicit RegisterLister(std::vector<RegisterView>& list) : list_(list) {}

   template <class T>
   void operator()(const char* name, T& value, int = 0) {
      using Element = std::remove_all_extents_t<T>;
      Member member{&value, sizeof(Element), {}, nullptr, nullptr};
      extents<T>(member.extents);
      if constexpr (std::is_class_v<Element>) member.list = &list_record<Element>;
      else member.read = &read<Element>;
      add(name, member);
   }
   template <class Block>
   void block(const char* name, Block& inner, int number = -1) {
      add_block(name, number, &inner, &list_record<Block>);
   }

  private:
   using List = void (*)(void* record, RegisterLister& lister);
   static constexpr int kMostExtents = 4;
   struct Member {
      void* first;        ///< its first element
      std::size_t bytes;  ///< of an element
      std::size_t extents[kMostExtents];  ///< 0 behind the last
      List list;                          ///< of an element that is a record
      RegisterView::Value (*read)(const void*);
   };

   template <class T>
   static void extents(std::size_t (&sizes)[kMostExtents], int dimension = 0) {
      static_assert(std::rank_v<T> < kMostExtents);
      if constexpr (std::is_array_v<T>) {
         sizes[dimension] = std::extent_v<T>;
         extents<std::remove_extent_t<T>>(sizes, dimension + 1);
      }
   }
   template <class Record>
   static void list_record(void* record, RegisterLister& lister) {
      static_cast<Record*>(record)->registers(lister);
   }
   template <class T>
   static RegisterView::Value read(const void* address) {
      const T value = *static_cast<const T*>(address);
      return {static_cast<uint64_t>(value), value < T(0)};
   }

   void add(const char* name, const Member& member);
   void add_block(const char* name, int number, void* block, List list);
   void add_elements(const std::string& name, const Member& member, int dimension, std::size_t first, std::size_t count);

   std::vector<RegisterView>& list_;
   std::string prefix_;
};

}  // namespace stereo
