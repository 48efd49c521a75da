# Packages by CPack: cpack -G DEB for jointwise and jointwise-dev, cpack -G TGZ for a tree that can be put anywhere.
# ./dev package makes them all.
set(CPACK_PACKAGE_NAME jointwise)
set(CPACK_PACKAGE_VENDOR "Jointwise maintainers")
set(CPACK_PACKAGE_CONTACT "Jointwise maintainers <maintainers@example.org>")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_FILE_NAME jointwise-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/package_parts.cmake)

# first line: synopsis; other lines: description
set(CPACK_COMPONENT_JOINTWISE_DESCRIPTION "spatial kinematics of mechanisms, joint by joint
Assembles a mechanism of rigid bodies joint by joint and shows at every step
its constraint equations, the Jacobian and its rank, every iteration of
Newton's method, and which equations are redundant: in a window, as text, as
JSON, and as pictures drawn without a display.

Lessons, exercises and their documentation are included.")
set(CPACK_COMPONENT_JOINTWISE-DEV_DESCRIPTION "spatial kinematics of mechanisms - library
Headers and static libraries with which other programs read or build
mechanisms, assemble them, compute equations, rank and motion, and draw
pictures. For CMake: find_package(jointwise).")

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

set(CPACK_DEBIAN_JOINTWISE_PACKAGE_NAME jointwise)
set(CPACK_DEBIAN_JOINTWISE_PACKAGE_SECTION science)
set(CPACK_DEBIAN_JOINTWISE_PACKAGE_SHLIBDEPS ON)
# OSMesa is loaded when a picture is drawn; without these fonts nothing is drawn
set(CPACK_DEBIAN_JOINTWISE_PACKAGE_DEPENDS "libosmesa6, fonts-lmodern, fonts-dejavu-core")
set(CPACK_DEBIAN_JOINTWISE_PACKAGE_RECOMMENDS "ffmpeg, bubblewrap, fonts-droid-fallback, libgl1, libglx-mesa0, libegl1, libegl-mesa0")
set(CPACK_DEBIAN_JOINTWISE_PACKAGE_SUGGESTS "python3, g++")

set(CPACK_DEBIAN_JOINTWISE-DEV_PACKAGE_NAME jointwise-dev)
set(CPACK_DEBIAN_JOINTWISE-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_JOINTWISE-DEV_PACKAGE_DEPENDS
  "jointwise (= ${PROJECT_VERSION}), libeigen3-dev, libtomlplusplus-dev, libfmt-dev, libdeflate-dev, libgif-dev")
# a program that makes films links the libraries that draw their panels
set(CPACK_DEBIAN_JOINTWISE-DEV_PACKAGE_RECOMMENDS
  "cmake, libimgui-dev, libstb-dev, libfreetype-dev, libcairo2-dev, libmd-dev")
include(CPack)
