// SPDX-License-Identifier: Apache-2.0
// How threads share an image whose rows depend on the rows above them.
#pragma once

#include <algorithm>
#include <atomic>
#include <vector>

namespace stereo::semi_global {

/// Bands of rows, taken from the top by any number of threads. What needs the rows above comes block of columns by
/// block of columns: a thread enters a block when the thread of the band above has left it, so that bands follow one
/// another at the distance of one block.
///
/// A thread that has taken a band must finish it, or the others wait for ever: it allocates what it needs before.
class RowBands {
  public:
   RowBands(int rows, int columns, int rows_of_band, int columns_of_block)
       : rows_(rows),
         columns_(columns),
         rows_of_band_(rows_of_band),
         columns_of_block_(columns_of_block),
         bands_behind_(std::size_t((columns + columns_of_block - 1) / columns_of_block)) {}

   /// The next band's number; count() when there is none.
   int take() { return std::min(next_.fetch_add(1), count()); }
   int count() const { return (rows_ + rows_of_band_ - 1) / rows_of_band_; }
   int rows_of_band() const { return rows_of_band_; }
   int first_row(int band) const { return band * rows_of_band_; }
   int end_row(int band) const { return std::min(rows_, first_row(band) + rows_of_band_); }

   int blocks() const { return int(bands_behind_.size()); }
   int first_column(int block) const { return block * columns_of_block_; }
   int end_column(int block) const { return std::min(columns_, first_column(block) + columns_of_block_); }

   /// Waits until the band above has left the block.
   void enter(int block, int band) {
      std::atomic<int>& behind = bands_behind_[std::size_t(block)];
      for (int done = behind.load(); done != band; done = behind.load()) behind.wait(done);
   }
   void leave(int block, int band) {
      std::atomic<int>& behind = bands_behind_[std::size_t(block)];
      behind.store(band + 1);
      behind.notify_all();
   }

  private:
   int rows_, columns_, rows_of_band_, columns_of_block_;
   std::atomic<int> next_ = 0;
   std::vector<std::atomic<int>> bands_behind_;  ///< [block]: bands that have left it
};

}  // namespace stereo::semi_global
