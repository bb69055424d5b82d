# Programs, in the languages that the project has enabled, and a plugin of somebody else's against the targets of gusset; and what they must
# be linked with.
enable_testing()
add_compile_options(-Wall -Wextra -Wpedantic -Werror)
set(languages c)
get_property(enabled GLOBAL PROPERTY ENABLED_LANGUAGES)
if(CXX IN_LIST enabled)
  list(APPEND languages cpp)
endif()
foreach(kind gusset shared static)
  foreach(language IN LISTS languages)
    add_executable(${kind}_${language} ${CMAKE_CURRENT_LIST_DIR}/app.${language})
    target_link_libraries(${kind}_${language} PRIVATE gusset::${kind})
    add_test(NAME ${kind}_${language} COMMAND ${kind}_${language})
    set_tests_properties(${kind}_${language} PROPERTIES PASS_REGULAR_EXPRESSION "10 vertices, 16 faces")
  endforeach()
endforeach()

add_library(plugin MODULE ${CMAKE_CURRENT_LIST_DIR}/plugin.c)
target_link_libraries(plugin PRIVATE gusset::static)
find_package(Threads REQUIRED)
add_executable(host ${CMAKE_CURRENT_LIST_DIR}/host.c)
target_link_libraries(host PRIVATE Threads::Threads ${CMAKE_DL_LIBS})
add_test(NAME plugin COMMAND host $<TARGET_FILE:plugin>)
# What it holds of gusset is its own affair.
add_test(NAME plugin_symbols COMMAND ${CMAKE_NM} -D --defined-only $<TARGET_FILE:plugin>)
set_tests_properties(plugin_symbols PROPERTIES PASS_REGULAR_EXPRESSION "plugin_run" FAIL_REGULAR_EXPRESSION "gusset_")

# The headers alone: compiles, and must not link the library.
add_library(headers OBJECT ${CMAKE_CURRENT_LIST_DIR}/app.c)
target_link_libraries(headers PRIVATE gusset::headers)
# A library is linked by its SONAME.
foreach(language IN LISTS languages)
  add_test(NAME needed_${language} COMMAND readelf -dW $<TARGET_FILE:gusset_${language}>)
  set_tests_properties(needed_${language} PROPERTIES PASS_REGULAR_EXPRESSION "NEEDED.*\\[libgusset\\.so\\.0\\.[0-9]+\\]")
  add_test(NAME alone_${language} COMMAND readelf -dW $<TARGET_FILE:static_${language}>)
  set_tests_properties(alone_${language} PROPERTIES PASS_REGULAR_EXPRESSION "NEEDED" FAIL_REGULAR_EXPRESSION "libgusset")
  # Of the static library a program has what it calls.
  add_test(NAME size_${language} COMMAND find $<TARGET_FILE:static_${language}> -size -2250000c)
  set_tests_properties(size_${language} PROPERTIES PASS_REGULAR_EXPRESSION "static_${language}")
endforeach()
