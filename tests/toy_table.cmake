# The table of contestants with the toy in it, added as doc/adding_a_model.md says: its
# #include and its row, read from there. And with tests/odd_model.h, by name only.
#   cmake -D SOURCE=folder -D OUTPUT=file -P toy_table.cmake
file(READ ${SOURCE}/doc/adding_a_model.md manual)
file(READ ${SOURCE}/bench/harness/contestant_table.c table)
if(NOT manual MATCHES "(#include \"strands/strands_model.h\")")
  message(FATAL_ERROR "doc/adding_a_model.md has no #include of the new model")
endif()
string(REPLACE "strands/strands_model" "tests/toy_model" include "${CMAKE_MATCH_1}")
if(NOT manual MATCHES "({\"strands\", [^\n]*&strands_model,[^}]*}[^}]*}[^}]*}[^}]*}},)")
  message(FATAL_ERROR "doc/adding_a_model.md has no row of the new model")
endif()
string(REPLACE "strands" "toy" row "${CMAKE_MATCH_1}")
string(FIND "${table}" "    {NULL},\n" end)
if(end LESS 0)
  message(FATAL_ERROR "contestant_table.c has no end")
endif()
set(odd "{\"odd\", \"ends as it is told\", \"odd\", &odd_model, 0, {0}, 0, 1, {2}, {1}, {0}},")
string(REPLACE "    {NULL},\n" "    ${row}\n    ${odd}\n    {NULL},\n" table "${table}")
string(REPLACE "#include \"shell_ref/"
  "#include \"tests/odd_model.h\"\n${include}\n#include \"shell_ref/" table "${table}")
file(WRITE ${OUTPUT} "${table}")
