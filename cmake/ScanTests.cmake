# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later
include(GoogleTest)

# scan_test(NAME LIBRARIES lib... SOURCES file... [LABELS label...])
# One GoogleTest program; each of its tests becomes a CTest.
function(scan_test NAME)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "LIBRARIES;SOURCES;LABELS")
  add_executable(${NAME} ${ARG_SOURCES})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} GTest::gtest_main scan_build_flags)
  # where the large shared corpus may be; tests that need it skip when it is missing
  target_compile_definitions(${NAME} PRIVATE
    SCAN_SHARED_DIR="${SCAN_SHARED_DIR}" SCAN_DATA_DIR="${PROJECT_SOURCE_DIR}/data")
  gtest_discover_tests(${NAME} DISCOVERY_TIMEOUT 60
    PROPERTIES TIMEOUT 600 LABELS "${ARG_LABELS}")
endfunction()
