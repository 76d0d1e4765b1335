# Exported names say where they live. What FILE.c exports is called FILE or FILE_..., or
# after a struct or enum that FILE.h declares (TYPE_...), or FOLDER_model; and no two
# libraries export the same name.
#   cmake -D SOURCE=top -D NM=nm -D LIBRARIES=a,b,... -P check_symbols.cmake
cmake_minimum_required(VERSION 3.25)
string(REPLACE "," ";" LIBRARIES "${LIBRARIES}")

set(faults 0)
set(names "")

# Types that FILE.h declares, for every header of the libraries.
file(GLOB_RECURSE headers RELATIVE ${SOURCE} ${SOURCE}/*.h)
list(FILTER headers EXCLUDE REGEX "^(build[^/]*|results|tests)/")
foreach(header IN LISTS headers)
  get_filename_component(file ${header} NAME_WE)
  file(STRINGS ${SOURCE}/${header} lines REGEX "^(struct|enum) [a-z_0-9]+ {")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[a-z]+ ([a-z_0-9]+) .*" "\\1" type "${line}")
    list(APPEND types_${file} ${type})
  endforeach()
endforeach()

foreach(library IN LISTS LIBRARIES)
  execute_process(COMMAND ${NM} -A -P -g --defined-only ${library}
    OUTPUT_VARIABLE listing ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE ".*libcloth_(.*)\\.a$" "\\1" folder ${library})
  string(REGEX REPLACE "[][]" " " listing "${listing}") # [ ] would upset lists
  string(REGEX MATCHALL "[^\n]+" lines "${listing}")
  foreach(line IN LISTS lines)
    # /path/libNAME.a FILE.c.o : name T 0000 0000
    if(NOT line MATCHES " ([^ ]+)\\.c\\.o *: ([^ ]+) ")
      message("cannot read what nm says: ${line}")
      math(EXPR faults "${faults} + 1")
      continue()
    endif()
    set(file ${CMAKE_MATCH_1})
    set(name ${CMAKE_MATCH_2})
    if(name MATCHES "^__") # the compiler's own, as with sanitizers
      continue()
    endif()
    set(known FALSE)
    foreach(prefix IN LISTS file types_${file})
      if(name MATCHES "^${prefix}(_|$)")
        set(known TRUE)
      endif()
    endforeach()
    if(name STREQUAL "${folder}_model")
      set(known TRUE)
    endif()
    if(NOT known)
      message("${folder}/${file}.c exports ${name}: its names begin with ${file}_")
      math(EXPR faults "${faults} + 1")
    endif()
    if(name IN_LIST names)
      message("${folder}/${file}.c exports ${name}, and so does another file")
      math(EXPR faults "${faults} + 1")
    endif()
    list(APPEND names ${name})
  endforeach()
endforeach()

list(LENGTH names count)
message("${count} exported names, ${faults} faults")
if(faults OR NOT count)
  message(FATAL_ERROR "Exported names do not say where they live.")
endif()
