# SPDX-License-Identifier: Apache-2.0
"""A core as vendors' tools take it: sources, wrapper, description, scripts, constraints, driver."""
