# SPDX-License-Identifier: MIT
# cmake -DINDEX=ifs_library/index.json -DOUTPUT=texts.cpp -P collection_texts.cmake
# Writes the texts of a collection's index as a source file that lupdate reads; nothing compiles it.
cmake_minimum_required(VERSION 3.25)

file(READ "${INDEX}" index)
string(JSON count LENGTH "${index}" themes)
math(EXPR last "${count} - 1")
set(source "// Generated from ${INDEX}.\n")
foreach(i RANGE ${last})
  foreach(member IN ITEMS title description)
    string(JSON text GET "${index}" themes ${i} ${member})
    string(REPLACE "\\" "\\\\" text "${text}")
    string(REPLACE "\"" "\\\"" text "${text}")
    string(APPEND source "QT_TRANSLATE_NOOP(\"Collection\", \"${text}\")\n")
  endforeach()
endforeach()
file(WRITE "${OUTPUT}" "${source}")
