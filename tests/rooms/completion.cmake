if(TARGET bioprint-predict)
  add_test(NAME completion
           COMMAND ${PROJECT_SOURCE_DIR}/tests/completion/completion.sh $<TARGET_FILE:bioprint-predict>)
  set_tests_properties(completion PROPERTIES LABELS unsanitized)
endif()
