bioprint_tests(cell
  SOURCES verify/shape_integrals.cpp verify/shear_curve.cpp verify/roscoe.cpp verify/bullet.cpp verify/transient.cpp verify/planar_cell.cpp
    verify/thinning_response.cpp verify/axis_passage.cpp unit/cell/roscoe.cpp unit/numerics/ode.cpp
  LINKS cell numerics
  PRIVATE GSL::gsl GSL::gslcblas)

# Times per call.
bioprint_bench(cell SOURCES bench/cell.cpp LINKS cell)
