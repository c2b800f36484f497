bioprint_tests(cli
  SOURCES cli/command.cpp cli/calls.cpp cli/batches.cpp
  PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(test_cli bioprint-predict)
target_compile_definitions(test_cli PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")
