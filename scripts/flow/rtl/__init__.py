# SPDX-License-Identifier: Apache-2.0
"""From the structural VHDL of Bambu to plain VHDL: read, lower, drop the control that is not needed, name, write."""
