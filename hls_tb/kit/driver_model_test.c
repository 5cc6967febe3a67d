/* SPDX-License-Identifier: Apache-2.0 */
/* The driver of a kit against a model of the registers in C. Says each thing that is wrong; the exit code is 1 then. */
#include <stdio.h>
#include <string.h>

#include "stereo_driver.h"
#include "stereo_registers.h"

#define WORDS 32
#define CLOCKS_OF_A_RESET 3 /* counted in reads */
/* The words of the settings; their names are those of the family. */
#define FIRST_SETTING 0x30u
#define LAST_SETTING 0x4cu

typedef struct {
   uint32_t word[WORDS];
   int reset_reads; /* until it is done; negative: never */
} model;

static int failures = 0;

static void expect(int holds, const char *what) {
   if (holds) return;
   printf("wrong: %s\n", what);
   failures++;
}

static uint32_t *at(model *registers, uint32_t offset) { return &registers->word[offset / 4]; }

static uint32_t model_read(void *context, uint32_t offset) {
   model *registers = (model *)context;
   if (offset == STEREO_CONTROL_OFFSET && registers->reset_reads > 0 && --registers->reset_reads == 0) {
      *at(registers, offset) &= ~(uint32_t)STEREO_CONTROL_SOFT_RESET_MASK;
      *at(registers, STEREO_STATUS_OFFSET) &= ~(uint32_t)STEREO_STATUS_CLEARED_BY_1;
      *at(registers, STEREO_FRAMES_OFFSET) = *at(registers, STEREO_BROKEN_FRAMES_OFFSET) = 0;
   }
   return *at(registers, offset);
}

static void model_write(void *context, uint32_t offset, uint32_t value) {
   model *registers = (model *)context;
   if (offset == STEREO_CONTROL_OFFSET) {
      *at(registers, offset) = value & (STEREO_CONTROL_ENABLE_MASK | STEREO_CONTROL_SOFT_RESET_MASK);
      if ((value & STEREO_CONTROL_SOFT_RESET_MASK) != 0 && registers->reset_reads == 0) {
         registers->reset_reads = CLOCKS_OF_A_RESET;
      }
   } else if (offset == STEREO_STATUS_OFFSET) {
      *at(registers, offset) &= ~(value & STEREO_STATUS_CLEARED_BY_1);
   } else if (offset == STEREO_INTERRUPT_OFFSET) {
      const uint32_t enables = STEREO_INTERRUPT_FRAME_DONE_ENABLE_MASK | STEREO_INTERRUPT_ANY_ERROR_ENABLE_MASK;
      const uint32_t left = *at(registers, offset) & ~(value & STEREO_INTERRUPT_CLEARED_BY_1);
      *at(registers, offset) = (left & ~enables) | (value & enables);
   } else if (offset >= FIRST_SETTING && offset <= LAST_SETTING) {
      const uint32_t largest = *at(registers, offset) >> 16;
      expect(value <= largest, "a setting beyond its limit is written");
      *at(registers, offset) = largest << 16 | value;
   } else {
      expect(0, "a register is written that cannot be");
   }
}

static model fresh(void) {
   model registers;
   memset(&registers, 0, sizeof registers);
   *at(&registers, STEREO_ID_OFFSET) = STEREO_ID_VALUE;
   *at(&registers, STEREO_VERSION_OFFSET) = STEREO_VERSION_VALUE;
   *at(&registers, STEREO_CORE_OFFSET) = STEREO_CORE_VALUE;
   return registers;
}

static stereo_result check_with(uint32_t offset, uint32_t value) {
   model registers = fresh();
   stereo_device device = {model_read, model_write, 0};
   device.context = &registers;
   *at(&registers, offset) = value;
   return stereo_check(&device);
}

static void test_check(void) {
   const uint32_t version = STEREO_VERSION_VALUE;
   expect(check_with(STEREO_ID_OFFSET, STEREO_ID_VALUE) == STEREO_OK, "the right core is refused");
   expect(check_with(STEREO_ID_OFFSET, 0xffffffffu) == STEREO_NO_STEREO_IP, "an empty bus is taken for a core");
   expect(check_with(STEREO_VERSION_OFFSET, version + 0x10000u) == STEREO_OTHER_VERSION,
          "another major version is taken");
   expect(check_with(STEREO_VERSION_OFFSET, version + 0x100u) == STEREO_OK, "a later minor version is refused");
   expect(check_with(STEREO_VERSION_OFFSET, version + 1u) == STEREO_OK, "a later patch is refused");
   expect(check_with(STEREO_CORE_OFFSET, ~STEREO_CORE_VALUE) == STEREO_OTHER_CORE, "another core is taken");
}

static void test_use(void) {
   model registers = fresh();
   stereo_device device = {model_read, model_write, 0};
   stereo_size size;
   device.context = &registers;

   *at(&registers, STEREO_SIZE_OFFSET) = 480u << 16 | 640u;
   *at(&registers, STEREO_MATCHING_OFFSET) = 2u << 24 | 64u;
   *at(&registers, STEREO_MAP_OFFSET) = 16u << 16 | 576u;
   size = stereo_read_size(&device);
   expect(size.width_px == 640 && size.height_px == 480, "size of the image");
   expect(size.disparities == 64 && size.pixels_per_clock == 2, "disparities, pixels a clock");
   expect(size.output_width_px == 576 && size.disparity_bits == 16, "size of the map");

   stereo_start(&device);
   expect(*at(&registers, STEREO_CONTROL_OFFSET) == STEREO_CONTROL_ENABLE_MASK, "start does not enable");
   *at(&registers, STEREO_FRAMES_OFFSET) = 7;
   *at(&registers, STEREO_BROKEN_FRAMES_OFFSET) = 5;
   *at(&registers, STEREO_FRAME_CLOCKS_OFFSET) = 77141;
   expect(stereo_frames(&device) == 7, "frames");
   expect(stereo_broken_frames(&device) == 5, "broken frames");
   expect(stereo_frame_clocks(&device) == 77141, "clocks of a frame");

   *at(&registers, STEREO_STATUS_OFFSET) = STEREO_STATUS_BUSY_MASK | STEREO_STATUS_EARLY_START_MASK;
   expect(stereo_is_busy(&device), "busy");
   expect(stereo_take_errors(&device) == STEREO_STATUS_EARLY_START_MASK, "an error is not seen, or busy is one");
   expect(stereo_take_errors(&device) == 0, "an error is not cleared");

   expect(stereo_reset(&device, 10) == STEREO_OK, "a reset does not end");
   expect(stereo_frames(&device) == 0, "a reset does nothing");
   expect(*at(&registers, STEREO_CONTROL_OFFSET) == STEREO_CONTROL_ENABLE_MASK, "a reset changes enable");
   registers.reset_reads = -1;
   expect(stereo_reset(&device, 10) == STEREO_NO_ANSWER, "a reset that does not end is not noticed");

   registers.reset_reads = 0;
   stereo_stop(&device);
   expect(*at(&registers, STEREO_CONTROL_OFFSET) == 0, "stop does not disable");
}

static void test_settings(void) {
   model registers = fresh();
   stereo_device device = {model_read, model_write, 0};
   uint32_t offset;
   device.context = &registers;
   for (offset = FIRST_SETTING; offset <= LAST_SETTING; offset += 4)
      *at(&registers, offset) = (offset + 300u) << 16 | offset;
   for (offset = FIRST_SETTING; offset <= LAST_SETTING; offset += 4) {
      expect(stereo_largest(&device, offset) == offset + 300u, "the largest value of a setting");
      expect(stereo_setting(&device, offset) == offset, "the value of a setting");
      expect(stereo_set(&device, offset, offset + 300u), "the largest value is refused");
      expect(stereo_setting(&device, offset) == offset + 300u, "a setting is not written");
      expect(!stereo_set(&device, offset, offset + 301u), "a value beyond the limit is taken");
      expect(stereo_setting(&device, offset) == offset + 300u, "a refused setting has changed");
      expect(stereo_set(&device, offset, 0) && stereo_setting(&device, offset) == 0, "a setting of 0");
   }
   *at(&registers, STEREO_LEFT_RIGHT_THRESHOLD_OFFSET) = 0;
   expect(!stereo_set(&device, STEREO_LEFT_RIGHT_THRESHOLD_OFFSET, 0), "a core without a setting takes 0");
   expect(!stereo_set(&device, STEREO_LEFT_RIGHT_THRESHOLD_OFFSET, 1), "a core without a setting takes one");
}

static void test_interrupts(void) {
   const uint32_t both = STEREO_INTERRUPT_FRAME_DONE_ENABLE_MASK | STEREO_INTERRUPT_ANY_ERROR_ENABLE_MASK;
   model registers = fresh();
   stereo_device device = {model_read, model_write, 0};
   uint32_t *interrupt = at(&registers, STEREO_INTERRUPT_OFFSET);
   device.context = &registers;
   *interrupt = STEREO_INTERRUPT_FRAME_DONE_MASK;
   stereo_interrupts(&device, 0xffffffffu);
   expect(*interrupt == (both | STEREO_INTERRUPT_FRAME_DONE_MASK), "interrupts are not enabled, or one is lost");
   expect(stereo_take_frame_done(&device) && *interrupt == both, "a frame that is done is not seen, or not cleared");
   expect(!stereo_take_frame_done(&device), "a frame is done twice");
   stereo_interrupts(&device, 0);
   expect(*interrupt == 0, "interrupts are not disabled");
}

static void test_memory(void) {
   static volatile uint32_t memory[WORDS];
   const stereo_device device = stereo_at(memory);
   memory[STEREO_ID_OFFSET / 4] = STEREO_ID_VALUE;
   memory[STEREO_VERSION_OFFSET / 4] = STEREO_VERSION_VALUE;
   memory[STEREO_CORE_OFFSET / 4] = STEREO_CORE_VALUE;
   expect(stereo_check(&device) == STEREO_OK, "registers in memory are not read");
   stereo_start(&device);
   expect(memory[STEREO_CONTROL_OFFSET / 4] == STEREO_CONTROL_ENABLE_MASK, "registers in memory are not written");
}

int main(void) {
   test_check();
   test_use();
   test_settings();
   test_interrupts();
   test_memory();
   printf("%d wrong\n", failures);
   return failures != 0;
}
