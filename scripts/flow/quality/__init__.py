# SPDX-License-Identifier: Apache-2.0
"""How good disparity maps are, and what that costs in hardware."""
