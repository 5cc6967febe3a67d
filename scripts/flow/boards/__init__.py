# SPDX-License-Identifier: Apache-2.0
"""A core on a board with a serial line to it, examples/boards: bit streams, simulation, and the line itself."""
