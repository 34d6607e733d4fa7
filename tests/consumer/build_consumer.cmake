# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Installs the build into an empty folder, builds the consumer against it and runs it.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${FOLDER}")
function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${FOLDER}/install")
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${FOLDER}/build" -G Ninja
  "-DCMAKE_PREFIX_PATH=${FOLDER}/install" "-DCMAKE_CXX_FLAGS=${FLAGS}")
run("${CMAKE_COMMAND}" --build "${FOLDER}/build")
run("${FOLDER}/build/consumer" "${DATA}/helix.xyz" "${FOLDER}/helix.stl")
run("${FOLDER}/install/bin/scanwrap" "${FOLDER}/helix.stl" info)
