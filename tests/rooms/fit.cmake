bioprint_tests(fit
  SOURCES unit/numerics/least_squares.cpp unit/rheology/flow_curve_fit.cpp
  LINKS rheology)

# 1000 random inks.
bioprint_tests(fit_coverage
  SOURCES verify/fit_coverage.cpp
  LINKS rheology
  LABELS slow)

bioprint_tests(rheometer
  SOURCES unit/io/rheometer_reader.cpp verify/fit_exports.cpp support/rheometer_export.cpp
  LINKS io)

# The command itself.
target_sources(test_cli PRIVATE cli/fit.cpp support/rheometer_export.cpp)
