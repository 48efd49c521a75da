# jw_together(TARGET NAME SOURCE ...): compiles sources of the target into one object. The compiler reads their headers
# once, and a build after an edit still takes seconds. A source that is in no such list is an object of its own.
function(jw_together target name)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${name})
  target_sources(${target} PRIVATE ${ARGN})
endfunction()
