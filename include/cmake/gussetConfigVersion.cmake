# Which versions will do: the binary interface is that of major.minor, and within it later is better. The version is the header's.
foreach(_gusset_up "../../.." "../../../.." "../..")
  get_filename_component(_gusset_here "${CMAKE_CURRENT_LIST_DIR}" REALPATH)
  get_filename_component(_gusset_header "${_gusset_here}/${_gusset_up}/include/gusset/base.h" ABSOLUTE)
  if(EXISTS "${_gusset_header}")
    file(STRINGS "${_gusset_header}" _gusset_line REGEX "^#define GUSSET_VERSION_STRING ")
    string(REGEX REPLACE ".*\"(.*)\"" "\\1" PACKAGE_VERSION "${_gusset_line}")
    break()
  endif()
endforeach()

set(PACKAGE_VERSION_COMPATIBLE FALSE)
set(PACKAGE_VERSION_EXACT FALSE)
string(REGEX MATCH "^[0-9]+\\.[0-9]+" _gusset_abi "${PACKAGE_VERSION}")
if(NOT PACKAGE_VERSION)
  set(PACKAGE_VERSION_UNSUITABLE TRUE)
elseif(PACKAGE_FIND_VERSION_RANGE)
  if(PACKAGE_VERSION VERSION_GREATER_EQUAL PACKAGE_FIND_VERSION_MIN
     AND (PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION_MAX
          OR (PACKAGE_FIND_VERSION_RANGE_MAX STREQUAL "INCLUDE" AND PACKAGE_VERSION VERSION_EQUAL PACKAGE_FIND_VERSION_MAX)))
    set(PACKAGE_VERSION_COMPATIBLE TRUE)
  endif()
elseif(_gusset_abi VERSION_EQUAL "${PACKAGE_FIND_VERSION_MAJOR}.${PACKAGE_FIND_VERSION_MINOR}"
       AND PACKAGE_VERSION VERSION_GREATER_EQUAL PACKAGE_FIND_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
  if(PACKAGE_VERSION VERSION_EQUAL PACKAGE_FIND_VERSION)
    set(PACKAGE_VERSION_EXACT TRUE)
  endif()
endif()
