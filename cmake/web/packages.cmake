# The packages of cmake/packages.cmake for WebAssembly, under the same names: Debian's headers for header-only packages,
# and sources in the toolchain's folder (toolchain.sh) for libraries that must be compiled.
enable_language(C)

# Native exceptions of WebAssembly. Numbers are as everywhere: there is no fused multiply-add.
add_compile_options(-fwasm-exceptions -ffp-contract=off -msimd128)
add_link_options(-fwasm-exceptions)
# libc++ 18 has std::stop_token and std::jthread only with this option
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fexperimental-library>)
add_link_options(-fexperimental-library)

set(JW_WEB_SOURCES "" CACHE PATH "Sources of imgui, freetype and libdeflate: what toolchain.sh has fetched")

# The system's headers as a whole are for another machine, so each package is linked into a folder of its own.
function(jw_header_package target name file)
  find_path(found_${target} ${file} PATHS /usr/include /usr/include/eigen3 /usr/include/stb NO_DEFAULT_PATH
            NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  set(folder ${PROJECT_BINARY_DIR}/headers/${name})
  file(MAKE_DIRECTORY ${folder})
  get_filename_component(top ${file} DIRECTORY)
  if(top STREQUAL "")
    set(top ${file})
  endif()
  file(CREATE_LINK ${found_${target}}/${top} ${folder}/${top} SYMBOLIC)
  add_library(${target} INTERFACE IMPORTED)
  target_include_directories(${target} SYSTEM INTERFACE ${folder})
endfunction()

jw_header_package(Eigen3::Eigen eigen Eigen/Core)
jw_header_package(PkgConfig::tomlplusplus tomlplusplus toml++/toml.h)
jw_header_package(nlohmann_json::nlohmann_json nlohmann nlohmann/json.hpp)
jw_header_package(fmt::fmt fmt fmt/format.h)
jw_header_package(jw_stb stb stb_image_write.h)
jw_header_package(jw_stb_reader stb stb_image.h)
jw_header_package(jw_gl_types gl GL/glcorearb.h)
jw_header_package(jw_gl_platform khr KHR/khrplatform.h)
target_compile_definitions(fmt::fmt INTERFACE FMT_HEADER_ONLY)
# Eigen has x86 assembler for GCC before 6.3 (10 * 5 + 13 is not less than 63), for GCC from 6.0 on, and for a barrier
# that is needed only with -ffast-math
target_compile_options(Eigen3::Eigen INTERFACE -msse2 -fgnuc-version=5.13 "-DEIGEN_OPTIMIZATION_BARRIER(X)=")
target_include_directories(Eigen3::Eigen SYSTEM INTERFACE ${PROJECT_SOURCE_DIR}/cmake/web/headers)
include(eigen)
target_compile_definitions(Eigen3::Eigen INTERFACE ${JW_EIGEN_DEFINITIONS} ${JW_EIGEN_WEB_DEFINITIONS})
target_link_libraries(jw_gl_types INTERFACE jw_gl_platform)
set(stb_INCLUDE_DIRS ${PROJECT_BINARY_DIR}/headers/stb)
add_library(Threads::Threads INTERFACE IMPORTED)

file(GLOB deflate ${JW_WEB_SOURCES}/libdeflate/lib/*.c ${JW_WEB_SOURCES}/libdeflate/lib/*/*.c)
add_library(web_libdeflate STATIC ${deflate})
target_include_directories(web_libdeflate SYSTEM PUBLIC ${JW_WEB_SOURCES}/libdeflate)
add_library(PkgConfig::libdeflate ALIAS web_libdeflate)

# only the formats of the program's fonts, without compressed and bitmap fonts
set(freetype ${JW_WEB_SOURCES}/freetype)
add_library(web_freetype STATIC
  ${freetype}/src/autofit/autofit.c ${freetype}/src/base/ftbase.c ${freetype}/src/base/ftbbox.c
  ${freetype}/src/base/ftbitmap.c ${freetype}/src/base/ftdebug.c ${freetype}/src/base/ftglyph.c
  ${freetype}/src/base/ftinit.c ${freetype}/src/base/ftmm.c ${freetype}/src/base/ftsynth.c
  ${freetype}/src/base/ftsystem.c ${freetype}/src/cff/cff.c ${freetype}/src/gzip/ftgzip.c ${freetype}/src/psaux/psaux.c
  ${freetype}/src/pshinter/pshinter.c ${freetype}/src/psnames/psnames.c ${freetype}/src/raster/raster.c
  ${freetype}/src/sfnt/sfnt.c ${freetype}/src/smooth/smooth.c ${freetype}/src/truetype/truetype.c)
target_include_directories(web_freetype SYSTEM PUBLIC ${freetype}/include)
target_compile_definitions(web_freetype PRIVATE FT2_BUILD_LIBRARY
  FT_CONFIG_MODULES_H="${PROJECT_SOURCE_DIR}/cmake/web/freetype_modules.h")
add_library(PkgConfig::freetype2 ALIAS web_freetype)

set(imgui ${JW_WEB_SOURCES}/imgui)
add_library(web_imgui STATIC ${imgui}/imgui.cpp ${imgui}/imgui_draw.cpp ${imgui}/imgui_tables.cpp
  ${imgui}/imgui_widgets.cpp ${imgui}/misc/cpp/imgui_stdlib.cpp)
target_include_directories(web_imgui SYSTEM PUBLIC ${imgui} ${imgui}/misc/cpp)
target_link_libraries(web_imgui PUBLIC jw_stb PkgConfig::freetype2)
add_library(ImGui::ImGui ALIAS web_imgui)
set_target_properties(web_libdeflate web_freetype web_imgui PROPERTIES UNITY_BUILD OFF EXPORT_COMPILE_COMMANDS OFF)
target_compile_options(web_libdeflate PRIVATE -w)
target_compile_options(web_freetype PRIVATE -w)
target_compile_options(web_imgui PRIVATE -w)
