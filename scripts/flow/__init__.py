# SPDX-License-Identifier: Apache-2.0
"""From annotated C++ to VHDL to a proven VHDL: the steps behind the commands in scripts/."""
