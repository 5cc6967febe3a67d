// SPDX-License-Identifier: Apache-2.0
// Two cores of two kits in one design, each with its driver: stereo_tiny_... at the ports a_..., stereo_tiny_sgm_... at
// the ports b_... A frame goes through each. Says each thing that is wrong; the exit code is 1 then.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "Vdesign.h"
#include "stereo_tiny_driver.h"
#include "stereo_tiny_registers.h"
#include "stereo_tiny_sgm_driver.h"
#include "stereo_tiny_sgm_registers.h"
#include "verilated.h"

namespace {

constexpr int kMostClocks = 100000;
int failures = 0;

void expect(bool holds, const char* what) {
   if (holds) return;
   std::printf("wrong: %s\n", what);
   failures++;
}

struct Design {
   Vdesign model;
   int clocks = 0;

   Design() {
      model.a_m_axis_tready = model.a_s_axil_bready = model.a_s_axil_rready = 1;
      model.b_m_axis_tready = model.b_s_axil_bready = model.b_s_axil_rready = 1;
      for (int i = 0; i < 4; i++) clock();
      model.aresetn = 1;
      clock();
   }

   void clock() {
      model.aclk = 1;
      model.eval();
      model.aclk = 0;
      model.eval();
      if (++clocks > kMostClocks) {
         std::printf("wrong: it hangs\n");
         std::exit(1);
      }
   }

   /// Clocks until `signal` was 1 in one.
   template <class Signal>
   void await(const Signal& signal) {
      bool done = false;
      while (!done) {
         model.eval();
         done = signal;
         clock();
      }
   }
};

// The registers and the stream of the core at the ports PORT_...
#define CORE(PORT)                                                                           \
   uint32_t PORT##_read(void* context, uint32_t offset) {                                    \
      Design& design = *static_cast<Design*>(context);                                       \
      design.model.PORT##_s_axil_araddr = offset;                                            \
      design.model.PORT##_s_axil_arvalid = 1;                                                \
      design.await(design.model.PORT##_s_axil_arready);                                      \
      design.model.PORT##_s_axil_arvalid = 0;                                                \
      while (design.model.eval(), !design.model.PORT##_s_axil_rvalid) design.clock();        \
      const uint32_t data = design.model.PORT##_s_axil_rdata;                                \
      design.clock();                                                                        \
      return data;                                                                           \
   }                                                                                         \
   void PORT##_write(void* context, uint32_t offset, uint32_t value) {                       \
      Design& design = *static_cast<Design*>(context);                                       \
      design.model.PORT##_s_axil_awaddr = offset;                                            \
      design.model.PORT##_s_axil_wdata = value;                                              \
      design.model.PORT##_s_axil_wstrb = 15;                                                 \
      design.model.PORT##_s_axil_awvalid = design.model.PORT##_s_axil_wvalid = 1;            \
      bool address = false, data = false;                                                    \
      while (!address || !data) {                                                            \
         design.model.eval();                                                                \
         address |= design.model.PORT##_s_axil_awready;                                      \
         data |= design.model.PORT##_s_axil_wready;                                          \
         design.clock();                                                                     \
         if (address) design.model.PORT##_s_axil_awvalid = 0;                                \
         if (data) design.model.PORT##_s_axil_wvalid = 0;                                    \
      }                                                                                      \
      design.await(design.model.PORT##_s_axil_bvalid);                                       \
   }                                                                                         \
   void PORT##_send(Design& design, unsigned width, unsigned height) {                       \
      for (unsigned i = 0; i < width * height; i++) {                                        \
         design.model.PORT##_s_axis_tvalid = 1;                                              \
         design.model.PORT##_s_axis_tdata = i * 2654435761u >> 16;                           \
         design.model.PORT##_s_axis_tuser = i == 0;                                          \
         design.model.PORT##_s_axis_tlast = i % width == width - 1;                          \
         design.await(design.model.PORT##_s_axis_tready);                                    \
      }                                                                                      \
      design.model.PORT##_s_axis_tvalid = 0;                                                 \
   }
CORE(a)
CORE(b)

}  // namespace

int main() {
   Design design;
   const stereo_tiny_device a = {a_read, a_write, &design};
   const stereo_tiny_sgm_device b = {b_read, b_write, &design};
   expect(stereo_tiny_check(&a) == STEREO_TINY_OK, "the first core is not its own");
   expect(stereo_tiny_sgm_check(&b) == STEREO_TINY_SGM_OK, "the second core is not its own");
   const stereo_tiny_device b_as_a = {b_read, b_write, &design};
   const stereo_tiny_sgm_device a_as_b = {a_read, a_write, &design};
   expect(stereo_tiny_check(&b_as_a) == STEREO_TINY_OTHER_CORE, "the second core is taken for the first");
   expect(stereo_tiny_sgm_check(&a_as_b) == STEREO_TINY_SGM_OTHER_CORE, "the first core is taken for the second");

   const stereo_tiny_size a_size = stereo_tiny_read_size(&a);
   const stereo_tiny_sgm_size b_size = stereo_tiny_sgm_read_size(&b);
   expect(a_size.width_px == (STEREO_TINY_SIZE_VALUE & 65535), "size of the first");
   expect(b_size.width_px == (STEREO_TINY_SGM_SIZE_VALUE & 65535), "size of the second");

   stereo_tiny_sgm_stop(&b);
   a_send(design, a_size.width_px, a_size.height_px);
   while (stereo_tiny_is_busy(&a)) design.clock();
   expect(stereo_tiny_frames(&a) == 1 && stereo_tiny_sgm_frames(&b) == 0, "a frame through the first");
   stereo_tiny_sgm_start(&b);
   b_send(design, b_size.width_px, b_size.height_px);
   while (stereo_tiny_sgm_is_busy(&b)) design.clock();
   expect(stereo_tiny_frames(&a) == 1 && stereo_tiny_sgm_frames(&b) == 1, "a frame through the second");
   expect(stereo_tiny_take_errors(&a) == 0 && stereo_tiny_sgm_take_errors(&b) == 0, "errors");
   std::printf("%d wrong\n", failures);
   return failures != 0;
}
