# SPDX-License-Identifier: Apache-2.0
"""stereo_ip, the core between AXI4-Streams: its files, registers, verification, proofs, example."""
