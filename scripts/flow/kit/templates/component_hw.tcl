# SPDX-License-Identifier: Apache-2.0
# The stereo core @{config} as a component of Platform Designer: add this folder to the IP search path of your project.
# Not tried in Quartus: see README.md.
package require -exact qsys 16.1

set_module_property NAME @{top}
set_module_property DISPLAY_NAME "Stereo matching @{config}"
set_module_property DESCRIPTION "Disparity maps of rectified image pairs, configuration @{config}"
set_module_property VERSION @{version}
set_module_property GROUP "Stereo vision"
set_module_property EDITABLE false

# In compile order.
foreach {fileset type} {synthesis QUARTUS_SYNTH simulation SIM_VHDL mixed_simulation SIM_VERILOG} {
  add_fileset $fileset $type ""
  set_fileset_property $fileset TOP_LEVEL @{top}
@{files}
}

add_parameter @{generic} NATURAL 1 "1: takes frames after reset; 0: waits for a processor"
set_parameter_property @{generic} ALLOWED_RANGES 0:1
set_parameter_property @{generic} HDL_PARAMETER true

add_interface clock clock end
add_interface_port clock aclk clk Input 1

add_interface reset reset end
set_interface_property reset associatedClock clock
set_interface_property reset synchronousEdges BOTH
add_interface_port reset aresetn reset_n Input 1

add_interface interrupt interrupt end
set_interface_property interrupt associatedClock clock
set_interface_property interrupt associatedReset reset
set_interface_property interrupt associatedAddressablePoint s_axil
add_interface_port interrupt irq irq Output 1

@{interfaces}
