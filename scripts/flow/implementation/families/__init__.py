# SPDX-License-Identifier: Apache-2.0
"""The FPGA families: a class for each."""
