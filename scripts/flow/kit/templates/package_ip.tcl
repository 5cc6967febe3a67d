# SPDX-License-Identifier: Apache-2.0
# Packages the stereo core @{config} for the IP catalogue of Vivado, in the folder packaged/:
#   vivado -mode batch -source package_ip.tcl
# Then add packaged/ to the IP repositories of your project. Not tried in Vivado: see README.md.
set here [file dirname [file normalize [info script]]]
set top @{top}
# In compile order; the top is VHDL-93, as the packager wants it.
set sources {
@{sources}
}

create_project package [file join $here project] -force
set paths {}
foreach name $sources { lappend paths [file join $here $name] }
add_files -norecurse $paths
set_property file_type {VHDL 2008} [get_files [lrange $paths 0 end-1]]
set_property file_type VHDL [get_files [lrange $paths end end]]
set constraints [file join $here constraints clock.xdc]
add_files -norecurse -fileset constrs_1 [list $constraints]
# The clock of a packaged core comes from the design around it; here it is only for synthesis out of context.
set_property used_in {synthesis implementation out_of_context} [get_files [list $constraints]]
set_property top $top [current_fileset]
update_compile_order -fileset sources_1

# Takes the buses @{buses}, the clock and the reset from the names of the ports.
ipx::package_project -root_dir [file join $here packaged] -vendor @{vendor} -library @{library} \
  -taxonomy /Stereo_Vision -import_files -force
set core [ipx::current_core]
set_property name $top $core
set_property version @{version} $core
set_property display_name {Stereo matching @{config}} $core
set_property description {Disparity maps of rectified image pairs, configuration @{config}} $core
foreach bus {@{buses}} { ipx::associate_bus_interfaces -busif $bus -clock aclk $core }
ipx::associate_bus_interfaces -clock aclk -reset aresetn $core

# A port alone is no interrupt to Vivado.
ipx::infer_bus_interface @{interrupt} xilinx.com:signal:interrupt_rtl:1.0 $core
set interrupt [ipx::get_bus_interfaces @{interrupt} -of_objects $core]
set_property value LEVEL_HIGH [ipx::add_bus_parameter SENSITIVITY $interrupt]

# The registers: a map of our own instead of what Vivado guesses.
foreach map [ipx::get_memory_maps -quiet -of_objects $core] {
  ipx::remove_memory_map [get_property name $map] $core
}
set map [ipx::add_memory_map s_axil $core]
set_property slave_memory_map_ref s_axil [ipx::get_bus_interfaces s_axil -of_objects $core]
set block [ipx::add_address_block registers $map]
set_property range @{range} $block
set_property width 32 $block
set_property usage register $block

proc register {name offset} {
  global block current
  set current [ipx::add_register $name $block]
  set_property address_offset $offset $current
  set_property size 32 $current
}
proc field {name low bits access modified description} {
  global current
  set field [ipx::add_field $name $current]
  set_property bit_offset $low $field
  set_property bit_width $bits $field
  set_property access $access $field
  if {$modified ne ""} { set_property modified_write_value $modified $field }
  set_property description $description $field
}
@{registers}

ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
close_project
