# cleave_bench_meshes: the meshes that are no grids, bench_meshes.hpp. CGAL makes them, once; where
# it is missing the benchmarks do without them.
set(meshes ${CMAKE_CURRENT_BINARY_DIR}/meshes)
file(MAKE_DIRECTORY ${meshes})

add_library(cleave_bench_meshes STATIC bench_meshes.cpp)
target_include_directories(cleave_bench_meshes PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(cleave_bench_meshes PUBLIC cleave::topology cleave_test_support)
target_compile_definitions(cleave_bench_meshes PRIVATE CLEAVE_BENCH_MESHES="${meshes}")

find_package(CGAL 5.5 QUIET)
find_package(ZLIB QUIET)
find_file(CGAL_DEMO_DATA data.tar.gz PATHS /usr/share/doc/libcgal-dev NO_DEFAULT_PATH)
set(made "")
if(CGAL_FOUND)
  add_executable(mesh_points mesh_points.cpp)
  target_link_libraries(mesh_points PRIVATE CGAL::CGAL)
  add_custom_command(OUTPUT ${meshes}/points.mesh
    COMMAND mesh_points 1000000 ${meshes}/points.mesh
    COMMENT "The Delaunay triangulation of a million points" VERBATIM)
  list(APPEND made ${meshes}/points.mesh)
else()
  message(STATUS "benchmarks: without the mesh of random points, since there is no CGAL")
endif()
if(CGAL_FOUND AND ZLIB_FOUND AND CGAL_DEMO_DATA)
  add_executable(mesh_liver ${PROJECT_SOURCE_DIR}/data/mesh_liver.cpp)
  target_compile_definitions(mesh_liver PRIVATE CGAL_USE_ZLIB=1)
  target_link_libraries(mesh_liver PRIVATE CGAL::CGAL ZLIB::ZLIB)
  add_custom_command(OUTPUT ${meshes}/liver.mesh
    COMMAND ${CMAKE_COMMAND} -E tar xzf ${CGAL_DEMO_DATA} data/images/liver.inr.gz
    COMMAND mesh_liver data/images/liver.inr.gz 2 ${meshes}/liver.mesh
    WORKING_DIRECTORY ${meshes}
    COMMENT "A liver of a million tetrahedra (a minute)" VERBATIM)
  list(APPEND made ${meshes}/liver.mesh)
else()
  message(STATUS "benchmarks: without the liver, which needs CGAL, zlib and the image in "
    "Debian's libcgal-demo")
endif()
add_custom_target(bench_meshes ALL DEPENDS ${made})
