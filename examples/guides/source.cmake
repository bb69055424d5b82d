# A project with the sources of gusset, in the folder GUSSET_SOURCE, which cargo builds along with it.
#! [source]
cmake_minimum_required(VERSION 3.18...3.25)
project(my_program LANGUAGES C)

include(FetchContent)
FetchContent_Declare(gusset SOURCE_DIR ${GUSSET_SOURCE}) # or GIT_REPOSITORY and GIT_TAG
FetchContent_MakeAvailable(gusset)

add_executable(start_c start.c)
target_link_libraries(start_c PRIVATE gusset::gusset) # or gusset::shared, gusset::static
#! [source]
