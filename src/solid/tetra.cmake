# Tetrahedra, and the meshes of data/meshes as part of the library; a change there builds it anew.
set(BIOPRINT_MESH_CASES "")
file(GLOB meshes ${PROJECT_SOURCE_DIR}/data/meshes/*.tet)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/data/meshes)
foreach(mesh ${meshes})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${mesh})
  get_filename_component(mesh_name ${mesh} NAME_WE)
  file(READ ${mesh} mesh_text)
  string(APPEND BIOPRINT_MESH_CASES
    "    if (name == \"${mesh_name}\") {\n        return R\"mesh(${mesh_text})mesh\";\n    }\n")
endforeach()
configure_file(tetra_mesh_texts.cpp.in tetra_mesh_texts.cpp @ONLY)
target_sources(bioprint_solid PRIVATE
  tetra_mesh.cpp
  tetra_points.cpp
  tetra_solid.cpp
  tetra_volume.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/tetra_mesh_texts.cpp)
target_link_libraries(bioprint_solid PRIVATE $<BUILD_INTERFACE:Eigen3::Eigen>)
