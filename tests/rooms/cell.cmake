bioprint_tests(cell
  SOURCES verify/shape_integrals.cpp verify/shear_curve.cpp verify/roscoe.cpp verify/bullet.cpp unit/cell/roscoe.cpp
  LINKS cell numerics
  PRIVATE GSL::gsl GSL::gslcblas)

# Times per call.
bioprint_bench(cell SOURCES bench/cell.cpp LINKS cell)
