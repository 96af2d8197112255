# peers_bench: the library beside other programs (packages.txt, part peers). Those that are missing
# are left out, and named here and in the output. One file for each, since they are slow to compile.

add_executable(peers_bench peers_bench.cpp peers_assembly_bench.cpp peers_cut_bench.cpp)
target_link_libraries(peers_bench PRIVATE
  cleave::topology cleave_bench_meshes cleave_test_support benchmark::benchmark)
set(peers_missing "")

# peer(NAME FOUND FILE LIBRARIES..): adds FILE and what it links if FOUND holds.
function(peer name found file)
  if(${found})
    target_sources(peers_bench PRIVATE ${file})
    target_link_libraries(peers_bench PRIVATE ${ARGN})
  else()
    message(STATUS "peers_bench: without ${name}, which is not installed")
    list(APPEND peers_missing ${name})
    set(peers_missing "${peers_missing}" PARENT_SCOPE)
  endif()
endfunction()

find_package(CGAL 5.5 QUIET)
find_path(GUDHI_INCLUDE_DIR gudhi/Simplex_tree.h)
find_path(GMSH_INCLUDE_DIR gmsh.h)
find_library(GMSH_LIBRARY gmsh)
set(GMSH_FOUND OFF)
if(GMSH_INCLUDE_DIR AND GMSH_LIBRARY)
  set(GMSH_FOUND ON)
endif()
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(PETSC QUIET IMPORTED_TARGET PETSc)
endif()
find_package(MPI QUIET COMPONENTS CXX)
set(PETSC_AND_MPI_FOUND OFF)
if(PETSC_FOUND AND MPI_CXX_FOUND)
  set(PETSC_AND_MPI_FOUND ON)
endif()

peer(CGAL CGAL_FOUND
  "peer_cgal_tds.cpp;peer_cgal_loader.cpp;peer_cgal_surface.cpp;peer_cgal_seams.cpp" CGAL::CGAL)
peer(GUDHI GUDHI_INCLUDE_DIR peer_gudhi.cpp)
peer(gmsh GMSH_FOUND peer_gmsh.cpp ${GMSH_LIBRARY})
peer(PETSc PETSC_AND_MPI_FOUND peer_petsc.cpp PkgConfig::PETSC MPI::MPI_CXX)

list(JOIN peers_missing ", " peers_missing)
set_source_files_properties(peers_bench.cpp PROPERTIES
  COMPILE_DEFINITIONS "CLEAVE_PEERS_MISSING=\"${peers_missing}\"")
