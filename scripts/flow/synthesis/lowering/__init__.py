# SPDX-License-Identifier: Apache-2.0
"""From the structural VHDL of Bambu to plain VHDL: read (vhdl_reader), lower, run the passes, write (vhdl_writer)."""
