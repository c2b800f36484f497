bioprint_program_tests(cli_long_runs SOURCES cli/long_runs.cpp)

# With the system's own Python, which has python3-meshio.
find_program(BIOPRINT_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
add_test(NAME paraview COMMAND ${BIOPRINT_SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/paraview/paraview.py
  $<TARGET_FILE:bioprint-predict>)
set_tests_properties(paraview PROPERTIES LABELS "slow")

# A full disk, no place to write, two runs at once.
add_test(NAME faults COMMAND ${BIOPRINT_SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/faults/faults.py
  $<TARGET_FILE:bioprint-predict>)
set_tests_properties(faults PROPERTIES LABELS "slow")

# Killed at random moments and taken up again: a few times here, 200 times by hand.
add_test(NAME kills COMMAND ${BIOPRINT_SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/faults/kills.py $<TARGET_FILE:bioprint-predict> --repeats 6)
set_tests_properties(kills PROPERTIES LABELS "slow")
add_test(NAME kills_campaign
  COMMAND ${BIOPRINT_SYSTEM_PYTHON} ${PROJECT_SOURCE_DIR}/tests/faults/kills.py $<TARGET_FILE:bioprint-predict> --repeats 200)
set_tests_properties(kills_campaign PROPERTIES LABELS "campaign")
