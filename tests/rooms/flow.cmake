bioprint_tests(flow
  SOURCES unit/rheology/cross.cpp unit/rheology/laws.cpp verify/nozzle_flow.cpp
  LINKS flow rheology numerics
  PRIVATE GSL::gsl)
