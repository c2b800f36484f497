bioprint_tests(flow
  SOURCES unit/rheology/cross.cpp verify/nozzle_flow.cpp
  LINKS flow rheology numerics
  PRIVATE GSL::gsl)
