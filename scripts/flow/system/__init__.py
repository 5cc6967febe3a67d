# SPDX-License-Identifier: Apache-2.0
"""Two cameras, rectification, matching and depth in one design: examples/camera_system."""
