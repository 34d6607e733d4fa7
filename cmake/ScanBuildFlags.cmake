# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Build types, and the warnings, sanitizers and floating-point rules that every target of the
# project links PRIVATE.
option(SCAN_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
set(SCAN_SANITIZE "" CACHE STRING "Sanitizers for all targets, e.g. address,undefined")

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()
foreach(language C CXX) # Dev: fast enough for real data, with assertions
  if(NOT CMAKE_${language}_FLAGS_DEV) # project() has left an empty cache entry
    set(CMAKE_${language}_FLAGS_DEV "-O1 -g")
  endif()
endforeach()

add_library(scan_build_flags INTERFACE)
target_compile_options(scan_build_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> # GCC 12 is wrong about std::variant
  -ffp-contract=off # the same bytes on machines with and without FMA
  $<$<BOOL:${SCAN_WARNINGS_AS_ERRORS}>:-Werror>)
if(SCAN_SANITIZE)
  set(SCAN_SANITIZE_FLAGS "-fsanitize=${SCAN_SANITIZE}")
  target_compile_options(scan_build_flags INTERFACE
    ${SCAN_SANITIZE_FLAGS} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(scan_build_flags INTERFACE ${SCAN_SANITIZE_FLAGS})
endif()
