# SPDX-License-Identifier: Apache-2.0
"""Verification of stereo_ip, the core between AXI4-Streams: streams, what must come of them, and the simulators."""
