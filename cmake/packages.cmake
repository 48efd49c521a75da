# Debian's packages as targets; cmake/packages.txt lists their names in Debian.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
include(eigen)
target_compile_definitions(Eigen3::Eigen INTERFACE ${JW_EIGEN_DEFINITIONS})

pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)

find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt 9 REQUIRED)
pkg_check_modules(glfw3 REQUIRED IMPORTED_TARGET glfw3)
pkg_check_modules(osmesa REQUIRED IMPORTED_TARGET osmesa)
pkg_check_modules(libdeflate REQUIRED IMPORTED_TARGET libdeflate)
find_package(GIF 5.1 REQUIRED)
pkg_check_modules(libmd REQUIRED IMPORTED_TARGET libmd)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo cairo-ft cairo-svg cairo-pdf)
pkg_check_modules(freetype2 REQUIRED IMPORTED_TARGET freetype2)

# libimgui.a is static: it needs stb and freetype after it on the link line
pkg_check_modules(imgui REQUIRED imgui)
find_library(IMGUI_LIBRARY imgui REQUIRED)
add_library(ImGui::ImGui INTERFACE IMPORTED)
target_include_directories(ImGui::ImGui SYSTEM INTERFACE ${imgui_INCLUDE_DIRS})
target_link_libraries(ImGui::ImGui INTERFACE ${IMGUI_LIBRARY} PkgConfig::stb PkgConfig::freetype2
                                             ${CMAKE_DL_LIBS})

find_package(Catch2 2.13 REQUIRED)

# the package's own targets require those of other test frameworks, which may not be installed
find_library(RAPIDCHECK_LIBRARY rapidcheck REQUIRED)
add_library(RapidCheck::RapidCheck UNKNOWN IMPORTED)
set_target_properties(RapidCheck::RapidCheck PROPERTIES IMPORTED_LOCATION ${RAPIDCHECK_LIBRARY})
# tests only: what the program computes does not depend on which LAPACK a machine has
pkg_check_modules(lapacke REQUIRED IMPORTED_TARGET lapacke)

# the Python of the system, even if another one is first in PATH: its headers, pybind11 and numpy are Debian's
if(NOT JW_SANITIZE)
  find_program(JW_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH REQUIRED)
  set(Python_EXECUTABLE ${JW_PYTHON})
  find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 REQUIRED CONFIG)
endif()
