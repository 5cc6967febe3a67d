# SPDX-License-Identifier: Apache-2.0
# @{top} at @{mhz} MHz: what the option --mhz of scripts/instantiate.py said, 100 without it. A wish, no measurement.
# Placed and routed by nextpnr:
@{measured}
# One clock and a synchronous reset: there is nothing else to constrain, and no path is false.
create_clock -name @{clock} -period @{period} [get_ports @{clock}]
