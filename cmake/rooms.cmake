# A room of the house: one static library that links only what stands below it.
#
#   bioprint_room(flow SOURCES nozzle_flow.cpp nozzle_exit.cpp LINKS rheology numerics [PRIVATE GSL::gsl])
#
# LINKS names rooms, PRIVATE other targets that no header of the room shows.

add_library(bioprint_options INTERFACE)
target_compile_options(bioprint_options INTERFACE -Wall -Wextra -Wpedantic -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC bug 105651: false alarms of -Wrestrict in std::string's operator+.
  target_compile_options(bioprint_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-restrict>)
endif()
# Optimisations that keep IEEE values: no errno from libm, no floating-point traps, loops marked `omp simd`.
target_compile_options(bioprint_options INTERFACE -fno-math-errno -fno-trapping-math -fopenmp-simd)
if(BIOPRINT_SANITIZE)
  # A target with the property BIOPRINT_UNSANITIZED holds none of our code that could be wrong.
  target_compile_options(bioprint_options INTERFACE
    "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:BIOPRINT_UNSANITIZED>>>:-fsanitize=address,undefined;-fno-sanitize-recover=all>"
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
  target_link_libraries(bioprint_${name} PRIVATE $<BUILD_INTERFACE:bioprint_options>)
  foreach(target ${ROOM_PRIVATE})
    if(target MATCHES "^(Eigen3|nlohmann_json|CLI11)::")
      # Headers alone, and in no header of ours: who uses the installed library need not have them.
      target_link_libraries(bioprint_${name} PRIVATE $<BUILD_INTERFACE:${target}>)
    else()
      target_link_libraries(bioprint_${name} PRIVATE ${target})
      string(REGEX REPLACE "::.*" "" package ${target})
      set_property(GLOBAL APPEND PROPERTY BIOPRINT_LINKED_PACKAGES ${package})
    endif()
  endforeach()
  set_property(GLOBAL APPEND PROPERTY BIOPRINT_ROOMS ${name})
endfunction()
