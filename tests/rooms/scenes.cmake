# The scenes in space behind the face of the simulation.
bioprint_tests(simulate_space
  SOURCES unit/simulate/space.cpp
  LINKS simulate)
