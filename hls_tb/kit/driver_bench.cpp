// SPDX-License-Identifier: Apache-2.0
// The driver of a kit on the registers of its VHDL, while frames go through: whole ones, a broken one, none.
// Says each thing that is wrong; the exit code is 1 then.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "Vdesign.h"
#include "stereo_driver.h"
#include "stereo_registers.h"
#include "verilated.h"

namespace {

constexpr int kMovedPx = 2;     // of the left image: the disparity of every pixel
constexpr int kPatience = 200;  // clocks; a core that runs lets nobody wait so long
constexpr int kMostClocks = 200000;
int failures = 0;

void expect(bool holds, const char* what) {
   if (holds) return;
   std::printf("wrong: %s\n", what);
   failures++;
}

/// The design with a camera and a sink that never wait.
class Design {
  public:
   Design() {
      model_.m_axis_tready = model_.s_axil_bready = model_.s_axil_rready = 1;
      for (int i = 0; i < 4; i++) clock();
      model_.aresetn = 1;
      clock();
   }

   uint32_t read(uint32_t offset) {
      model_.s_axil_araddr = offset;
      model_.s_axil_arvalid = 1;
      await([&] { return model_.s_axil_arready; });
      model_.s_axil_arvalid = 0;
      uint32_t data = 0;
      await([&] { return data = model_.s_axil_rdata, model_.s_axil_rvalid; });
      return data;
   }

   void write(uint32_t offset, uint32_t value) {
      model_.s_axil_awaddr = offset;
      model_.s_axil_wdata = value;
      model_.s_axil_wstrb = 15;
      model_.s_axil_awvalid = model_.s_axil_wvalid = 1;
      bool address = false, data = false;
      while (!address || !data) {
         model_.eval();
         address |= model_.s_axil_awready;
         data |= model_.s_axil_wready;
         clock();
         if (address) model_.s_axil_awvalid = 0;
         if (data) model_.s_axil_wvalid = 0;
      }
      await([&] { return model_.s_axil_bvalid; });
   }

   /// Offers a beat; whether it was taken before the camera lost patience.
   bool send(uint16_t pair, bool start, bool end) {
      model_.s_axis_tvalid = 1;
      model_.s_axis_tdata = pair;
      model_.s_axis_tuser = start;
      model_.s_axis_tlast = end;
      bool taken = false;
      for (int i = 0; i < kPatience && !taken; i++) {
         model_.eval();
         taken = model_.s_axis_tready;
         clock();
      }
      if (taken) model_.s_axis_tvalid = 0;
      return taken;
   }

   void clock() {
      model_.eval();
      if (model_.m_axis_tvalid) {
         map.push_back(model_.m_axis_tdata & 255);
         valid += model_.m_axis_tdata >> 8 & 1;
      }
      model_.aclk = 1;
      model_.eval();
      model_.aclk = 0;
      model_.eval();
      if (++clocks_ > kMostClocks) {
         std::printf("wrong: it hangs\n");
         std::exit(1);
      }
   }

   std::vector<int> map;
   unsigned valid = 0;  ///< pixels of the maps so far

  private:
   /// Clocks until the handshake happened.
   template <class Ready>
   void await(Ready ready) {
      for (bool done = false; !done; clock()) {
         model_.eval();
         done = ready();
      }
   }

   Vdesign model_;
   int clocks_ = 0;
};

/// Starts a core that takes nothing, and says how often that was. A broken frame has an end of line too many.
int send_frame(Design& design, const stereo_device& device, const stereo_size& size, bool broken = false,
               bool related = true) {
   std::mt19937 random(2007);
   int starts = 0;
   for (unsigned y = 0; y < size.height_px; y++) {
      std::vector<int> noise(size.width_px + kMovedPx);
      for (int& pixel : noise) pixel = random() & 255;
      for (unsigned x = 0; x < size.width_px; x++) {
         const bool end = x == size.width_px - 1 || (broken && x == 3);
         const int left = related ? noise[x + kMovedPx] : random() & 255;
         while (!design.send(left << 8 | noise[x], x == 0 && y == 0, end)) {
            stereo_start(&device);
            starts++;
         }
      }
   }
   return starts;
}

void wait_until_idle(Design& design, const stereo_device& device) {
   while (stereo_is_busy(&device)) design.clock();
}

/// Valid pixels of two unrelated images: how many there are is up to the settings.
unsigned valid_pixels(Design& design, const stereo_device& device, const stereo_size& size) {
   const unsigned before = design.valid;
   send_frame(design, device, size, false, false);
   wait_until_idle(design, device);
   return design.valid - before;
}

/// Settings of a core of block matching that has them.
void use_settings(Design& design, const stereo_device& device, const stereo_size& size) {
   const uint32_t unique = STEREO_UNIQUENESS_PERCENT_OFFSET, left_right = STEREO_LEFT_RIGHT_THRESHOLD_OFFSET;
   const unsigned pixels = size.output_width_px * size.height_px;
   expect(stereo_largest(&device, unique) == 100, "the largest uniqueness");
   expect(stereo_largest(&device, left_right) == size.disparities - 1, "the largest left/right threshold");
   expect(stereo_set(&device, unique, 0) && stereo_set(&device, left_right, size.disparities - 1),
          "a setting is refused");
   expect(valid_pixels(design, device, size) == pixels, "a check that is off drops pixels");
   expect(stereo_set(&device, unique, 100), "the largest setting is refused");
   const unsigned unique_ones = valid_pixels(design, device, size);
   expect(unique_ones < pixels / 2, "the uniqueness check has no effect");
   expect(!stereo_set(&device, unique, 101) && stereo_setting(&device, unique) == 100, "a setting beyond its limit");
   expect(stereo_take_errors(&device) == 0, "a setting that the driver refuses reaches the core");
   device.write(device.context, unique, 101);
   expect(stereo_take_errors(&device) == STEREO_STATUS_SETTING_REFUSED_MASK, "a refused setting is no error");
   expect(valid_pixels(design, device, size) == unique_ones, "a refused setting has an effect");
   expect(stereo_set(&device, unique, 0) && stereo_set(&device, left_right, 0), "0 is refused");
   const unsigned consistent = valid_pixels(design, device, size);
   expect(consistent > 0 && consistent < pixels, "the left/right check has no effect");
   expect(stereo_set(&device, left_right, size.disparities - 1), "a setting is refused");
   expect(valid_pixels(design, device, size) == pixels, "settings do not come back");
}

uint32_t read_design(void* context, uint32_t offset) { return static_cast<Design*>(context)->read(offset); }
void write_design(void* context, uint32_t offset, uint32_t value) {
   static_cast<Design*>(context)->write(offset, value);
}

}  // namespace

int main() {
   Design design;
   const stereo_device device = {read_design, write_design, &design};
   expect(stereo_check(&device) == STEREO_OK, stereo_text(stereo_check(&device)));
   const stereo_size size = stereo_read_size(&device);
   expect(size.width_px == (STEREO_SIZE_VALUE & 65535) && size.pixels_per_clock == 1, "size");

   stereo_stop(&device);
   expect(send_frame(design, device, size) == 1, "a core does not stop, or does not start");
   wait_until_idle(design, device);
   expect(stereo_frames(&device) == 1 && stereo_broken_frames(&device) == 0, "a whole frame is not counted");
   expect(stereo_take_errors(&device) == 0, "a whole frame is an error");
   expect(stereo_frame_clocks(&device) > size.width_px * size.height_px, "clocks of a frame");
   unsigned right = 0;
   for (int disparity : design.map) right += disparity == kMovedPx;
   const unsigned pixels = size.output_width_px * size.height_px;
   expect(design.map.size() == pixels, "the map has another size");
   expect(right == pixels, "a disparity is wrong");

   expect(send_frame(design, device, size, true) == 0, "a broken frame stops the core");
   wait_until_idle(design, device);
   expect(stereo_frames(&device) == 1 && stereo_broken_frames(&device) == 1, "a broken frame is not counted");
   const uint32_t errors = stereo_take_errors(&device);
   expect((errors & STEREO_STATUS_EARLY_LINE_END_MASK) != 0, "an early end of line is not seen");
   expect(stereo_take_errors(&device) == 0, "errors are not cleared");

   expect(stereo_reset(&device, 1000) == STEREO_OK, "a reset does not end");
   expect(stereo_frames(&device) == 0 && stereo_broken_frames(&device) == 0, "a reset does not clear the counters");
   expect(send_frame(design, device, size) == 0, "a reset stops the core");
   wait_until_idle(design, device);
   expect(stereo_frames(&device) == 1, "no frame comes after a reset");
   if (stereo_largest(&device, STEREO_UNIQUENESS_PERCENT_OFFSET) > 0) use_settings(design, device, size);
   std::printf("%u of %u disparities right, %d wrong\n", right, pixels, failures);
   return failures != 0;
}
