cmake_minimum_required(VERSION 3.25)

# Writes HEADER with the commit of SOURCE, the number of files that differ from it, and a digest
# of what computes a run: names and contents of the sources of models and of what runs them.
# Run at every build, rewrites only what changed. Outside a git checkout the first two are
# `unknown`.
# FOLDERS has those of the models, with commas between.
#   cmake -D SOURCE=... -D FOLDERS=... -D HEADER=... -P provenance.cmake
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

# Of other folders none has a say in a run's numbers, nor has the version.
set(digests "")
if(EXISTS ${SOURCE}/CMakeLists.txt)
  file(STRINGS ${SOURCE}/CMakeLists.txt digests)
  list(FILTER digests EXCLUDE REGEX "^project\\(")
endif()
string(REPLACE "," ";" FOLDERS ${FOLDERS})
set(patterns "")
foreach(folder models bench/harness ${FOLDERS})
  list(APPEND patterns ${SOURCE}/${folder}/*.c ${SOURCE}/${folder}/*.h)
endforeach()
file(GLOB_RECURSE sources RELATIVE ${SOURCE} ${patterns})
file(GLOB more RELATIVE ${SOURCE} ${SOURCE}/bench/truth/truth_level.c
  ${SOURCE}/bench/experiment/measurement.c)
list(APPEND sources ${more})
list(SORT sources)
foreach(name IN LISTS sources)
  file(SHA256 ${SOURCE}/${name} digest)
  string(APPEND digests "${name} ${digest}\n")
endforeach()
string(SHA256 solvers "${digests}")
string(SUBSTRING ${solvers} 0 16 solvers)

file(CONFIGURE OUTPUT ${HEADER} @ONLY CONTENT
"#define PROVENANCE_COMMIT \"@commit@\"
#define PROVENANCE_CHANGED \"@changed@\"
#define PROVENANCE_SOLVERS \"@solvers@\"
")
