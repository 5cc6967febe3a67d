/* SPDX-License-Identifier: Apache-2.0 */
/* The registers of stereo_ip_@{config}, from hls/rtl/registers.json. docs/integration.md says what they mean. */
#ifndef STEREO_REGISTERS_H
#define STEREO_REGISTERS_H

@{registers}

/* What they always read in this configuration. */
@{constants}

#endif
