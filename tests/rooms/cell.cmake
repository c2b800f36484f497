bioprint_tests(cell
  SOURCES verify/shape_integrals.cpp verify/shear_curve.cpp verify/roscoe.cpp verify/bullet.cpp verify/transient.cpp
    verify/thinning_response.cpp verify/axis_passage.cpp unit/cell/roscoe.cpp unit/numerics/ode.cpp
  LINKS cell numerics
  PRIVATE GSL::gsl GSL::gslcblas)

# Times per call; not a test, run it on a quiet machine.
add_executable(bench_cell bench/cell.cpp)
target_include_directories(bench_cell PRIVATE ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(bench_cell PRIVATE bioprint_cell bioprint_options)
