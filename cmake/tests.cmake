include(Catch)

# jw_add_tests(name SOURCES a.cpp ... LIBS target ...): a test program whose every test case is known to ctest.
function(jw_add_tests name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE JW_SOURCE_ROOT="${PROJECT_SOURCE_DIR}")
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # each runs once: compiling is what takes time
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} jw_test_main jw_warnings)
  # a name that Catch reads as another filter would run nothing, and pass
  catch_discover_tests(${name}
    TEST_PREFIX "${name}: "
    EXTRA_ARGS --warn NoTests
    PROPERTIES TIMEOUT 1500)
endfunction()
