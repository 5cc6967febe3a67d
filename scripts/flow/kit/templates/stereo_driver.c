/* SPDX-License-Identifier: Apache-2.0 */
#include "stereo_driver.h"

#include "stereo_registers.h"

static uint32_t get(const stereo_device *device, uint32_t offset) { return device->read(device->context, offset); }

static void set(const stereo_device *device, uint32_t offset, uint32_t value) {
   device->write(device->context, offset, value);
}

static uint32_t read_memory(void *context, uint32_t offset) { return ((volatile uint32_t *)context)[offset / 4]; }

static void write_memory(void *context, uint32_t offset, uint32_t value) {
   ((volatile uint32_t *)context)[offset / 4] = value;
}

stereo_device stereo_at(volatile uint32_t *registers) {
   stereo_device device = {read_memory, write_memory, 0};
   device.context = (void *)registers;
   return device;
}

/* Later versions of one major number keep what earlier ones have: major in bits 31 ... 16, minor in 15 ... 8. */
static int fits(uint32_t version) {
   const uint32_t wanted = STEREO_VERSION_VALUE;
   return version >> 16 == wanted >> 16 && (version >> 8 & 255) >= (wanted >> 8 & 255);
}

stereo_result stereo_check(const stereo_device *device) {
   if (get(device, STEREO_ID_OFFSET) != STEREO_ID_VALUE) return STEREO_NO_STEREO_IP;
   if (!fits(get(device, STEREO_VERSION_OFFSET))) return STEREO_OTHER_VERSION;
   if (get(device, STEREO_CORE_OFFSET) != STEREO_CORE_VALUE) return STEREO_OTHER_CORE;
   return STEREO_OK;
}

const char *stereo_text(stereo_result result) {
   switch (result) {
      case STEREO_OK:
         return "ok";
      case STEREO_NO_STEREO_IP:
         return "no stereo_ip at this address";
      case STEREO_OTHER_VERSION:
         return "stereo_ip of another version";
      case STEREO_OTHER_CORE:
         return "stereo_ip of another configuration";
      case STEREO_NO_ANSWER:
         return "the reset did not end";
   }
   return "unknown result";
}

static unsigned field(uint32_t value, uint32_t mask, unsigned shift) { return (unsigned)((value & mask) >> shift); }

stereo_size stereo_read_size(const stereo_device *device) {
   const uint32_t size = get(device, STEREO_SIZE_OFFSET);
   const uint32_t matching = get(device, STEREO_MATCHING_OFFSET);
   const uint32_t map = get(device, STEREO_MAP_OFFSET);
   stereo_size result;
   result.width_px = field(size, STEREO_SIZE_WIDTH_PX_MASK, STEREO_SIZE_WIDTH_PX_SHIFT);
   result.height_px = field(size, STEREO_SIZE_HEIGHT_PX_MASK, STEREO_SIZE_HEIGHT_PX_SHIFT);
   result.disparities = field(matching, STEREO_MATCHING_DISPARITIES_MASK, STEREO_MATCHING_DISPARITIES_SHIFT);
   result.pixels_per_clock =
       field(matching, STEREO_MATCHING_PIXELS_PER_CLOCK_MASK, STEREO_MATCHING_PIXELS_PER_CLOCK_SHIFT);
   result.output_width_px = field(map, STEREO_MAP_OUTPUT_WIDTH_PX_MASK, STEREO_MAP_OUTPUT_WIDTH_PX_SHIFT);
   result.disparity_bits = field(map, STEREO_MAP_DISPARITY_BITS_MASK, STEREO_MAP_DISPARITY_BITS_SHIFT);
   return result;
}

void stereo_start(const stereo_device *device) { set(device, STEREO_CONTROL_OFFSET, STEREO_CONTROL_ENABLE_MASK); }

void stereo_stop(const stereo_device *device) { set(device, STEREO_CONTROL_OFFSET, 0); }

int stereo_is_busy(const stereo_device *device) {
   return (get(device, STEREO_STATUS_OFFSET) & STEREO_STATUS_BUSY_MASK) != 0;
}

stereo_result stereo_reset(const stereo_device *device, unsigned long tries) {
   const uint32_t control = get(device, STEREO_CONTROL_OFFSET);
   set(device, STEREO_CONTROL_OFFSET, control | STEREO_CONTROL_SOFT_RESET_MASK);
   while (tries-- > 0) {
      if ((get(device, STEREO_CONTROL_OFFSET) & STEREO_CONTROL_SOFT_RESET_MASK) == 0) return STEREO_OK;
   }
   return STEREO_NO_ANSWER;
}

uint32_t stereo_frames(const stereo_device *device) { return get(device, STEREO_FRAMES_OFFSET); }

uint32_t stereo_broken_frames(const stereo_device *device) { return get(device, STEREO_BROKEN_FRAMES_OFFSET); }

uint32_t stereo_frame_clocks(const stereo_device *device) { return get(device, STEREO_FRAME_CLOCKS_OFFSET); }

uint32_t stereo_largest(const stereo_device *device, uint32_t offset) { return get(device, offset) >> 16; }

uint32_t stereo_setting(const stereo_device *device, uint32_t offset) { return get(device, offset) & 0xffffu; }

int stereo_set(const stereo_device *device, uint32_t offset, uint32_t value) {
   const uint32_t largest = stereo_largest(device, offset);
   if (largest == 0 || value > largest) return 0; /* 0: this core has no such setting */
   set(device, offset, value);
   return stereo_setting(device, offset) == value;
}

void stereo_interrupts(const stereo_device *device, uint32_t mask) {
   set(device, STEREO_INTERRUPT_OFFSET,
       mask & (STEREO_INTERRUPT_FRAME_DONE_ENABLE_MASK | STEREO_INTERRUPT_ANY_ERROR_ENABLE_MASK));
}

int stereo_take_frame_done(const stereo_device *device) {
   const uint32_t value = get(device, STEREO_INTERRUPT_OFFSET);
   if ((value & STEREO_INTERRUPT_FRAME_DONE_MASK) == 0) return 0;
   set(device, STEREO_INTERRUPT_OFFSET, value);
   return 1;
}

uint32_t stereo_take_errors(const stereo_device *device) {
   const uint32_t errors = get(device, STEREO_STATUS_OFFSET) & STEREO_STATUS_CLEARED_BY_1;
   if (errors != 0) set(device, STEREO_STATUS_OFFSET, errors);
   return errors;
}
