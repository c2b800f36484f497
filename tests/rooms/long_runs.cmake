bioprint_tests(cli_long_runs
  SOURCES cli/command.cpp cli/long_runs.cpp
  PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(test_cli_long_runs bioprint-predict)
target_compile_definitions(test_cli_long_runs PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")

# Killed at random moments and taken up again: a few times here, 200 times by hand.
add_test(NAME kills COMMAND python3 ${PROJECT_SOURCE_DIR}/tests/faults/kills.py $<TARGET_FILE:bioprint-predict> --repeats 6)
set_tests_properties(kills PROPERTIES LABELS "slow")
add_test(NAME kills_campaign
  COMMAND python3 ${PROJECT_SOURCE_DIR}/tests/faults/kills.py $<TARGET_FILE:bioprint-predict> --repeats 200)
set_tests_properties(kills_campaign PROPERTIES LABELS "campaign")
