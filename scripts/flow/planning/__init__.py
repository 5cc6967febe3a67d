# SPDX-License-Identifier: Apache-2.0
"""What a configuration that is not made yet would take of a device, from its options alone."""
