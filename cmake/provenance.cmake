cmake_minimum_required(VERSION 3.25)

# Writes HEADER with the commit of SOURCE and the number of files that differ from it; run at
# every build, rewrites only what changed. Outside a git checkout both are `unknown`.
#   cmake -D SOURCE=... -D HEADER=... -P provenance.cmake
set(commit unknown)
set(changed unknown)
find_program(GIT git)

# A release unpacked inside some other checkout must not take that one's commit.
if(GIT AND EXISTS ${SOURCE}/.git)
  execute_process(COMMAND ${GIT} rev-parse HEAD WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE head RESULT_VARIABLE failed ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  execute_process(COMMAND ${GIT} --no-optional-locks status --porcelain
    WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE status RESULT_VARIABLE status_failed
    ERROR_QUIET)
  if(NOT failed AND NOT status_failed)
    set(commit ${head})
    string(REGEX MATCHALL "\n" lines "${status}")
    list(LENGTH lines changed)
  endif()
endif()
file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#define PROVENANCE_COMMIT \"@commit@\"
#define PROVENANCE_CHANGED \"@changed@\"
")
