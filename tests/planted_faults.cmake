# The checks of style, layers and symbols see what they are for: a small tree without faults
# passes, and each planted fault is named.
#   cmake -D SOURCE=top -D SCRATCH=folder -D CC=cc -D AR=ar -D NM=nm -P planted_faults.cmake
cmake_minimum_required(VERSION 3.25)
set(faults 0)

# An empty copy of the project: a header, its file, a test, and the real tests/layers.txt.
function(make_tree)
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/models/grid.h "struct point {\n    double x;\n};\n")
  file(WRITE ${SCRATCH}/models/grid.c "#include \"models/grid.h\"\n#include <math.h>\n")
  file(WRITE ${SCRATCH}/iga/patch.h "#include \"models/grid.h\"\n")
  file(WRITE ${SCRATCH}/tests/grid.c "#include \"iga/patch.h\"\n")
  file(COPY ${SOURCE}/tests/layers.txt DESTINATION ${SCRATCH}/tests)
endfunction()

# Runs a check on the tree; it must say `expected`, or pass if that is empty.
function(expect check expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE=${SCRATCH} ${ARGN}
      -P ${SOURCE}/tests/check_${check}.cmake
    RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(FIND "${said}" "${expected}" found)
  if(expected STREQUAL "" AND result EQUAL 0)
    return()
  elseif(NOT expected STREQUAL "" AND NOT result EQUAL 0 AND NOT found EQUAL -1)
    return()
  endif()
  message("check_${check} should say `${expected}`, but returned ${result} and said:\n${said}")
  math(EXPR faults "${faults} + 1")
  set(faults ${faults} PARENT_SCOPE)
endfunction()

# Plants one line at the end of a file of a fresh tree.
macro(plant check file line expected)
  make_tree()
  file(APPEND ${SCRATCH}/${file} "${line}\n")
  expect(${check} "${expected}")
endmacro()

make_tree()
expect(layers "")
expect(style "")
plant(layers models/grid.c "#include \"iga/patch.h\""
  "models/grid.c: models may not include iga/patch.h")
plant(layers models/grid.c "# include <iga/patch.h>"
  "models/grid.c: models may not include iga/patch.h")
plant(layers fem_ref/hex.c "#include \"iga/patch.h\""
  "fem_ref/hex.c: fem_ref may not include iga/patch.h")
plant(layers iga/patch.c "#include \"tests/grid.c\""
  "iga/patch.c: iga may not include tests/grid.c")
plant(layers iga/patch.c "#include \"patch.h\"" "no \"patch.h\" seen from the top")
plant(layers iga/inner/patch.c "" "iga/inner/patch.c: its folder is not in tests/layers.txt")
plant(layers tests/layers.txt "extra: later\nlater:" "extra sees later, which does not stand")

# models/grid, by a part without a header, and models/net need each other.
macro(make_circle)
  make_tree()
  file(WRITE ${SCRATCH}/models/net.h "#include \"models/grid.h\"\n")
  file(WRITE ${SCRATCH}/models/grid_part.c "#include \"models/net.h\"\n")
endmacro()
make_circle()
expect(layers "a circle of files: models/grid models/net")
file(WRITE ${SCRATCH}/models/grid_part.h "") # no part any more
expect(layers "")
make_circle()
file(WRITE ${SCRATCH}/tests/circles.txt "# open\nmodels/grid models/net\n")
expect(layers "")
plant(layers tests/circles.txt "models/grid models/net"
  "tests/circles.txt: no circle any more, strike it out: models/grid models/net")

string(REPEAT "int x;\n" 450 long)
string(REPEAT "x" 101 wide)
plant(style models/grid.c "${long}" "lines; 450 at most")
make_tree()
foreach(number RANGE 1 17)
  file(WRITE ${SCRATCH}/models/part${number}.c "${long}")
endforeach()
expect(style "lines in one room; 7000 at most")
plant(style models/grid.c "${wide}" "101 columns; 100 at most")
make_tree()
foreach(room run ui files truth)
  file(WRITE ${SCRATCH}/bench/${room}/a.c "const char *model = \"hex\";\n")
endforeach()
file(WRITE ${SCRATCH}/bench/verify/checks/a.c "const char *model = \"hex\";\n")
expect(style "models by name in 4 files; 3 at most")
file(REMOVE ${SCRATCH}/bench/ui/a.c)
expect(style "")
plant(style models/grid.c "\tint x;" "models/grid.c:3: a tab")
plant(style models/grid.c "int x; " "models/grid.c:3: trailing blanks")
foreach(word TO-DO FIX-ME)
  string(REPLACE "-" "" word ${word})
  plant(style models/grid.c "/* ${word}: x */" "a note to self (${word})")
endforeach()
foreach(place home root work)
  plant(style models/grid.c "open(\"/${place}/x\");" "a place on one machine (/${place}/)")
endforeach()
plant(style tests/grid.c "assert(1)\;" "tests/grid.c:2: assert in a test")
plant(style tests/grid.c "#include <assert.h>" "tests/grid.c:2: assert in a test")
set(place work)
plant(style models/grid.c "_Static_assert(1, \"/models/${place}/x\")\; assert(1)\;" "")

# A library of one object file, FILE.c holding `code`, in folder iga or models.
function(plant_symbols folder file code expected)
  make_tree()
  set(library ${SCRATCH}/libcloth_${folder}.a)
  # A name that is right, and then the fault.
  file(WRITE ${SCRATCH}/sound.c "int sound_x;\n")
  file(WRITE ${SCRATCH}/${file}.c "${code}\n")
  set(sources sound ${file})
  foreach(source IN LISTS sources)
    execute_process(COMMAND ${CC} -c ${source}.c -o ${source}.c.o
      WORKING_DIRECTORY ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND ${AR} qc ${library} ${source}.c.o
      WORKING_DIRECTORY ${SCRATCH} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  expect(symbols "${expected}" -D NM=${NM} -D LIBRARIES=${library})
  set(faults ${faults} PARENT_SCOPE)
endfunction()

plant_symbols(models grid "int grid, grid_x, point_x; static int other;" "")
plant_symbols(iga plate "int iga_model;" "")
plant_symbols(iga plate "int hex_model;" "iga/plate.c exports hex_model: its names begin with")
plant_symbols(models grid "int gridx;" "models/grid.c exports gridx: its names begin with")
plant_symbols(models grid "void x(void) {}" "models/grid.c exports x: its names begin with")

if(faults)
  message(FATAL_ERROR "${faults} planted faults were not seen, or seen where there were none")
endif()
file(REMOVE_RECURSE ${SCRATCH})
