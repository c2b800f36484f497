bioprint_tests(lattice3d
  SOURCES unit/lattice/cross_power.cpp verify/d3q19.cpp
  LINKS lattice flow)

# Not a test: prints what the 3-D lattice reaches of the memory's speed.
find_package(OpenMP REQUIRED)
add_executable(bench_lattice3d bench/lattice3d.cpp)
target_include_directories(bench_lattice3d PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(bench_lattice3d PRIVATE bioprint_lattice bioprint_options OpenMP::OpenMP_CXX)

bioprint_tests(lattice3d_exit
  SOURCES verify/d3q19_exit.cpp
  LINKS lattice flow
  LABELS slow)

bioprint_tests(tetrahedra
  SOURCES unit/solid/tetra_solid.cpp
  LINKS solid)
