# jw_warnings: compiler options of every target of the project.
add_library(jw_warnings INTERFACE)
target_compile_options(jw_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports overlaps in `"text" + string` that do not exist (GCC bug 105651)
  target_compile_options(jw_warnings INTERFACE -Wno-restrict)
else()
  # clang warns of sign conversions and missing braces; GCC does not
  target_compile_options(jw_warnings INTERFACE -Wno-sign-conversion -Wno-missing-braces)
endif()
if(JW_WERROR)
  target_compile_options(jw_warnings INTERFACE -Werror)
endif()
if(JW_SANITIZE)
  # GCC 12 takes Eigen's small storages for uninitialised once the sanitizers split their loads. Faults that the address
  # sanitizer also finds are left to it: checks of every pointer double the time to compile.
  target_compile_options(jw_warnings INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                                               -fno-sanitize=null,alignment,object-size,vptr
                                               -fno-omit-frame-pointer
                                               $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(jw_warnings INTERFACE -fsanitize=address,undefined)
endif()
if(JW_LIBFUZZER)
  # the conversion of a number that is too large for an int is undefined behaviour, too, but not part of `undefined`
  target_compile_options(jw_warnings INTERFACE -fsanitize=fuzzer-no-link,float-cast-overflow)
endif()
if(JW_SANITIZE_THREADS)
  # because of the sanitizer's changes to the code, GCC 12 reports uninitialised values in Eigen and std::optional
  target_compile_options(jw_warnings INTERFACE -fsanitize=thread -Wno-maybe-uninitialized -Wno-tsan)
  target_link_options(jw_warnings INTERFACE -fsanitize=thread)
endif()
