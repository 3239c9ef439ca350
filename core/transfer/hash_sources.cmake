# SPDX-License-Identifier: MIT
# cmake -D OUT=header -D "SOURCES=a.cpp|b.cpp" -P hash_sources.cmake
# Writes a header with the hash of these sources: part of the name of every stored bake, so that a
# program whose bake was changed does not take the old one's results for its own.
string(REPLACE "|" ";" sources "${SOURCES}")
set(all "")
foreach(source IN LISTS sources)
  file(SHA256 "${source}" hash)
  string(APPEND all "${hash}")
endforeach()
string(SHA256 hash "${all}")
file(WRITE "${OUT}" "#pragma once\n\ninline constexpr char kBakeSources[] = \"${hash}\";\n")
