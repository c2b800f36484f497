bioprint_tests(lattice3d
  SOURCES unit/lattice/cross_power.cpp verify/d3q19.cpp verify/d3q19_window.cpp
  LINKS lattice flow)

find_package(OpenMP REQUIRED)
bioprint_bench(lattice3d SOURCES bench/lattice3d.cpp LINKS lattice PRIVATE OpenMP::OpenMP_CXX)

bioprint_tests(lattice3d_exit
  SOURCES verify/d3q19_exit.cpp
  LINKS lattice flow
  LABELS campaign)


bioprint_tests(tetrahedra
  SOURCES unit/solid/tetra_solid.cpp
  LINKS solid)

bioprint_tests(simulate3d
  SOURCES unit/simulate/immersed_body.cpp verify/shear_scene.cpp
  LINKS simulate cell)

bioprint_tests(simulate3d_convergence
  SOURCES verify/shear_scene_convergence.cpp
  LINKS simulate cell
  LABELS slow)

bioprint_tests(simulate3d_offset
  SOURCES verify/offset_scenes.cpp
  LINKS simulate cell flow
  LABELS slow)
