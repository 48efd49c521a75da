# What `cmake --install` puts where, below any prefix: nothing installed knows the prefix, the sources or the build.
# Component jointwise is the program, jointwise-dev what other programs are built with.
include(GNUInstallDirs)

# lessons/data_folder.cpp looks for ../share/jointwise from the folder of the program
set(JW_INSTALL_DATA share/jointwise)

install(TARGETS jointwise RUNTIME DESTINATION bin COMPONENT jointwise)
install(DIRECTORY lessons/catalogue lessons/exercises lessons/benchmark lessons/reference
  DESTINATION ${JW_INSTALL_DATA}/lessons COMPONENT jointwise)
install(FILES docs/lesson.schema.json DESTINATION ${JW_INSTALL_DATA} COMPONENT jointwise)
install(FILES README.md DESTINATION share/doc/jointwise COMPONENT jointwise)
install(DIRECTORY docs DESTINATION share/doc/jointwise COMPONENT jointwise
  PATTERN "lesson.schema.json" EXCLUDE)

include(CMakePackageConfigHelpers)
set(JW_INSTALL_CMAKE lib/cmake/jointwise)
install(TARGETS jointwise_core jointwise_lessons jointwise_render EXPORT jointwise-targets
  ARCHIVE DESTINATION lib COMPONENT jointwise-dev)
install(EXPORT jointwise-targets NAMESPACE jointwise:: DESTINATION ${JW_INSTALL_CMAKE} COMPONENT jointwise-dev)
install(DIRECTORY include/jointwise ${PROJECT_BINARY_DIR}/include/jointwise DESTINATION include
  COMPONENT jointwise-dev FILES_MATCHING PATTERN "*.hpp")
configure_package_config_file(cmake/jointwise-config.cmake.in ${PROJECT_BINARY_DIR}/jointwise-config.cmake
  INSTALL_DESTINATION ${JW_INSTALL_CMAKE} PATH_VARS JW_INSTALL_DATA)
# until version 1 another minor version is another interface
write_basic_package_version_file(${PROJECT_BINARY_DIR}/jointwise-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/jointwise-config.cmake ${PROJECT_BINARY_DIR}/jointwise-config-version.cmake
  DESTINATION ${JW_INSTALL_CMAKE} COMPONENT jointwise-dev)
