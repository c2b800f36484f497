# What `cmake --install` puts where: the program, its manual page, completion and data; the C++ libraries with their headers
# and a package for find_package(bioprint-predict); the C library with a pkg-config file.

include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/bioprint-predict)

if(TARGET bioprint-predict)
  install(TARGETS bioprint-predict)
endif()
install(FILES man/bioprint-predict.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES completion/bioprint-predict.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME bioprint-predict)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY data/ DESTINATION ${CMAKE_INSTALL_DATADIR}/bioprint-predict)
install(DIRECTORY include/bioprint DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

# Every room but the command itself is a library; bioprint::bioprint is all of them.
get_property(rooms GLOBAL PROPERTY BIOPRINT_ROOMS)
list(REMOVE_ITEM rooms cli)
list(TRANSFORM rooms PREPEND bioprint_ OUTPUT_VARIABLE libraries)
add_library(bioprint_all INTERFACE)
add_library(bioprint::bioprint ALIAS bioprint_all)
set_target_properties(bioprint_all PROPERTIES EXPORT_NAME bioprint)
target_link_libraries(bioprint_all INTERFACE ${libraries})
install(TARGETS bioprint_all ${libraries} EXPORT bioprint-predict-targets)
if(TARGET bioprint_c)
  install(TARGETS bioprint_c EXPORT bioprint-predict-targets)
  file(RELATIVE_PATH pc_to_include ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
  configure_file(cmake/bioprint.pc.in ${PROJECT_BINARY_DIR}/bioprint.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/bioprint.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
install(EXPORT bioprint-predict-targets NAMESPACE bioprint:: DESTINATION ${package_dir})

get_property(packages GLOBAL PROPERTY BIOPRINT_LINKED_PACKAGES)
list(REMOVE_DUPLICATES packages)
list(TRANSFORM packages REPLACE "(.+)" "find_dependency(\\1)" OUTPUT_VARIABLE dependencies)
list(JOIN dependencies "\n" BIOPRINT_DEPENDENCIES)
configure_package_config_file(cmake/bioprint-predict-config.cmake.in
  ${PROJECT_BINARY_DIR}/bioprint-predict-config.cmake INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/bioprint-predict-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/bioprint-predict-config.cmake
              ${PROJECT_BINARY_DIR}/bioprint-predict-config-version.cmake
        DESTINATION ${package_dir})
