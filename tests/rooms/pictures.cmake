# Pictures, reports, pieces of batches and workbooks, by the real program.
find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
if(TARGET bioprint-predict)
  foreach(subject pictures report shard workbook pipelines)
    add_test(NAME ${subject} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/cli/${subject}.py
                                     $<TARGET_FILE:bioprint-predict> ${PROJECT_SOURCE_DIR}/data/examples)
    # 77: a program the test needs is not installed here.
    set_tests_properties(${subject} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
  endforeach()
  set_tests_properties(pipelines PROPERTIES LABELS unsanitized)
  # By hand: programs of half a gigabyte.
  foreach(subject browser spreadsheet)
    add_test(NAME ${subject} COMMAND Python3::Interpreter ${PROJECT_SOURCE_DIR}/tests/cli/${subject}.py
                                     $<TARGET_FILE:bioprint-predict> ${PROJECT_SOURCE_DIR}/data/examples)
    set_tests_properties(${subject} PROPERTIES LABELS "campaign;unsanitized" SKIP_RETURN_CODE 77 TIMEOUT 600)
  endforeach()
  # Starts Slurm's daemons on this machine, as root.
  add_test(NAME slurm COMMAND ${PROJECT_SOURCE_DIR}/tests/campaign/slurm.sh $<TARGET_FILE:bioprint-predict>)
  set_tests_properties(slurm PROPERTIES LABELS "campaign;unsanitized" SKIP_RETURN_CODE 77 TIMEOUT 300 RUN_SERIAL ON)
endif()
