# SPDX-License-Identifier: Apache-2.0
"""What runs VHDL: each simulator is a class and a row, and a design is built once in it for all runs."""
