# gusset for CMake: find_package(gusset 0.1 REQUIRED [COMPONENTS shared static])
#
#   gusset::gusset   what to link: the shared library, or the static one where that alone is installed
#   gusset::shared   the shared library
#   gusset::static   the static library, with the system libraries that it needs
#   gusset::headers  the headers alone, for those who open the library at run time
#
# Nothing is written into this file when it is installed: all is found from where it lies, so that an installation can be
# moved, and every installer installs the same text.
cmake_policy(PUSH)
cmake_policy(VERSION 3.13)

# PREFIX/lib/cmake/gusset or PREFIX/share/cmake/gusset, PREFIX/lib/ARCHITECTURE/cmake/gusset, or PREFIX/share/gusset.
get_filename_component(_gusset_here "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
foreach(_gusset_up "../../.." "../../../.." "../..")
  get_filename_component(_gusset_prefix "${_gusset_here}/${_gusset_up}" ABSOLUTE)
  if(EXISTS "${_gusset_prefix}/include/gusset.h")
    break()
  endif()
endforeach()
set(_gusset_include "${_gusset_prefix}/include")

foreach(_gusset_kind shared static)
  string(TOUPPER ${_gusset_kind} _gusset_upper)
  set(_gusset_name "${CMAKE_${_gusset_upper}_LIBRARY_PREFIX}gusset${CMAKE_${_gusset_upper}_LIBRARY_SUFFIX}")
  set(gusset_${_gusset_kind}_FOUND FALSE)
  unset(_gusset_file_${_gusset_kind})
  foreach(_gusset_folder "${_gusset_here}/../.." "${_gusset_prefix}/lib/${CMAKE_LIBRARY_ARCHITECTURE}"
          "${_gusset_prefix}/lib" "${_gusset_prefix}/lib64")
    get_filename_component(_gusset_file "${_gusset_folder}/${_gusset_name}" ABSOLUTE)
    if(EXISTS "${_gusset_file}")
      set(gusset_${_gusset_kind}_FOUND TRUE)
      set(_gusset_file_${_gusset_kind} "${_gusset_file}")
      break()
    endif()
  endforeach()
endforeach()
include("${CMAKE_CURRENT_LIST_DIR}/gussetTargets.cmake")

set(gusset_FOUND TRUE)
if(NOT EXISTS "${_gusset_prefix}/include/gusset.h" OR NOT TARGET gusset::gusset)
  set(gusset_FOUND FALSE)
  set(gusset_NOT_FOUND_MESSAGE "the headers or both libraries are missing from ${_gusset_prefix}")
endif()
foreach(_gusset_kind IN LISTS gusset_FIND_COMPONENTS)
  if(gusset_FIND_REQUIRED_${_gusset_kind} AND NOT gusset_${_gusset_kind}_FOUND)
    set(gusset_FOUND FALSE)
    set(gusset_NOT_FOUND_MESSAGE "gusset has no ${_gusset_kind} library in ${_gusset_prefix}")
  endif()
endforeach()
cmake_policy(POP)
