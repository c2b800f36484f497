# cmake -S . -B build/fuzz -G Ninja -DBIOPRINT_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++
# build/fuzz/tests/fuzz_csv -max_total_time=600
if(BIOPRINT_FUZZ)
  set(fuzzed text decimal units quantity quantity_list quantity_messages number_format byte_source csv csv_dialect
             json_lines)
  list(TRANSFORM fuzzed PREPEND ${PROJECT_SOURCE_DIR}/src/io/)
  list(TRANSFORM fuzzed APPEND .cpp)
  foreach(target quantity csv json_lines)
    add_executable(fuzz_${target} ${PROJECT_SOURCE_DIR}/tests/fuzz/${target}.cpp ${fuzzed})
    target_include_directories(fuzz_${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/include)
    target_link_libraries(fuzz_${target} PRIVATE nlohmann_json::nlohmann_json)
    target_compile_options(fuzz_${target} PRIVATE -O1 -g -fsanitize=fuzzer,address,undefined
                                                  -fno-sanitize-recover=all)
    target_link_options(fuzz_${target} PRIVATE -fsanitize=fuzzer,address,undefined)
  endforeach()
endif()
