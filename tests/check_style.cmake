# What a reader should not meet: crowded rooms, long files and lines, notes to self, tabs,
# trailing blanks, places on somebody's machine, and assert in tests, where -DNDEBUG
# would silence it.
#   cmake -D SOURCE=top -P check_style.cmake
cmake_minimum_required(VERSION 3.25)
set(longest_file 450)  # lines of C; 400 is the aim
set(largest_room 7000) # lines of C in one folder
set(longest_line 100)  # 92 is the aim, and clang-format's
set(faults 0)
set(rooms "")

function(fault place text)
  message("${place}: ${text}")
  math(EXPR faults "${faults} + 1")
  set(faults ${faults} PARENT_SCOPE)
endfunction()

set(patterns "")
foreach(kind c h cmake txt sh yaml md edp gp 1)
  list(APPEND patterns ${SOURCE}/*.${kind})
endforeach()
file(GLOB_RECURSE files RELATIVE ${SOURCE} ${patterns})
file(GLOB more RELATIVE ${SOURCE} ${SOURCE}/check ${SOURCE}/reproduce ${SOURCE}/.ci/*)
# bad_scenes are bad on purpose; paper/ is not ours to format.
list(FILTER files EXCLUDE REGEX "^(build[^/]*|results|paper|tests/bad_scenes)/")

# Brackets keep these expressions from finding themselves.
set(note "(^|[^A-Za-z])(T[O]DO|FIX[M]E|X[X]X)([^A-Za-z]|$)")
set(machine "(^|[^A-Za-z0-9_.}>*])/(home|root|work|mnt|Users)/[A-Za-z0-9_]")
set(assertion "(^|[^A-Za-z0-9_])assert(\\.h>| *[(])")

# Models are known by their rows in the table of contestants, and by name next to nowhere.
set(names_most 3) # files of bench outside of verify/checks
set(named "")

foreach(file IN LISTS files more)
  file(READ ${SOURCE}/${file} text)
  string(REGEX REPLACE "[][;\\]" "," text "${text}") # these would upset lists
  string(REGEX REPLACE "\n$" "" text "${text}")
  string(REPLACE "\n" ";" lines "${text}")
  list(LENGTH lines count)
  if(file MATCHES "^bench/" AND NOT file MATCHES "^bench/verify/checks/" AND
     text MATCHES "\"(iga|hex|shell|mass_spring|projective_dynamics)\"")
    list(APPEND named ${file})
  endif()
  if(file MATCHES "\\.[ch]$" AND count GREATER longest_file)
    fault(${file} "${count} lines; ${longest_file} at most")
  endif()
  if(file MATCHES "\\.[ch]$" AND NOT file MATCHES "^tests/")
    get_filename_component(room ${file} DIRECTORY)
    if(NOT room IN_LIST rooms)
      set(lines_${room} 0)
    endif()
    list(APPEND rooms ${room})
    math(EXPR lines_${room} "${lines_${room}} + ${count}")
  endif()
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    if(line MATCHES "\t")
      fault(${file}:${number} "a tab")
    endif()
    if(line MATCHES "[ \r]$")
      fault(${file}:${number} "trailing blanks")
    endif()
    if(line MATCHES "${note}")
      fault(${file}:${number} "a note to self (${CMAKE_MATCH_2})")
    endif()
    if(line MATCHES "${machine}")
      fault(${file}:${number} "a place on one machine (/${CMAKE_MATCH_2}/)")
    endif()
    if(file MATCHES "^tests/.*\\.[ch]$" AND line MATCHES "${assertion}")
      fault(${file}:${number} "assert in a test; use CHECK or REQUIRE")
    endif()
    if(file MATCHES "\\.[ch]$")
      string(LENGTH "${line}" length)
      if(length GREATER longest_line)
        fault(${file}:${number} "${length} columns; ${longest_line} at most")
      endif()
    endif()
  endforeach()
endforeach()

list(REMOVE_DUPLICATES rooms)
foreach(room IN LISTS rooms)
  if(lines_${room} GREATER largest_room)
    fault(${room} "${lines_${room}} lines in one room; ${largest_room} at most")
  endif()
endforeach()

list(LENGTH named count)
if(count GREATER names_most)
  list(JOIN named ", " named)
  fault("bench" "models by name in ${count} files; ${names_most} at most: ${named}")
endif()
list(LENGTH files count)
message("${count} files, ${faults} faults")
if(faults OR NOT count)
  message(FATAL_ERROR "Style: see above.")
endif()
