# SPDX-License-Identifier: Apache-2.0
# How every target of this project is compiled, and the one way to declare a library of the core.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

option(INKFLATE_SANITIZE "Address and undefined-behaviour sanitizers" OFF)

find_program(INKFLATE_CCACHE ccache)
if(INKFLATE_CCACHE)
  # What one copy of the sources has compiled serves a copy in another place too.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=true ${INKFLATE_CCACHE})
endif()

add_library(inkflate_flags INTERFACE)
# Contraction to fused multiply-add would make results depend on the processor.
target_compile_options(inkflate_flags INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow
                                                -Wnon-virtual-dtor -Wold-style-cast -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports these inside libstdc++ at -O2 and above.
  target_compile_options(inkflate_flags INTERFACE -Wno-stringop-overflow -Wno-array-bounds
                                                  -Wno-restrict -Wno-maybe-uninitialized)
endif()
if(INKFLATE_SANITIZE)
  target_compile_options(inkflate_flags INTERFACE -fsanitize=address,undefined
                                                  -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(inkflate_flags INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(inkflate_flags INTERFACE INKFLATE_SANITIZE)
endif()
# The core is compiled without exceptions: WebAssembly cannot catch, so nothing may throw.
add_library(inkflate_core_flags INTERFACE)
target_link_libraries(inkflate_core_flags INTERFACE inkflate_flags)
target_compile_options(inkflate_core_flags INTERFACE -fno-exceptions)
if(EMSCRIPTEN)
  # Smaller by a tenth (gzip: 625 to 568 kB) and not slower; -Os would be smaller still, but up to 450 times slower.
  target_compile_options(inkflate_core_flags INTERFACE -flto "SHELL:-mllvm -inline-threshold=80")
  target_link_options(inkflate_core_flags INTERFACE -flto "LINKER:-mllvm,-inline-threshold=80")
endif()

# What programs that a person or a test starts need beside the flags.
add_library(inkflate_program INTERFACE)
target_link_libraries(inkflate_program INTERFACE inkflate_flags)
if(EMSCRIPTEN)
  # CommonJS for node; a stack of 1 MB because the default is small and overflows silently.
  target_link_options(inkflate_program INTERFACE -sENVIRONMENT=node -sNODERAWFS=1 -sEXIT_RUNTIME=1
                      -sALLOW_MEMORY_GROWTH=1 -sTOTAL_STACK=1048576)
  # Debian keeps the JavaScript parser that the link step needs outside of node's own search path.
  set(CMAKE_CXX_LINKER_LAUNCHER env NODE_PATH=/usr/share/nodejs)
  # Without it, node tries to fetch the program's file as if it were an address.
  set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
endif()

# inkflate_library(FOLDER [folder it may include ...]): the library of one folder of src/.
function(inkflate_library name)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
  add_library(inkflate_${name} STATIC ${sources})
  set_target_properties(inkflate_${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_include_directories(inkflate_${name} PUBLIC ${CMAKE_SOURCE_DIR}/src)
  list(TRANSFORM ARGN PREPEND inkflate_)
  target_link_libraries(inkflate_${name} PUBLIC ${ARGN} PRIVATE inkflate_core_flags)
  inkflate_check_headers(inkflate_${name} ${sources})
endfunction()

# Every header has to compile on its own. One that NAME.cpp includes first (a test of the house sees to that) is
# proven by NAME.cpp; for each of the others a file with that one include is compiled into the library.
function(inkflate_check_headers target)
  foreach(source IN LISTS ARGN)
    string(REGEX REPLACE "\\.h$" ".cpp" partner ${source})
    if(source MATCHES "\\.h$" AND NOT EXISTS ${partner})
      file(RELATIVE_PATH header ${CMAKE_CURRENT_SOURCE_DIR}/.. ${source})
      set(alone ${CMAKE_CURRENT_BINARY_DIR}/alone/${header}.cpp)
      file(CONFIGURE OUTPUT ${alone} CONTENT "#include \"${header}\"\n")
      target_sources(${target} PRIVATE ${alone})
    endif()
  endforeach()
endfunction()
