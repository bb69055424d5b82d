# The documentation is compiled, run and complete: the examples of the reference and of the guides, and the reference itself. `make lint`
# builds the site.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

# Once for all who run them: here as they are, in cpp_tests/threads in many threads at once.
set(reference_names meshes stitching scans attributes developments sections curves nets nets_joined surfaces)
foreach(name IN LISTS reference_names)
  list(APPEND reference_sources ${root}/examples/reference/${name}.c)
  add_test(NAME reference/${name} COMMAND reference ${name})
endforeach()
add_programs(reference_programs ${reference_sources})
set_target_properties(reference_programs PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)
target_compile_options(reference_programs PRIVATE ${strict} -Wconversion -Wshadow)
target_link_libraries(reference_programs PUBLIC PkgConfig::gusset m)
add_executable(reference ${tests_folder}/programs.c)
target_link_libraries(reference PRIVATE reference_programs)

# What the guides show, built once and as a reader would, but told to warn; their pages are held against these files by
# tests/docs/snippets.rs.
set(guides ${root}/examples/guides)
set(guide_programs ${CMAKE_BINARY_DIR}/guides/project)
set(guide_warnings "-Wall -Wextra -Werror -pedantic -Wshadow")
add_test(NAME guides/project COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${guides} ${guide_programs} ${not_anew}
         --build-options -DCMAKE_PREFIX_PATH=${GUSSET_PREFIX} -DCMAKE_C_STANDARD=99 -DCMAKE_C_EXTENSIONS=OFF -DCMAKE_CXX_EXTENSIONS=OFF
         "-DCMAKE_C_FLAGS=${guide_warnings} -Wconversion" "-DCMAKE_CXX_FLAGS=${much_memory} ${guide_warnings} -Wno-maybe-uninitialized"
         --test-command start_c)
set_tests_properties(guides/project PROPERTIES FIXTURES_SETUP guide_programs)

add_test(NAME guides/c COMMAND ${guide_programs}/start_c)
set_tests_properties(guides/c PROPERTIES PASS_REGULAR_EXPRESSION "a loop of 4 vertices.*; 0 loops left.*the first new vertex has the normal")
add_test(NAME guides/cpp COMMAND ${guide_programs}/start_cpp)
set_tests_properties(guides/cpp PROPERTIES PASS_REGULAR_EXPRESSION
                     "0 loops left.*corner 2\n.*cancelled.*joined\n0 loops left.*2 and 3 triangles on 5 points.*M.*proved.*a ring of.*quads, closed: 1")
add_test(NAME guides/openmesh COMMAND ${guide_programs}/with_openmesh left.obj right.obj WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/generated)
set_tests_properties(guides/openmesh PROPERTIES FIXTURES_REQUIRED generated)
add_test(NAME guides/cgal COMMAND ${guide_programs}/with_cgal)
add_test(NAME guides/eigen COMMAND ${guide_programs}/with_eigen)
set_tests_properties(guides/eigen PROPERTIES PASS_REGULAR_EXPRESSION "^5 vertices, 6 faces")
# A host links nothing of ours.
add_test(NAME guides/plugin COMMAND ${guide_programs}/plugin_host ${GUSSET_PREFIX}/lib/libgusset.so)
set_tests_properties(guides/plugin PROPERTIES PASS_REGULAR_EXPRESSION "weld: .*4 vertices are left of 6")
foreach(name c cpp openmesh cgal eigen plugin)
  set_property(TEST guides/${name} APPEND PROPERTY FIXTURES_REQUIRED guide_programs)
endforeach()

# With the program that is tested.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/cli_guide)
foreach(side left right)
  file(CREATE_LINK ${CMAKE_BINARY_DIR}/generated/${side}.obj ${CMAKE_BINARY_DIR}/cli_guide/${side}.obj SYMBOLIC)
endforeach()
add_test(NAME guides/cli COMMAND ${CMAKE_COMMAND} -E env "PATH=$<TARGET_FILE_DIR:gusset-cli>:$ENV{PATH}" ${guides}/cli.sh
         WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/cli_guide)
set_tests_properties(guides/cli PROPERTIES FIXTURES_REQUIRED generated PASS_REGULAR_EXPRESSION
                     "joined loops of.*boundary loops? by.*boundary_loops .*-p meridians=")

# With what `make wasm` built, if it did.
find_program(NODE node)
if(NODE AND EXISTS ${root}/wasm/gusset.wasm)
  add_test(NAME guides/wasm COMMAND ${NODE} ${root}/examples/wasm/first.mjs)
  set_tests_properties(guides/wasm PROPERTIES PASS_REGULAR_EXPRESSION "index_out_of_range")
  add_test(NAME guides/wasm_files COMMAND ${NODE} ${root}/examples/wasm/files.mjs)
  set_tests_properties(guides/wasm_files PROPERTIES PASS_REGULAR_EXPRESSION "bad_file broken.obj:2:")
endif()

# The commands of the guides: by hand, and as a project of a reader's.
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/guides)
add_test(NAME guides/commands COMMAND ${guides}/build.sh WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/guides)
set_tests_properties(guides/commands PROPERTIES ENVIRONMENT PKG_CONFIG_PATH=${GUSSET_PREFIX}/lib/pkgconfig)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/home)
file(CREATE_LINK ${GUSSET_PREFIX} ${CMAKE_BINARY_DIR}/home/gusset SYMBOLIC)
configure_file(${root}/examples/c/stitch.c ${CMAKE_BINARY_DIR}/home/stitch.c COPYONLY)
add_test(NAME guides/five_minutes COMMAND ${guides}/five_minutes.sh WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/home)
set_tests_properties(guides/five_minutes PROPERTIES ENVIRONMENT HOME=${CMAKE_BINARY_DIR}/home
                     PASS_REGULAR_EXPRESSION "10 vertices, 16 faces")
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/home/project)
add_test(NAME guides/project_commands COMMAND ${guides}/project.sh WORKING_DIRECTORY ${CMAKE_BINARY_DIR}/home/project)
set_tests_properties(guides/project_commands PROPERTIES ENVIRONMENT HOME=${CMAKE_BINARY_DIR}/home
                     PASS_REGULAR_EXPRESSION "; 0 loops left")

# docs/guides/linking.md: start.c in a project that fetches gusset, as sources and as the archive.
set(fetched_source -DGUSSET_SOURCE=${root} -DGUSSET_CARGO_TARGET_DIR=${root}/target)
if(DEFINED ENV{CARGO_TARGET_DIR})
  set(fetched_source -DGUSSET_SOURCE=${root} -DGUSSET_CARGO_TARGET_DIR=$ENV{CARGO_TARGET_DIR})
endif()
set(fetched_archive -DGUSSET_ARCHIVE=${GUSSET_ARCHIVE})
foreach(project source archive)
  configure_file(${guides}/start.c ${CMAKE_BINARY_DIR}/guides/${project}/start.c COPYONLY)
endforeach()
configure_file(${guides}/source.cmake ${CMAKE_BINARY_DIR}/guides/source/CMakeLists.txt COPYONLY)
configure_file(${guides}/archive.cmake ${CMAKE_BINARY_DIR}/guides/archive/CMakeLists.txt COPYONLY)
foreach(project source archive)
  if(project STREQUAL source OR GUSSET_ARCHIVE)
    add_test(NAME guides/${project} COMMAND ${CMAKE_CTEST_COMMAND} --build-and-test ${CMAKE_BINARY_DIR}/guides/${project}
             ${CMAKE_BINARY_DIR}/guides/${project}/build ${not_anew}
             --build-options ${fetched_${project}} --test-command start_c)
    set_tests_properties(guides/${project} PROPERTIES PASS_REGULAR_EXPRESSION "; 0 loops left")
  endif()
endforeach()
# Not beside others that build by cargo.
set_tests_properties(guides/source PROPERTIES RESOURCE_LOCK cargo)

# What draws the pictures, the page and the figures of the papers, in one program.
set(figures ${root}/examples/figures)
add_joined_program(drawings ${figures}/main.cpp ${root}/examples/pictures/gallery.cpp ${root}/examples/pictures/showcases.cpp
                   PARTS ${figures}/nesterenko.cpp ${figures}/deryagin.cpp ${figures}/deryagin_gluing.cpp ${figures}/leus.cpp ${figures}/nadopta.cpp)
target_compile_options(drawings PRIVATE ${strict} -Wconversion -Wshadow)
target_link_libraries(drawings PRIVATE PkgConfig::gusset)

# The pictures: the same bytes each time.
foreach(time first second)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/pictures/${time})
  add_test(NAME pictures/${time} COMMAND drawings gallery ${CMAKE_BINARY_DIR}/pictures/${time})
  set_tests_properties(pictures/${time} PROPERTIES FIXTURES_SETUP pictures)
endforeach()
foreach(name stitch pieces fill sections meet)
  add_test(NAME pictures/${name} COMMAND ${CMAKE_COMMAND} -E compare_files ${CMAKE_BINARY_DIR}/pictures/first/${name}.svg
           ${CMAKE_BINARY_DIR}/pictures/second/${name}.svg)
  set_tests_properties(pictures/${name} PROPERTIES FIXTURES_REQUIRED pictures)
endforeach()

# The figures of the papers: the same bytes each time, and the numbers of docs/papers.md.
foreach(time first second)
  file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/papers/${time})
  add_test(NAME figures/${time} COMMAND drawings figures ${CMAKE_BINARY_DIR}/papers/${time})
  set_tests_properties(figures/${time} PROPERTIES FIXTURES_SETUP figures PASS_REGULAR_EXPRESSION
                       "H 1000 0100 0100 0010 0010 0001 0001.*13 quads, 2 triangles.*sphere chi 1 1 0 0 2; torus chi 1 1 0 0 0\
.*18 local gluings.*two poles 33 ones, chi 2; .*torus 22 ones, chi 0.*2 of 1, 2 of 2, 2 of 9, 2 of 10.*integer diameter 5\
.*J 4, .*22 of 196 cells left.*off the point less than 1e-12.*at t = 0.5 0.25 0.50 0.25")
endforeach()
foreach(paper nesterenko:5 deryagin:9 leus:4 nadopta:3)
  string(REPLACE ":" ";" paper ${paper})
  list(GET paper 0 author)
  list(GET paper 1 count)
  foreach(number RANGE 1 ${count})
    set(name ${author}_${number})
    add_test(NAME figures/${name} COMMAND ${CMAKE_COMMAND} -E compare_files ${CMAKE_BINARY_DIR}/papers/first/${name}.svg
             ${CMAKE_BINARY_DIR}/papers/second/${name}.svg)
    set_tests_properties(figures/${name} PROPERTIES FIXTURES_REQUIRED figures)
  endforeach()
endforeach()

# The showcases of docs/guides/workshop.md: what they state must hold of shapes by formula, with pictures of the same bytes each time,
# and of real data; skipped where there are none.
set(workshop_last_real carcass/foot_stations_z.json)
set(workshop_ship_real carcass/hull_gunnerus_points.csv)
set(workshop_wrist_real pairs/body_hand/body_741_no_left_hand.obj pairs/body_hand/hand_hires.obj)
set(workshop_relief_real grids/volcano_maunga_whau_61x87.csv)
set(workshop_relief_options --spacing 10)
set(workshop_last_says "frame: 17 x 48 nodes.*foot: net of .* mesh within.*last: net of .* mesh within.*2 darts, energy 4.0")
set(workshop_ship_says "0 loops left.*Euler characteristic 2,.*mesh .*surface .*table ")
set(workshop_wrist_says "joined: 6 edges to 52.*result: .* loops of 4 6 4\n")
set(workshop_relief_says "after: .* 3 components, 5 loops.* 0 bow-ties")
foreach(name last ship wrist relief)
  foreach(time first second)
    file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/workshop/${time})
    set(pictures --picture ${CMAKE_BINARY_DIR}/workshop/${time}/${name}.svg --page ${CMAKE_BINARY_DIR}/workshop/${time}/${name})
    if(name STREQUAL last)
      list(APPEND pictures --pattern ${CMAKE_BINARY_DIR}/workshop/${time}/pattern.svg)
    endif()
    add_test(NAME workshop/${name}/${time} COMMAND examples ${name} - ${pictures})
    set_tests_properties(workshop/${name}/${time} PROPERTIES FIXTURES_SETUP workshop_${name})
  endforeach()
  # Of the first run what it prints counts, of the second its status.
  set_tests_properties(workshop/${name}/first PROPERTIES PASS_REGULAR_EXPRESSION "${workshop_${name}_says}"
                       FAIL_REGULAR_EXPRESSION "does not hold")
  add_test(NAME workshop/${name}/real COMMAND ${CMAKE_COMMAND} "-DPROGRAM=$<TARGET_FILE:examples>;${name}" "-DFILES=${workshop_${name}_real}"
           "-DOPTIONS=${workshop_${name}_options}" "-DDEFAULT=${root}/../shared/data" -P ${CMAKE_CURRENT_SOURCE_DIR}/real.cmake)
  set_tests_properties(workshop/${name}/real PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")
endforeach()
foreach(picture last:last.svg last:pattern.svg last:last.bin last:last.json ship:ship.svg ship:ship.bin ship:ship.json wrist:wrist.svg
        wrist:wrist.bin wrist:wrist.json relief:relief.svg relief:relief.bin relief:relief.json)
  string(REPLACE ":" ";" picture ${picture})
  list(GET picture 0 name)
  list(GET picture 1 file)
  add_test(NAME workshop/${name}/same_${file} COMMAND ${CMAKE_COMMAND} -E compare_files ${CMAKE_BINARY_DIR}/workshop/first/${file}
           ${CMAKE_BINARY_DIR}/workshop/second/${file})
  set_tests_properties(workshop/${name}/same_${file} PROPERTIES FIXTURES_REQUIRED workshop_${name})
endforeach()

begin_early(guides/project)
