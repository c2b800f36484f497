# The scenes in space behind the face of the simulation.
bioprint_tests(simulate_space
  SOURCES unit/simulate/space.cpp
  LINKS simulate)

# Speed of whole scenes beside the bandwidth bound.
find_package(OpenMP REQUIRED)
bioprint_bench(scene_speed SOURCES bench/scene_speed.cpp LINKS simulate lattice PRIVATE OpenMP::OpenMP_CXX)

bioprint_tests(simulate_space_values
  SOURCES verify/space_simulation.cpp
  LINKS simulate
  LABELS slow)
bioprint_bench(reductions SOURCES bench/reductions.cpp LINKS simulate lattice)
