# SPDX-License-Identifier: Apache-2.0
"""What every other package stands on: errors, files, JSON, tools, virtual environments. Imports nothing of the flow."""
