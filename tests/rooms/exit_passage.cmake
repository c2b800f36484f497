bioprint_tests(exit_passage
  SOURCES validate/exit_passage.cpp
  LINKS predict cell flow rheology numerics)
