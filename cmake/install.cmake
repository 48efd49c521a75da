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
