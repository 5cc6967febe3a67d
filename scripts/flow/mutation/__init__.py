# SPDX-License-Identifier: Apache-2.0
"""Do the tests notice single faults in the VHDL?"""
