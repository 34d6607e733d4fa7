# SPDX-FileCopyrightText: The Scanwrap authors
# SPDX-License-Identifier: GPL-3.0-or-later

# Fails when an include crosses a layer: cmake -DSOURCE=<repository> -P layering_test.cmake
# With -DSELF_TEST=<folder> the rules are first tried on a made-up tree that breaks each of them.
cmake_minimum_required(VERSION 3.25)

# <folder> <folders of ours that it may include>; the longest matching folder counts
set(layers
  "filters/base=filters/base"
  "filters/geometry=filters/base filters/geometry"
  "filters=filters"
  "readers=readers filters/base filters/geometry"
  "writers=writers filters/base filters/geometry"
  "device=device filters/base"
  "pipeline=pipeline filters readers writers device"
  "app=app pipeline filters/base")

# The VTK shells; everything else below filters, readers, writers and device is free of VTK
set(shells "(^|/)vtkScan[^/]*$|^filters/analysis/|^filters/points/|^filters/surface/|^filters/wrap/")
set(vtk_free "^(filters|readers|writers|device)/")
# The bridge of the base layer knows the meshes and regions of the next one
set(bridge "^filters/base/vtkScan(MeshBridge|Regions)\\.(h|cxx)$")

# The rule that FILE breaks by INCLUDE, or an empty string
function(find_breach file include result)
  set(${result} "" PARENT_SCOPE)
  if(include MATCHES "^(vtk[A-Z]|Scan[A-Za-z]+Module\\.h)" AND file MATCHES "${vtk_free}" AND NOT file MATCHES "${shells}")
    set(${result} "VTK outside the shells" PARENT_SCOPE)
  elseif(include MATCHES "^Q[A-Za-z]" AND NOT file MATCHES "^app/gui/")
    set(${result} "Qt outside app/gui" PARENT_SCOPE)
  elseif(include MATCHES "^(filters|readers|writers|device|pipeline|app)/")
    foreach(layer IN LISTS layers)
      string(REGEX MATCH "^([^=]+)=(.+)$" unused "${layer}")
      set(folder "${CMAKE_MATCH_1}")
      string(REPLACE " " "|" allowed "${CMAKE_MATCH_2}")
      if(file MATCHES "^${folder}/")
        if(NOT include MATCHES "^(${allowed})/" AND NOT file MATCHES "${bridge}")
          set(${result} "${folder} may include ${allowed} only" PARENT_SCOPE)
        endif()
        return()
      endif()
    endforeach()
  endif()
endfunction()

function(find_breaches root result)
  set(breaches)
  file(GLOB_RECURSE files RELATIVE "${root}"
    "${root}/filters/*.h" "${root}/filters/*.cxx" "${root}/readers/*.h" "${root}/readers/*.cxx"
    "${root}/writers/*.h" "${root}/writers/*.cxx" "${root}/device/*.h" "${root}/device/*.cxx"
    "${root}/pipeline/*.h" "${root}/pipeline/*.cxx" "${root}/app/*.h" "${root}/app/*.cxx")
  foreach(file IN LISTS files)
    file(STRINGS "${root}/${file}" lines REGEX "^ *# *include")
    foreach(line IN LISTS lines)
      if(line MATCHES "[<\"]([^>\"]+)[>\"]")
        find_breach("${file}" "${CMAKE_MATCH_1}" breach)
        if(breach)
          list(APPEND breaches "${file}: ${CMAKE_MATCH_1}: ${breach}")
        endif()
      endif()
    endforeach()
  endforeach()
  list(LENGTH files count)
  message(STATUS "${count} files below ${root}")
  set(${result} "${breaches}" PARENT_SCOPE)
endfunction()

function(write_source path include)
  file(WRITE "${SELF_TEST}/${path}" "#include ${include}\n")
endfunction()

if(SELF_TEST)
  file(REMOVE_RECURSE "${SELF_TEST}")
  write_source(filters/base/a.h "\"filters/geometry/mesh.h\"")
  write_source(filters/geometry/b.cxx "<vtkPolyData.h>")
  write_source(filters/wrap/c.cxx "\"readers/ply.h\"")
  write_source(readers/d.cxx "\"pipeline/runner.h\"")
  write_source(writers/e.h "<QString>")
  write_source(app/cli/f.cxx "\"readers/ply.h\"")
  write_source(pipeline/g.cxx "\"app/cli/help.h\"")
  write_source(readers/vtkScanFineReader.cxx "<vtkPolyData.h>")
  write_source(filters/wrap/fine.cxx "\"filters/geometry/mesh.h\"")
  write_source(app/gui/fine.cxx "<QString>")
  find_breaches("${SELF_TEST}" breaches)
  list(LENGTH breaches count)
  if(NOT count EQUAL 7 OR breaches MATCHES "ine\\.|FineReader")
    list(JOIN breaches "\n" text)
    message(FATAL_ERROR "the rules should find the 7 breaches of the made-up tree, found:\n${text}")
  endif()
endif()

find_breaches("${SOURCE}" breaches)
if(breaches)
  list(JOIN breaches "\n" text)
  message(FATAL_ERROR "includes that cross a layer:\n${text}")
endif()
