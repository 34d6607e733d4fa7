# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Finds VTK and builds every top-level folder with a vtk.module as a VTK module: Scan::Filters,
# Scan::Readers, ... The folder's CMakeLists.txt adds its VTK-free libraries, too.
set(SCAN_INSTALL_CMAKE_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/Scanwrap")
set(SCAN_INSTALL_INCLUDE_DIR "${CMAKE_INSTALL_INCLUDEDIR}/scanwrap")

if(SCAN_WRAP_PYTHON)
  # VTK's Python modules belong to the system's interpreter
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "Python of the system's VTK")
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
  list(APPEND SCAN_VTK_COMPONENTS Python WrappingPythonCore)
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${SCAN_VTK_COMPONENTS})

vtk_module_find_modules(scan_module_files "${PROJECT_SOURCE_DIR}")
vtk_module_scan(
  MODULE_FILES ${scan_module_files}
  PROVIDES_MODULES scan_modules
  WANT_BY_DEFAULT ON
  ENABLE_TESTS OFF)
vtk_module_build(
  MODULES ${scan_modules}
  PACKAGE Scanwrap
  INSTALL_EXPORT Scanwrap
  INSTALL_HEADERS ON
  ENABLE_WRAPPING ${SCAN_WRAP_PYTHON}
  TEST_DIRECTORY_NAME NONE
  HEADERS_DESTINATION "${SCAN_INSTALL_INCLUDE_DIR}"
  CMAKE_DESTINATION "${SCAN_INSTALL_CMAKE_DIR}"
  HIERARCHY_DESTINATION "${CMAKE_INSTALL_LIBDIR}/vtk/hierarchy/Scanwrap")

if(SCAN_WRAP_PYTHON)
  vtk_module_wrap_python(
    MODULES ${scan_modules}
    INSTALL_EXPORT Scanwrap
    PYTHON_PACKAGE scanwrap
    MODULE_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    CMAKE_DESTINATION "${SCAN_INSTALL_CMAKE_DIR}"
    BUILD_STATIC OFF
    TARGET Scan::PythonWrapped)
endif()
