# SPDX-License-Identifier: MIT
# cmake -DINDEX=ifs_library/index.json -DOUTPUT=texts.cpp -P collection_texts.cmake
# Writes the texts of a collection's index and the titles of its entries as a source file that lupdate reads;
# nothing compiles it.
cmake_minimum_required(VERSION 3.25)

function(append_text context text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(APPEND source "QT_TRANSLATE_NOOP(\"${context}\", \"${text}\")\n")
  set(source "${source}" PARENT_SCOPE)
endfunction()

cmake_path(GET INDEX PARENT_PATH folder)
file(READ "${INDEX}" index)
string(JSON count LENGTH "${index}" themes)
math(EXPR last "${count} - 1")
set(source "// Generated from ${INDEX}.\n")
foreach(i RANGE ${last})
  foreach(member IN ITEMS title description)
    string(JSON text GET "${index}" themes ${i} ${member})
    append_text(Collection "${text}")
  endforeach()
  string(JSON name GET "${index}" themes ${i} file)
  file(READ "${folder}/${name}" entries)
  string(REPLACE ";" "|" entries "${entries}") # a semicolon would end an element of a list
  string(REGEX MATCHALL "{ \\| [^\n]+" headers "${entries}")
  foreach(header IN LISTS headers)
    string(SUBSTRING "${header}" 4 -1 title)
    append_text(CollectionNames "${title}")
  endforeach()
endforeach()
file(WRITE "${OUTPUT}" "${source}")
