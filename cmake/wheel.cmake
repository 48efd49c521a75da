# Contents of a wheel, as component python: the package jointwise. ./dev wheel packs it (app/python/wheel.sh).
set(JW_WHEEL_LIBRARIES libs)
set_target_properties(jw_python PROPERTIES INSTALL_RPATH "$ORIGIN/${JW_WHEEL_LIBRARIES}")
install(TARGETS jw_python LIBRARY DESTINATION jointwise COMPONENT python EXCLUDE_FROM_ALL)
install(FILES app/python/jointwise/__init__.py app/python/jointwise/__init__.pyi app/python/jointwise/py.typed
  DESTINATION jointwise COMPONENT python EXCLUDE_FROM_ALL)
install(DIRECTORY ${JW_DATA_FOLDERS}
  DESTINATION jointwise/${JW_INSTALL_DATA}/lessons COMPONENT python EXCLUDE_FROM_ALL)
install(FILES cmake/debian/copyright DESTINATION jointwise/share/doc/jointwise COMPONENT python EXCLUDE_FROM_ALL)
jw_install_copyrights(jointwise/share/doc/jointwise/third-party python
  nlohmann-json3-dev libeigen3-dev pybind11-dev ${JW_BUNDLED_PACKAGES})
jw_install_bundled(MODULES jw_python jointwise/${JW_WHEEL_LIBRARIES} python)
