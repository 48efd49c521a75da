# Files of `cmake --install`, below any prefix: no installed file depends on the path of prefix, sources or build.
# Component jointwise is the program; component jointwise-dev is the library for other programs.
include(GNUInstallDirs)

# lessons/files/catalogue.cpp looks for ../share/jointwise from the folder of the program
set(JW_INSTALL_DATA share/jointwise)

# libraries of the tarball; Debian's packages do not have this folder, and use the libraries of the system
set(JW_INSTALL_BUNDLED lib/jointwise)
set_target_properties(jointwise PROPERTIES INSTALL_RPATH "$ORIGIN/../${JW_INSTALL_BUNDLED}")
# jw_install_bundled(EXECUTABLES|MODULES target folder component): installs the ones that the target needs
function(jw_install_bundled kind target folder component)
  install(CODE "
    file(GET_RUNTIME_DEPENDENCIES ${kind} $<TARGET_FILE:${target}> RESOLVED_DEPENDENCIES_VAR found
      PRE_INCLUDE_REGEXES \"^lib(fmt|tomlplusplus|stb|deflate|gif)\\\\.\" PRE_EXCLUDE_REGEXES \".*\")
    file(INSTALL \${found} DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${folder}\" FOLLOW_SYMLINK_CHAIN)"
    COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
jw_install_bundled(EXECUTABLES jointwise ${JW_INSTALL_BUNDLED} bundled)

install(TARGETS jointwise RUNTIME DESTINATION bin COMPONENT jointwise)
set(JW_DATA_FOLDERS lessons/catalogue lessons/exercises lessons/benchmark lessons/reference)
install(DIRECTORY ${JW_DATA_FOLDERS}
  DESTINATION ${JW_INSTALL_DATA}/lessons COMPONENT jointwise)
install(FILES docs/lesson.schema.json DESTINATION ${JW_INSTALL_DATA} COMPONENT jointwise)

# manual and completions, generated from the program's help
set(help ${PROJECT_BINARY_DIR}/share/help)
file(MAKE_DIRECTORY ${help})
add_custom_command(
  OUTPUT ${help}/jointwise.1.gz ${help}/jointwise.bash ${help}/jointwise.zsh ${help}/jointwise.fish
  COMMAND jointwise manual > ${help}/jointwise.1
  COMMAND gzip -9nkf ${help}/jointwise.1
  COMMAND jointwise completion bash > ${help}/jointwise.bash
  COMMAND jointwise completion zsh > ${help}/jointwise.zsh
  COMMAND jointwise completion fish > ${help}/jointwise.fish
  DEPENDS jointwise
  VERBATIM)
add_custom_target(jw_help_files ALL DEPENDS ${help}/jointwise.1.gz)
install(FILES ${help}/jointwise.1.gz DESTINATION share/man/man1 COMPONENT jointwise)
install(FILES ${help}/jointwise.bash DESTINATION share/bash-completion/completions RENAME jointwise COMPONENT jointwise)
install(FILES ${help}/jointwise.zsh DESTINATION share/zsh/vendor-completions RENAME _jointwise COMPONENT jointwise)
install(FILES ${help}/jointwise.fish DESTINATION share/fish/vendor_completions.d COMPONENT jointwise)

# changelog and copyright of Debian's packages, and the copyrights of libraries that are linked in
execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/cmake/debian/changelog
  OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
foreach(component jointwise jointwise-dev)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz cmake/debian/copyright
    DESTINATION share/doc/${component} COMPONENT ${component})
endforeach()
# jw_install_copyrights(folder component package...)
function(jw_install_copyrights folder component)
  foreach(package IN LISTS ARGN)
    install(FILES /usr/share/doc/${package}/copyright DESTINATION ${folder}
      RENAME ${package} COMPONENT ${component} OPTIONAL ${JW_NOT_BY_DEFAULT})
  endforeach()
endfunction()
set(JW_BUNDLED_PACKAGES libfmt-dev libtomlplusplus-dev libstb-dev libdeflate-dev libgif-dev)
jw_install_copyrights(share/doc/jointwise/third-party jointwise
  libimgui-dev libcli11-dev nlohmann-json3-dev libstb-dev libeigen3-dev)
set(JW_NOT_BY_DEFAULT EXCLUDE_FROM_ALL)
jw_install_copyrights(share/doc/jointwise/third-party bundled ${JW_BUNDLED_PACKAGES})

install(FILES README.md DESTINATION share/doc/jointwise COMPONENT jointwise)
install(DIRECTORY docs DESTINATION share/doc/jointwise COMPONENT jointwise
  PATTERN "lesson.schema.json" EXCLUDE)

include(CMakePackageConfigHelpers)
set(JW_INSTALL_CMAKE lib/cmake/jointwise)
set(JW_LIBRARIES jointwise_core jointwise_lessons jointwise_render jointwise_film)
# targets that have to be built before anything is installed
add_custom_target(jw_installed DEPENDS jw_help_files jointwise ${JW_LIBRARIES})
install(TARGETS ${JW_LIBRARIES} EXPORT jointwise-targets
  ARCHIVE DESTINATION lib COMPONENT jointwise-dev)
install(EXPORT jointwise-targets NAMESPACE jointwise:: DESTINATION ${JW_INSTALL_CMAKE} COMPONENT jointwise-dev)
install(DIRECTORY library/jointwise ${PROJECT_BINARY_DIR}/include/jointwise DESTINATION include
  COMPONENT jointwise-dev FILES_MATCHING PATTERN "*.hpp")
configure_package_config_file(cmake/jointwise-config.cmake.in ${PROJECT_BINARY_DIR}/jointwise-config.cmake
  INSTALL_DESTINATION ${JW_INSTALL_CMAKE} PATH_VARS JW_INSTALL_DATA)
# docs/formats.md: what compiles with a version compiles with all later ones of the same major version
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jointwise-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jointwise-config.cmake ${PROJECT_BINARY_DIR}/jointwise-config-version.cmake
  DESTINATION ${JW_INSTALL_CMAKE} COMPONENT jointwise-dev)
