/* SPDX-License-Identifier: Apache-2.0 */
/* A driver for stereo_ip: C99, no library, no state of its own. */
#ifndef STEREO_DRIVER_H
#define STEREO_DRIVER_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How registers are reached: memory-mapped, through a bridge, or in a simulation. Offsets are in bytes. */
typedef struct {
   uint32_t (*read)(void *context, uint32_t offset);
   void (*write)(void *context, uint32_t offset, uint32_t value);
   void *context;
} stereo_device;

typedef enum {
   STEREO_OK,
   STEREO_NO_STEREO_IP, /* nothing there, or something else */
   STEREO_OTHER_VERSION,
   STEREO_OTHER_CORE, /* not the configuration of stereo_registers.h */
   STEREO_NO_ANSWER   /* a reset did not end */
} stereo_result;

typedef struct {
   unsigned width_px, height_px, disparities, pixels_per_clock, output_width_px, disparity_bits;
} stereo_size;

/* Registers at an address of this processor; it must be mapped as a device, without a cache. */
stereo_device stereo_at(volatile uint32_t *registers);

/* Is it the core that this driver was made for? Ask before anything else. */
stereo_result stereo_check(const stereo_device *device);
const char *stereo_text(stereo_result result);

stereo_size stereo_read_size(const stereo_device *device);

/* Lets frames in. After stereo_stop, a frame that has begun is finished. */
void stereo_start(const stereo_device *device);
void stereo_stop(const stereo_device *device);
int stereo_is_busy(const stereo_device *device);

/* Ends the frame in progress as a broken one and clears counters and errors. Its map must be taken meanwhile. Asks
   `tries` times whether it is done. */
stereo_result stereo_reset(const stereo_device *device, unsigned long tries);

uint32_t stereo_frames(const stereo_device *device);        /* whole ones, modulo 2^32 */
uint32_t stereo_broken_frames(const stereo_device *device); /* modulo 2^32 */
uint32_t stereo_frame_clocks(const stereo_device *device);  /* of the last frame */

/* A setting of the next frames, such as STEREO_LEFT_RIGHT_THRESHOLD_OFFSET; which ones there are is a matter of the
   family (docs/integration.md), and stereo_registers.h has those of this core. stereo_set: 0 when the core has no such
   setting, when the value is above stereo_largest, or when the core refuses it, as it does what is too small, an image or
   a penalty (an error then, too); the old one then stays. To change several at once, as width and height of the images,
   stop before and start behind them. */
uint32_t stereo_largest(const stereo_device *device, uint32_t offset); /* 0: the core has no such setting */
uint32_t stereo_setting(const stereo_device *device, uint32_t offset);
int stereo_set(const stereo_device *device, uint32_t offset, uint32_t value);

/* The output `irq` rises with what `mask` names: STEREO_INTERRUPT_FRAME_DONE_ENABLE_MASK,
   STEREO_INTERRUPT_ANY_ERROR_ENABLE_MASK. stereo_take_frame_done: has a frame left since the last call? Lowers the
   output. Errors lower it with stereo_take_errors. */
void stereo_interrupts(const stereo_device *device, uint32_t mask);
int stereo_take_frame_done(const stereo_device *device);

/* The bits STEREO_STATUS_..._MASK of the errors since the last call, and clears them. */
uint32_t stereo_take_errors(const stereo_device *device);

#ifdef __cplusplus
}
#endif

#endif
