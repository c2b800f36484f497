# The trade of speed for accuracy: measured by hand with `tools/bench trade FILE`, hours on two cores.
bioprint_bench(trade
  SOURCES bench/trade.cpp bench/trade_questions.cpp
  LINKS predict simulate cell flow rheology numerics
  PRIVATE nlohmann_json::nlohmann_json)
