bioprint_tests(fit
  SOURCES verify/fit_coverage.cpp
  LINKS rheology)
