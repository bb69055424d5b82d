# What every project here begins with: C++17, Release, and gusset as it was installed under GUSSET_PREFIX, by pkg-config.
set(GUSSET_PREFIX "" CACHE PATH "Where gusset is installed")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

find_package(PkgConfig REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${GUSSET_PREFIX}/lib/pkgconfig)
pkg_check_modules(gusset REQUIRED IMPORTED_TARGET gusset)
set(CMAKE_BUILD_RPATH ${GUSSET_PREFIX}/lib)

find_package(OpenMesh REQUIRED)
find_package(CGAL REQUIRED)
