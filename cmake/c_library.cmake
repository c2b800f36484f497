# libbioprint.so: the predictor behind three C functions (include/bioprint/bioprint.h), for spreadsheets and other languages.
# All else it contains stays hidden, so that it cannot clash with what the program that loads it brings along.

if(EXISTS ${PROJECT_SOURCE_DIR}/include/bioprint/io/answer.hpp)
  add_library(bioprint_c SHARED ${PROJECT_SOURCE_DIR}/src/io/c_api.cpp)
  add_library(bioprint::c ALIAS bioprint_c)
  set(symbols ${PROJECT_SOURCE_DIR}/cmake/c_library.map)
  set_target_properties(bioprint_c PROPERTIES
    OUTPUT_NAME bioprint EXPORT_NAME c VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    LINK_DEPENDS ${symbols})
  target_compile_features(bioprint_c PRIVATE cxx_std_20)
  target_compile_definitions(bioprint_c PRIVATE BIOPRINT_VERSION="${PROJECT_VERSION}")
  target_include_directories(bioprint_c
    INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_link_libraries(bioprint_c
    PRIVATE $<BUILD_INTERFACE:bioprint_io> $<BUILD_INTERFACE:bioprint_options> $<BUILD_INTERFACE:nlohmann_json::nlohmann_json>)
  target_link_options(bioprint_c PRIVATE -Wl,--version-script=${symbols})
  if(NOT BIOPRINT_SANITIZE)
    target_link_options(bioprint_c PRIVATE -Wl,--no-undefined)
  endif()
endif()
