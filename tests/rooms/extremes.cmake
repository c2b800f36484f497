# The simulation at the edges of what it can be asked, by hand, half an hour: tools/bench extremes.
bioprint_bench(extremes
  SOURCES bench/extremes.cpp bench/extreme_runs.cpp bench/extreme_scenes.cpp
  LINKS io flow numerics
  PRIVATE nlohmann_json::nlohmann_json)
add_dependencies(bench_extremes bioprint-predict)
target_compile_definitions(bench_extremes PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>")
