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

bioprint_tests(fit_command
  SOURCES cli/command.cpp cli/fit.cpp support/rheometer_export.cpp support/schema.cpp
  PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(test_fit_command bioprint-predict)
target_compile_definitions(test_fit_command PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")
