# The trade of speed for accuracy is measured by hand, hours on two cores: tools/bench trade data/trade.json.
bioprint_bench(trade
  SOURCES bench/trade.cpp bench/trade_questions.cpp
  LINKS io predict simulate cell flow rheology numerics
  PRIVATE nlohmann_json::nlohmann_json CLI11::CLI11)
add_custom_target(trade COMMAND bench_trade ${PROJECT_SOURCE_DIR}/data/trade.json --missing
                  COMMAND ${PROJECT_SOURCE_DIR}/tools/make-trade USES_TERMINAL)

bioprint_tests(ladder SOURCES unit/predict/ladder.cpp LINKS predict)
bioprint_tests(simulation_work
  SOURCES verify/simulation_work.cpp bench/trade_questions.cpp
  LINKS predict simulate
  PRIVATE nlohmann_json::nlohmann_json)
bioprint_program_tests(cli_trade SOURCES cli/trade.cpp)

# What README, manual and program say of it follows from the measured file.
add_test(NAME trade-tables COMMAND ${PROJECT_SOURCE_DIR}/tools/make-trade --check)
set_tests_properties(trade-tables PROPERTIES LABELS unsanitized)
