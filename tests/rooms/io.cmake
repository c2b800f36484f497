find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)

bioprint_tests(io
  SOURCES unit/io/quantity.cpp unit/io/quantity_list.cpp unit/io/number_format.cpp unit/io/units_oracle.cpp
          unit/io/text.cpp unit/io/csv.cpp unit/io/json_lines.cpp unit/io/whole_file.cpp unit/io/simulation_refinement.cpp unit/io/presets.cpp unit/io/schema.cpp support/schema.cpp
  LINKS io
  PRIVATE nlohmann_json::nlohmann_json ${UDUNITS2_LIBRARY})

bioprint_bench(csv SOURCES bench/csv.cpp LINKS io)
