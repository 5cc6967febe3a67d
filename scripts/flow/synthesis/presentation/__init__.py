# SPDX-License-Identifier: Apache-2.0
"""The VHDL of a core as a person reads it, and back (docs/lowering.md)."""
