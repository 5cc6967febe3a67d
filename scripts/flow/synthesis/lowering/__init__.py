# SPDX-License-Identifier: Apache-2.0
"""From the structural VHDL of Bambu to plain VHDL: read, lower, run the passes, write."""
