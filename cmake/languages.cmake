# jw_add_language(target tag): compiles app/languages/TAG.po into bytes that `target` includes as
# "app/languages/TAG.hpp". A mistake in the file stops the build.
find_program(MSGFMT msgfmt REQUIRED)

function(jw_add_language target tag)
  set(po ${PROJECT_SOURCE_DIR}/app/languages/${tag}.po)
  set(folder ${PROJECT_BINARY_DIR}/app/languages)
  file(MAKE_DIRECTORY ${folder})
  add_custom_command(
    OUTPUT ${folder}/${tag}.hpp
    COMMAND ${MSGFMT} --check-format --check-domain --endianness=little -o ${folder}/${tag}.mo ${po}
    COMMAND ${CMAKE_COMMAND} -DTAG=${tag} -DFOLDER=${folder} -P ${PROJECT_SOURCE_DIR}/cmake/write_language.cmake
    DEPENDS ${po} ${PROJECT_SOURCE_DIR}/cmake/write_language.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${folder}/${tag}.hpp)
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR})
endfunction()
