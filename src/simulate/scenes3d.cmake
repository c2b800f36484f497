# The scenes in three dimensions.
target_sources(bioprint_simulate PRIVATE
  immersed_body.cpp
  shear_scene.cpp)
