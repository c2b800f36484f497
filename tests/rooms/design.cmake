# Checks, designs and uncertainty: units, then the real program.
bioprint_tests(design
  SOURCES unit/numerics/boundary.cpp unit/numerics/sampling.cpp unit/io/checks.cpp unit/io/design.cpp unit/io/uncertainty.cpp
  LINKS io numerics
  PRIVATE nlohmann_json::nlohmann_json)

bioprint_tests(cli_design
  SOURCES cli/command.cpp cli/checks.cpp cli/design.cpp cli/uncertainty.cpp support/schema.cpp
  PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(test_cli_design bioprint-predict)
target_compile_definitions(test_cli_design PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")
