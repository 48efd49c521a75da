# jw_warnings: what every target of the project is compiled with.
add_library(jw_warnings INTERFACE)
target_compile_options(jw_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps in `"text" + string` that are not there (GCC bug 105651)
  target_compile_options(jw_warnings INTERFACE -Wno-restrict)
else()
  # clang warns of conversions of signs and of braces left out, GCC does not
  target_compile_options(jw_warnings INTERFACE -Wno-sign-conversion -Wno-missing-braces)
endif()
if(JW_WERROR)
  target_compile_options(jw_warnings INTERFACE -Werror)
endif()
if(JW_SANITIZE)
  # GCC 12 takes Eigen's small storages for uninitialised once the sanitizers split their loads. What the address
  # sanitizer sees as well is left to it: checks of every pointer double the time to compile.
  target_compile_options(jw_warnings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                               -fno-sanitize=null,alignment,object-size,vptr
                                               -fno-omit-frame-pointer
                                               $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(jw_warnings INTERFACE -fsanitize=address,undefined)
endif()
if(JW_LIBFUZZER)
  # a number too large for an int is undefined behaviour, too, and no part of `undefined`
  target_compile_options(jw_warnings INTERFACE -fsanitize=fuzzer-no-link,float-cast-overflow)
endif()
if(JW_SANITIZE_THREADS)
  # what the sanitizer changes in the code makes GCC 12 see uninitialised values in Eigen and std::optional
  target_compile_options(jw_warnings INTERFACE -fsanitize=thread -Wno-maybe-uninitialized -Wno-tsan)
  target_link_options(jw_warnings INTERFACE -fsanitize=thread)
endif()
