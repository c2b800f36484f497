# The simulation at the edges of what it can be asked, by hand, half an hour: tools/bench extremes.
set(extremes_sources bench/extreme_runs.cpp bench/extreme_scenes.cpp)
bioprint_bench(extremes
  SOURCES bench/extremes.cpp ${extremes_sources}
  LINKS io flow numerics
  PRIVATE nlohmann_json::nlohmann_json CLI11::CLI11)
bioprint_tests(extremes
  SOURCES verify/extremes.cpp ${extremes_sources}
  LINKS io flow numerics
  LABELS slow
  PRIVATE nlohmann_json::nlohmann_json)
foreach(target bench_extremes test_extremes)
  add_dependencies(${target} bioprint-predict)
  target_compile_definitions(${target} PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")
endforeach()

# The map in the manual follows from the table.
add_test(NAME extremes-counts COMMAND ${PROJECT_SOURCE_DIR}/tools/make-extremes --check)
set_tests_properties(extremes-counts PROPERTIES LABELS unsanitized)

# The flow against closed forms with 50 digits; the whole map by hand.
add_test(NAME accuracy COMMAND ${PROJECT_SOURCE_DIR}/tools/make-accuracy --check --coarse $<TARGET_FILE:bioprint-predict>)
set_tests_properties(accuracy PROPERTIES LABELS "slow")

# Ten million random calls, one in a thousand carried in time: some twenty minutes.
add_test(NAME random_calls_campaign COMMAND test_random_calls)
set_tests_properties(random_calls_campaign PROPERTIES LABELS campaign
  ENVIRONMENT "RC_PARAMS=max_success=10000000 max_size=1000 seed=1001;BIOPRINT_ONE_CARRIED_IN=1000")
