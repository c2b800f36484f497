# Every example of README and manual, run as printed. After a change of the output on purpose:
#   cmake --build build/release --target update-examples
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
set(examples ${PROJECT_SOURCE_DIR}/tests/docs/examples.py)
set(documents ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/man/bioprint-predict.1)

add_test(NAME examples-notice COMMAND Python3::Interpreter ${examples} --self-test)
set_tests_properties(examples-notice PROPERTIES LABELS unsanitized)

if(TARGET bioprint-predict)
  set(place --bin $<TARGET_FILE_DIR:bioprint-predict> --files ${PROJECT_SOURCE_DIR}/data/examples)
  add_test(NAME examples COMMAND Python3::Interpreter ${examples} ${place} ${documents})
  set_tests_properties(examples PROPERTIES LABELS unsanitized)
  add_custom_target(update-examples
    COMMAND Python3::Interpreter ${examples} --update ${place} ${documents} DEPENDS bioprint-predict VERBATIM)
endif()
