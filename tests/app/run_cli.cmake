# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The body of a scan_cli_test, see CMakeLists.txt.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
set(ENV{DATA} "${DATA}")
set(ENV{SHARED} "${SHARED}")
if(LINE MATCHES "\\$SHARED" AND NOT EXISTS "${SHARED}")
  message("skipped: ${SHARED} is not there: the shared corpus is missing")
  return()
endif()
set(ENV{LC_ALL} C)
execute_process(
  COMMAND bash -c "scanwrap() { '${PROGRAM}' \"$@\"; }; ${LINE}"
  WORKING_DIRECTORY "${FOLDER}"
  RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE err)

set(report "${LINE}\nstatus: ${status}\nstdout: ${out}\nstderr: ${err}")
if(NOT status STREQUAL EXIT)
  message(FATAL_ERROR "expected the status ${EXIT}\n${report}")
endif()
foreach(stream OUT ERR)
  string(TOLOWER ${stream} name)
  if(NOT "${${stream}}" STREQUAL "" AND NOT "${${name}}" MATCHES "${${stream}}")
    message(FATAL_ERROR "expected ${name} to match: ${${stream}}\n${report}")
  endif()
endforeach()
if(NOT EXIT EQUAL 0 AND NOT err MATCHES "^scanwrap: [^\n]+\n$")
  message(FATAL_ERROR "expected one line on stderr\n${report}")
endif()
file(GLOB made RELATIVE "${FOLDER}" "${FOLDER}/out*")
list(SORT FILES)
if(NOT "${made}" STREQUAL "${FILES}")
  message(FATAL_ERROR "expected the files '${FILES}', found '${made}'\n${report}")
endif()
