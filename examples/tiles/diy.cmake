# The target diy_mpi, or why there is none in diy_missing. DIY is header only; Debian has it in libvtk9-dev, and in paraview-dev, which
# cannot be installed beside that. GUSSET_VTK may name the folder that has vtk_mpi.h and vtkdiy2 elsewhere.
file(GLOB vtk_folders /usr/include/vtk-9* /usr/include/paraview-*)
find_path(GUSSET_VTK vtk_mpi.h PATHS ${vtk_folders} NO_DEFAULT_PATH DOC "The folder of VTK's headers")
find_package(MPI COMPONENTS C)
set(diy_missing "")
if(NOT EXISTS "${GUSSET_VTK}/vtkdiy2/include/vtkdiy2/master.hpp")
  set(diy_missing "DIY's headers (libvtk9-dev)")
elseif(NOT MPI_C_FOUND)
  set(diy_missing "MPI (libopenmpi-dev, openmpi-bin)")
else()
  add_library(diy_mpi INTERFACE)
  # Of VTK's own headers only vtk_mpi.h is used, and nothing is linked.
  target_include_directories(diy_mpi SYSTEM INTERFACE ${GUSSET_VTK}/vtkdiy2/include ${GUSSET_VTK})
  find_package(Threads REQUIRED)
  target_link_libraries(diy_mpi INTERFACE MPI::MPI_C Threads::Threads)
  # Neighbours must agree to the bit: no product is fused with a sum in one place and not in another.
  target_compile_options(diy_mpi INTERFACE -ffp-contract=off)
endif()
