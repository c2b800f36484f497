# The scenes in three dimensions.
target_sources(bioprint_simulate PRIVATE
  decay.cpp
  ellipsoid_axes.cpp
  exit_start.cpp
  immersed_body.cpp
  offset_channel_scene.cpp
  offset_exit_scene.cpp
  offset_view.cpp
  shear_scene.cpp
  space.cpp
  space_errors.cpp
  space_limits.cpp
  space_pictures.cpp)
