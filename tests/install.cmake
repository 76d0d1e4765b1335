# As README has it: what `cmake --build --preset release` builds, `cmake --install` puts in
# place - program, scenes, man page, the library for mpirun where there is MPI. The installed
# program finds its scenes by itself: a scene that is only in the installed tree is listed.
#   cmake -D SOURCE=... -D BUILD=... -D PREFIX=... -D LIBDIR=lib -D MPI=clothbench_mpi, or
#   nothing, -P install.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${PREFIX} ${PREFIX}_moved)

# The targets of the preset `release`, with nothing left over from building others.
file(READ ${SOURCE}/CMakePresets.json presets)
string(JSON count LENGTH "${presets}" buildPresets)
set(targets "")
math(EXPR last "${count} - 1")
foreach(n RANGE ${last})
  string(JSON name GET "${presets}" buildPresets ${n} name)
  if(name STREQUAL "release")
    string(JSON wanted GET "${presets}" buildPresets ${n} targets)
    string(REGEX MATCHALL "[a-z_]+" targets "${wanted}")
  endif()
endforeach()
if(NOT targets)
  message(FATAL_ERROR "no targets of the preset `release` in CMakePresets.json")
endif()
set(libraries "")
if(MPI)
  file(REMOVE ${BUILD}/${MPI}.so)
  set(libraries ${LIBDIR}/clothbench/${MPI}.so)
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD} --target ${targets}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${PREFIX}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(GLOB scenes RELATIVE ${SOURCE}/models/scenes ${SOURCE}/models/scenes/*.yaml)
if(NOT scenes)
  message(FATAL_ERROR "no scenes in ${SOURCE}/models/scenes")
endif()
list(TRANSFORM scenes PREPEND share/clothbench/scenes/)
foreach(file bin/clothbench lib/python3/dist-packages/clothbench/truth.py share/man/man1/clothbench.1 ${scenes}
             share/clothbench/plans/feasibility.yaml
             lib/python3/dist-packages/clothbench/page.html.j2 share/clothbench/manual/iterations.md
             share/clothbench/manual/speed_against_error.svg ${libraries})
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
