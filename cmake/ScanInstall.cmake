# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# The libraries without VTK join the export set of the VTK modules, as Scan::base, Scan::geometry...
include(CMakePackageConfigHelpers)

set(scan_plain_libraries scan_build_flags)
foreach(library base vtk_base geometry readers cad_readers writers pipeline)
  if(TARGET scan_${library})
    list(APPEND scan_plain_libraries scan_${library})
    set_target_properties(scan_${library} PROPERTIES EXPORT_NAME ${library})
  endif()
endforeach()
install(TARGETS ${scan_plain_libraries}
  EXPORT Scanwrap
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  INCLUDES DESTINATION "${SCAN_INSTALL_INCLUDE_DIR}")
install(DIRECTORY filters readers writers pipeline
  DESTINATION "${SCAN_INSTALL_INCLUDE_DIR}"
  FILES_MATCHING PATTERN "*.h")
foreach(module Filters Readers Writers) # the export macros that the VTK modules' headers include
  string(TOLOWER ${module} folder)
  install(FILES "${PROJECT_BINARY_DIR}/${folder}/Scan${module}Module.h"
    DESTINATION "${SCAN_INSTALL_INCLUDE_DIR}")
endforeach()

configure_package_config_file(cmake/ScanwrapConfig.cmake.in
  "${PROJECT_BINARY_DIR}/ScanwrapConfig.cmake"
  INSTALL_DESTINATION "${SCAN_INSTALL_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/ScanwrapConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/ScanwrapConfig.cmake"
  "${PROJECT_BINARY_DIR}/ScanwrapConfigVersion.cmake"
  DESTINATION "${SCAN_INSTALL_CMAKE_DIR}")
