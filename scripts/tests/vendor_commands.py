# SPDX-License-Identifier: Apache-2.0
"""Stand-ins for the Tcl commands of Vivado (UG835, UG1118) and Platform Designer, in a real Tcl interpreter. They know
which options there are, and write down how they are called; any other command is an error, as it is there."""

import subprocess

VIVADO = {  # command -> its options
    "create_project": "-part -force",
    "add_files": "-norecurse -fileset",
    "get_files": "",
    "current_fileset": "",
    "update_compile_order": "-fileset",
    "set_property": "",
    "get_property": "",
    "close_project": "",
    "ipx::package_project": "-root_dir -vendor -library -taxonomy -import_files -force",
    "ipx::current_core": "",
    "ipx::associate_bus_interfaces": "-busif -clock -reset",
    "ipx::get_memory_maps": "-quiet -of_objects",
    "ipx::remove_memory_map": "",
    "ipx::add_memory_map": "",
    "ipx::get_bus_interfaces": "-of_objects",
    "ipx::infer_bus_interface": "",
    "ipx::add_bus_parameter": "",
    "ipx::add_address_block": "",
    "ipx::add_register": "",
    "ipx::add_field": "",
    "ipx::create_xgui_files": "",
    "ipx::update_checksums": "",
    "ipx::check_integrity": "",
    "ipx::save_core": "",
}
PLATFORM_DESIGNER = dict.fromkeys(
    "set_module_property add_fileset set_fileset_property add_fileset_file add_parameter set_parameter_property "
    "add_interface set_interface_property add_interface_port set_port_property".split(),
    "",
)
QUARTUS = {"set_global_assignment": "-name -hdl_version -library"}

# A call is a line, its words with a bar between them. It returns its own name and last word, as a handle. Files are a
# list of Tcl, which blanks divide.
_STAND_IN = """
proc {name} {{args}} {{
  foreach word $args {{
    if {{[string match {{-[a-z]*}} $word] && $word ni {{{options}}}}} {{ error "{name} has no option $word" }}
  }}
  if {{"{name}" in {{add_files get_files}}}} {{ set args [concat [lrange $args 0 end-1] [lindex $args end]] }}
  puts [join [concat {name} $args] |]
  return "{name}:[lindex $args end]"
}}
"""
_BEFORE = """
namespace eval ipx {}
package provide qsys 16.1
"""


def calls(script, commands, before=""):
    """[[word of a call]] of a script. `before`: Tcl that runs first."""
    stand_ins = "".join(_STAND_IN.format(name=name, options=options) for name, options in commands.items())
    text = f"{_BEFORE}{stand_ins}{before}\nsource {{{script}}}\n"
    process = subprocess.run(["tclsh"], input=text + "exit\n", capture_output=True, text=True)
    assert not process.stderr, process.stderr
    return [line.split("|") for line in process.stdout.splitlines()]
