# The map of the house, read from the sources themselves.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
add_test(NAME structure COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/structure/layers.py ${PROJECT_SOURCE_DIR})
add_test(NAME structure-finds-breaches
         COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/structure/layers.py --self-test)
set_tests_properties(structure structure-finds-breaches PROPERTIES LABELS unsanitized)
