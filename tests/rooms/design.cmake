# Checks, designs and uncertainty: units, then the real program.
bioprint_tests(design
  SOURCES unit/numerics/boundary.cpp unit/numerics/sampling.cpp unit/io/checks.cpp unit/io/design.cpp unit/io/uncertainty.cpp verify/fit_uncertainty.cpp
  LINKS io numerics
  PRIVATE nlohmann_json::nlohmann_json)

bioprint_program_tests(cli_design SOURCES cli/checks.cpp cli/design.cpp cli/uncertainty.cpp)
