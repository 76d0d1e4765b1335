# cmake --install puts program, scenes and man page in place, and the installed program finds
# its scenes by itself: a scene that is only in the installed tree is listed.
#   cmake -D SOURCE=... -D BUILD=... -D PREFIX=... -P install.cmake
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_moved)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB scenes RELATIVE ${SOURCE}/models/scenes ${SOURCE}/models/scenes/*.yaml)
if(NOT scenes)
  message(FATAL_ERROR "no scenes in ${SOURCE}/models/scenes")
endif()
list(TRANSFORM scenes PREPEND share/clothbench/scenes/)
foreach(file bin/clothbench share/man/man1/clothbench.1 ${scenes}
             share/clothbench/plans/feasibility.yaml)
  if(NOT EXISTS ${PREFIX}/${file})
    message(SEND_ERROR "${file} was not installed")
  endif()
endforeach()

file(READ ${PREFIX}/share/clothbench/scenes/edge_drop.yaml scene)
string(REPLACE "name: edge_drop" "name: only_installed" scene "${scene}")
file(WRITE ${PREFIX}/share/clothbench/scenes/only_installed.yaml "${scene}")
file(RENAME ${PREFIX} ${PREFIX}_moved)
execute_process(COMMAND ${PREFIX}_moved/bin/clothbench list scenes WORKING_DIRECTORY /
                OUTPUT_VARIABLE listed COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${PREFIX}_moved)
foreach(name edge_drop only_installed)
  if(NOT listed MATCHES "${name}")
    message(SEND_ERROR "the installed program does not list ${name}: ${listed}")
  endif()
endforeach()
