# SPDX-License-Identifier: Apache-2.0
"""The VHDL against the C++ core, to the last bit and clock."""
