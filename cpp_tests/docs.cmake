# The documentation is compiled, run and complete: the examples of the reference and of the guides, the reference itself, the site.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

foreach(name meshes stitching curves nets nets_joined surfaces)
  add_executable(reference_${name} ${root}/examples/reference/${name}.c)
  set_target_properties(reference_${name} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
  target_compile_options(reference_${name} PRIVATE ${strict} -Wconversion -Wshadow)
  target_link_libraries(reference_${name} PRIVATE PkgConfig::gusset m)
  add_test(NAME reference/${name} COMMAND reference_${name})
endforeach()

# Every function of the header: what it takes, gives and costs, and an example that is among those above.
add_test(NAME docs/reference COMMAND Python3::Interpreter ${root}/scripts/reference.py --check)

find_program(DOXYGEN doxygen)
if(DOXYGEN)
  add_test(NAME docs/site COMMAND ${root}/scripts/docs.sh)
endif()
