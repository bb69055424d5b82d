# Programs of many files that have a main each: one is linked, started and looked at by valgrind in the time of one file.

# list_programs(TARGET FOLDER NAMES SOURCE...) writes the mains of the sources as programs.h wants them, into the folder that the variable
# FOLDER will have. NAMES will have the names of the sources; a main.cpp has that of its folder.
function(list_programs target out_folder out_names)
  set(programs)
  set(names)
  foreach(source IN LISTS ARGN)
    get_filename_component(name ${source} NAME_WE)
    if(name STREQUAL main)
      get_filename_component(name ${source} DIRECTORY)
      get_filename_component(name ${name} NAME)
    endif()
    list(APPEND names ${name})
    string(APPEND programs "PROGRAM(${name})\n")
  endforeach()
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}_mains/programs.inc CONTENT "${programs}")
  set(${out_folder} ${CMAKE_CURRENT_BINARY_DIR}/${target}_mains PARENT_SCOPE)
  set(${out_names} ${names} PARENT_SCOPE)
endfunction()

# add_programs(TARGET SOURCE...) compiles C files that have a main each, into objects for one program: programs.c runs the mains by the
# names of their files.
function(add_programs target)
  set(sources ${ARGN})
  list_programs(${target} folder names ${sources})
  foreach(source name IN ZIP_LISTS sources names)
    set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS main=${name}_main)
  endforeach()
  add_library(${target} OBJECT ${sources})
  target_include_directories(${target} INTERFACE ${folder} ${tests_folder})
endfunction()

# add_joined_program(TARGET SOURCE... [PARTS SOURCE...]) makes one program of C++ files that have a main each, and of parts without, all
# compiled as one file: most of their time is that of the headers. Each takes arguments. `make lint` compiles each by itself.
function(add_joined_program target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" PARTS)
  set(sources ${arg_UNPARSED_ARGUMENTS})
  list_programs(${target} folder names ${sources})
  set(text)
  foreach(source IN LISTS arg_PARTS)
    string(APPEND text "#include \"${source}\"\n")
  endforeach()
  foreach(source name IN ZIP_LISTS sources names)
    string(APPEND text "#define main ${name}_main\n#include \"${source}\"\n#undef main\n")
  endforeach()
  file(CONFIGURE OUTPUT ${folder}/joined.cpp CONTENT "${text}")
  add_executable(${target} ${folder}/joined.cpp ${tests_folder}/programs.cpp)
  target_include_directories(${target} PRIVATE ${folder})
  target_compile_definitions(${target} PRIVATE PROGRAMS_TAKE_ARGUMENTS)
endfunction()
