# The targets, for whoever has set
#   _gusset_include        the folder of the headers
#   _gusset_file_shared    the libraries, or nothing for one that is missing
#   _gusset_file_static
#   _gusset_scope          GLOBAL, or nothing for targets of this folder alone
if(NOT TARGET gusset::headers)
  add_library(gusset::headers INTERFACE IMPORTED ${_gusset_scope})
  set_target_properties(gusset::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${_gusset_include}")
endif()

foreach(_gusset_kind shared static)
  if(_gusset_file_${_gusset_kind} AND NOT TARGET gusset::${_gusset_kind})
    string(TOUPPER ${_gusset_kind} _gusset_upper)
    add_library(gusset::${_gusset_kind} ${_gusset_upper} IMPORTED ${_gusset_scope})
    set_target_properties(gusset::${_gusset_kind} PROPERTIES
                          IMPORTED_LOCATION "${_gusset_file_${_gusset_kind}}" INTERFACE_LINK_LIBRARIES gusset::headers)
    if(_gusset_kind STREQUAL static AND CMAKE_SYSTEM_NAME STREQUAL "Linux")
      # Each function has a section of its own, and programs take those that they call. A library that holds gusset must stay
      # mapped once it is loaded, as threads of the host may still end inside the Rust runtime after it is closed; and it keeps
      # gusset's symbols to itself, lest those of another copy take their place.
      set_target_properties(gusset::static PROPERTIES
        INTERFACE_LINK_LIBRARIES "gusset::headers;-lgcc_s;-lutil;-lrt;-lpthread;-lm;-ldl;-lc"
        INTERFACE_LINK_OPTIONS "LINKER:--gc-sections;LINKER:-z,nodelete;LINKER:--exclude-libs,libgusset.a")
    endif()
  endif()
endforeach()

foreach(_gusset_kind shared static)
  if(TARGET gusset::${_gusset_kind} AND NOT TARGET gusset::gusset)
    add_library(gusset::gusset INTERFACE IMPORTED ${_gusset_scope})
    set_target_properties(gusset::gusset PROPERTIES INTERFACE_LINK_LIBRARIES gusset::${_gusset_kind})
  endif()
endforeach()
