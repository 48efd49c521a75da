#pragma once

/// Counts calls of malloc, calloc, realloc and operator new made by the program's own objects (the libraries
/// of this project and Eigen's inline code): the linker sends them here, see allocation_counter.cpp.
namespace jw::test {

long allocations();

}  // namespace jw::test
