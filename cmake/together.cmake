# jw_together(TARGET NAME SOURCE ...): sources of the target that are one object. The compiler reads what they include once,
# and an edit of one of them still takes seconds. What stands in no such list is an object of its own.
function(jw_together target name)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${name})
  target_sources(${target} PRIVATE ${ARGN})
endfunction()
