bioprint_tests(lattice3d
  SOURCES unit/lattice/cross_power.cpp verify/d3q19.cpp
  LINKS lattice)
