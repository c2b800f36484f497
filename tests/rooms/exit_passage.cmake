bioprint_tests(exit_passage
  SOURCES validate/exit_passage.cpp verify/exit_field.cpp verify/streamline_passage.cpp verify/size_effect.cpp verify/population.cpp
    ${PROJECT_SOURCE_DIR}/src/predict/exit_simulated.cpp
  LINKS predict cell flow rheology numerics)

add_executable(bench_exit_passage bench/exit_passage.cpp)
target_link_libraries(bench_exit_passage PRIVATE bioprint_predict bioprint_options)
