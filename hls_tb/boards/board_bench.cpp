// SPDX-License-Identifier: Apache-2.0
// Plays board_top over its serial line, for whole images; examples/boards/tb_board_top.vhd does the same in VHDL.
//   bench GIVEN ANSWER MAPS
// First waits until the self test has shown MAPS right maps. GIVEN: a number a line: a byte; 256: a byte of zeros
// without a stop bit; -n: a pause of n bits. ANSWER: the bytes that came back, a number a line, -1 for one without a
// stop bit; then "leds" and what the LEDs show once the line has been quiet.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "Vdesign.h"
#include "verilated.h"

namespace {

constexpr int kClocksPerBit = 4;  // as play.py builds it
constexpr int kStopBits = 2;      // of the bytes to the board
constexpr long kQuietClocks = 2000 * kClocksPerBit;
constexpr long kClocksOfAMap = 30'000'000;
constexpr long kReportedBytes = 20'000;

/// Bytes from the board.
class Receiver {
  public:
   explicit Receiver(std::FILE* answer) : answer_(answer) {}

   void clock(bool line) {
      if (bits_left_ == 0) {
         if (was_ && !line) {
            bits_left_ = 10;
            clocks_left_ = kClocksPerBit / 2;
         }
      } else if (--clocks_left_ == 0) {
         clocks_left_ = kClocksPerBit;
         --bits_left_;
         if (bits_left_ == 0) {
            std::fprintf(answer_, "%d\n", line ? static_cast<int>(byte_) : -1);
            if (++bytes_ % kReportedBytes == 0) {
               std::printf("%ld bytes came back\n", bytes_);
               std::fflush(stdout);
            }
         } else {
            byte_ = byte_ >> 1 | (line ? 128U : 0U);
         }
      }
      was_ = line;
      quiet_clocks_ = bits_left_ == 0 ? quiet_clocks_ + 1 : 0;
   }

   long quiet_clocks() const { return quiet_clocks_; }
   void begin_quiet() { quiet_clocks_ = 0; }

  private:
   std::FILE* answer_;
   bool was_ = true;
   int bits_left_ = 0, clocks_left_ = 0;
   unsigned byte_ = 0;
   long quiet_clocks_ = 0, bytes_ = 0;
};

class Board {
  public:
   explicit Board(std::FILE* answer) : receiver_(answer) {
      model_.rx = 1;
      model_.button = 0;
   }

   void clocks(long number) {
      for (long i = 0; i < number; ++i) {
         model_.clock = 0;
         model_.eval();
         model_.clock = 1;
         model_.eval();
         receiver_.clock(model_.tx != 0);
      }
   }

   void send(int number) {
      model_.rx = 0;
      clocks(kClocksPerBit);
      for (int bit = 0; bit < 8; ++bit) {
         model_.rx = number >> bit & 1;
         clocks(kClocksPerBit);
      }
      model_.rx = number < 256;
      clocks(kClocksPerBit);
      model_.rx = 1;
      clocks((kStopBits - 1) * kClocksPerBit);
   }

   /// Whether that many maps have come, the last one right.
   bool shows_maps(unsigned maps) {
      for (long clock = 0; clock < kClocksOfAMap * maps; ++clock) {
         clocks(1);
         if (model_.led >> 2 == maps) return (model_.led & 3) == 1;
      }
      return false;
   }

   /// Until nothing has come for some time; what came before does not count.
   void be_quiet() {
      receiver_.begin_quiet();
      do {
         clocks(1);
      } while (receiver_.quiet_clocks() < kQuietClocks);
   }

   std::string leds() {
      std::string text;
      for (int bit = 7; bit >= 0; --bit) text += model_.led >> bit & 1 ? '1' : '0';
      return text;
   }

  private:
   Vdesign model_;
   Receiver receiver_;
};

}  // namespace

int main(int count, char** words) {
   if (count != 4) return 2;
   std::FILE* given = std::fopen(words[1], "r");
   std::FILE* answer = std::fopen(words[2], "w");
   if (!given || !answer) {
      std::fprintf(stderr, "error: %s or %s cannot be opened\n", words[1], words[2]);
      return 2;
   }
   Board board(answer);
   const unsigned maps = static_cast<unsigned>(std::atoi(words[3]));
   if (maps != 0 && !board.shows_maps(maps)) {
      std::fprintf(stderr, "error: the self test shows LEDs %s\n", board.leds().c_str());
      return 1;
   }
   board.clocks(10);
   int number = 0;
   while (std::fscanf(given, "%d", &number) == 1) {
      if (number < 0) board.clocks(-static_cast<long>(number) * kClocksPerBit);
      else board.send(number);
   }
   board.be_quiet();
   std::fprintf(answer, "leds %s\n", board.leds().c_str());
   std::fclose(answer);
   return 0;
}
