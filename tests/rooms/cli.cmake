bioprint_program_tests(cli SOURCES cli/calls.cpp cli/batches.cpp cli/laws.cpp cli/schema.cpp)

bioprint_bench(command SOURCES bench/command.cpp)
add_executable(bench_empty EXCLUDE_FROM_ALL bench/empty.cpp)
target_link_options(bench_empty PRIVATE -Wl,--no-as-needed)
target_link_libraries(bench_empty PRIVATE GSL::gsl GSL::gslcblas)
add_dependencies(bench_command bench_empty bioprint-predict)
target_compile_definitions(bench_command PRIVATE BIOPRINT_PROGRAM="$<TARGET_FILE:bioprint-predict>"
                                                 BIOPRINT_EMPTY="$<TARGET_FILE:bench_empty>")
