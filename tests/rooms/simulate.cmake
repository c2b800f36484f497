bioprint_tests(axisymmetric
  SOURCES
    unit/lattice/axisymmetric.cpp
    unit/lattice/fast_power.cpp
    unit/simulate/simulation.cpp
    unit/solid/ring_points.cpp
    unit/solid/ring_triangles.cpp
    verify/axisymmetric_tube.cpp
    verify/simulate_channel.cpp
  LINKS simulate flow rheology lattice solid)

bioprint_tests(exit_flow
  SOURCES validate/exit_flow.cpp
  LINKS simulate)

bioprint_tests(simulate_convergence
  SOURCES verify/simulate_convergence.cpp
  LINKS simulate
  LABELS slow)

# Writes tests/reference/exit_cell_simulated.csv.
add_executable(exit_cell_table EXCLUDE_FROM_ALL bench/exit_cell_table.cpp)
target_link_libraries(exit_cell_table PRIVATE bioprint_simulate)

# Speed of the kernels beside the bandwidth bound.
add_executable(axisymmetric_speed EXCLUDE_FROM_ALL bench/axisymmetric_speed.cpp)
target_include_directories(axisymmetric_speed PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(axisymmetric_speed PRIVATE bioprint_lattice)
