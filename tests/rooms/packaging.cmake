# The tools and what is installed, used as a user would.
add_test(NAME install-packages COMMAND ${PROJECT_SOURCE_DIR}/tests/packaging/install_packages.sh)
set_tests_properties(install-packages PROPERTIES LABELS unsanitized)

add_test(NAME predict-script COMMAND ${PROJECT_SOURCE_DIR}/tests/packaging/predict_script.sh)
set_tests_properties(predict-script PROPERTIES LABELS slow TIMEOUT 300)

if(TARGET bioprint-predict AND TARGET bioprint_c)
  add_test(NAME installed
           COMMAND ${PROJECT_SOURCE_DIR}/tests/packaging/installed.sh ${PROJECT_BINARY_DIR} ${PROJECT_BINARY_DIR}/installed)
  set_tests_properties(installed PROPERTIES LABELS slow TIMEOUT 300)
endif()
