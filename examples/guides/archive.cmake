# A project without Rust: gusset comes from the archive that `make dist` writes, GUSSET_ARCHIVE.
#! [archive]
cmake_minimum_required(VERSION 3.18...3.25)
project(my_program LANGUAGES C)

include(FetchContent)
FetchContent_Declare(gusset URL ${GUSSET_ARCHIVE}) # a file or an address; add URL_HASH SHA256=... to pin it
FetchContent_MakeAvailable(gusset)

add_executable(start_c start.c)
target_link_libraries(start_c PRIVATE gusset::gusset) # or gusset::shared, gusset::static
#! [archive]
