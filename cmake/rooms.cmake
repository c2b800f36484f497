# A room of the house: one static library that links only what stands below it.
#
#   bioprint_room(flow SOURCES nozzle_flow.cpp nozzle_exit.cpp LINKS rheology numerics [PRIVATE GSL::gsl])
#
# LINKS names rooms, PRIVATE other targets that no header of the room shows.

add_library(bioprint_options INTERFACE)
target_compile_options(bioprint_options INTERFACE -Wall -Wextra -Wpedantic -Werror)
# Optimisations that keep IEEE values: no errno from libm, no floating-point traps, loops marked `omp simd`.
target_compile_options(bioprint_options INTERFACE -fno-math-errno -fno-trapping-math -fopenmp-simd)
if(BIOPRINT_SANITIZE)
  target_compile_options(bioprint_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer)
  target_link_options(bioprint_options INTERFACE -fsanitize=address,undefined)
endif()

function(bioprint_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;LINKS;PRIVATE" ${ARGN})
  add_library(bioprint_${name} STATIC ${ROOM_SOURCES})
  add_library(bioprint::${name} ALIAS bioprint_${name})
  set_target_properties(bioprint_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(bioprint_${name} PUBLIC cxx_std_20)
  target_include_directories(bioprint_${name}
    PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    PRIVATE ${PROJECT_SOURCE_DIR}/src)
  foreach(room ${ROOM_LINKS})
    target_link_libraries(bioprint_${name} PUBLIC bioprint_${room})
  endforeach()
  target_link_libraries(bioprint_${name} PRIVATE $<BUILD_INTERFACE:bioprint_options> ${ROOM_PRIVATE})
  set_property(GLOBAL APPEND PROPERTY BIOPRINT_ROOMS ${name})
endfunction()
