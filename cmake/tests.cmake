include(Catch)

# jw_add_tests(name SOURCES a.cpp ... LIBS target ... [HEADERS target | PLAIN] [BY_ITSELF]): a test program; ctest knows
# each test case. HEADERS: target whose precompiled headers it uses, by default jw_test_headers; PLAIN: none, if other
# flags or few headers make them useless. BY_ITSELF: ctest does not know the program; ./dev has a command for it.
function(jw_add_tests name)
  cmake_parse_arguments(ARG "PLAIN;BY_ITSELF" "HEADERS" "SOURCES;LIBS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE JW_SOURCE_ROOT="${PROJECT_SOURCE_DIR}")
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)  # each runs once: compiling takes most of the time
  target_link_libraries(${name} PRIVATE ${ARG_LIBS} Catch2::Catch2WithMain jw_warnings)
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
  if(ARG_HEADERS)
    jw_precompiled_by(${ARG_HEADERS} ${name})
  elseif(NOT ARG_PLAIN)
    jw_precompiled_by(jw_test_headers ${name})
  endif()
  if(ARG_BY_ITSELF)
    return()
  endif()
  # NoTests: a name that Catch reads as another filter would run nothing, and pass
  catch_discover_tests(${name}
    TEST_PREFIX "${name}: "
    EXTRA_ARGS --warn NoTests
    PROPERTIES TIMEOUT 1500)
endfunction()
