bioprint_tests(predict
  SOURCES unit/predict/laws.cpp unit/predict/predict.cpp unit/predict/exit_kind.cpp
          unit/predict/stated_errors.cpp
  LINKS predict)

# 1e5 random calls; RC_PARAMS sets the number, a failing case prints its own reproduction.
find_library(RAPIDCHECK_LIBRARY rapidcheck REQUIRED)
bioprint_tests(random_calls
  SOURCES verify/random_calls.cpp
  LINKS predict
  LABELS slow
  PRIVATE ${RAPIDCHECK_LIBRARY})
set_tests_properties(random_calls PROPERTIES ENVIRONMENT "RC_PARAMS=max_success=100000 max_size=1000 seed=1")
bioprint_bench(predict SOURCES bench/predict.cpp LINKS predict)
