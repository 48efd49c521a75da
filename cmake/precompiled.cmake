# Headers that most sources of a target read (cmake/precompiled/) are compiled once for all targets with the same flags.
# Without them, objects are the same byte for byte: cmake -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON, as ./dev tidy does.

# jw_precompile(TARGET NAME): compiles the headers of NAME with the flags of TARGET
function(jw_precompile target name)
  target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled/${name}.hpp)
endfunction()

# jw_precompiled_by(OTHER TARGET ...): the targets use the headers that were compiled for OTHER
function(jw_precompiled_by other)
  foreach(target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM ${other})
  endforeach()
endfunction()
