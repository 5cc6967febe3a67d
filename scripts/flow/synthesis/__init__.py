# SPDX-License-Identifier: Apache-2.0
"""From C++ to VHDL: Bambu, the lowering of what it writes, and the manifest of what the VHDL was made from."""
