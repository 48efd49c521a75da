#include "tests/support/allocation_counter.hpp"

#include <cstddef>
#include <new>

// `-Wl,--wrap=f` turns every reference to f into __wrap_f, and __real_f into f
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* old, std::size_t size);
void* __real__Znwm(std::size_t size);
void* __real__Znam(std::size_t size);
void* __real__ZnwmSt11align_val_t(std::size_t size, std::align_val_t alignment);
}

namespace {

long count = 0;

}  // namespace

namespace jw::test {

long allocations() { return count; }

}  // namespace jw::test

extern "C" {

void* __wrap_malloc(std::size_t size) {
    ++count;
    return __real_malloc(size);
}

void* __wrap_calloc(std::size_t number, std::size_t size) {
    ++count;
    return __real_calloc(number, size);
}

void* __wrap_realloc(void* old, std::size_t size) {
    ++count;
    return __real_realloc(old, size);
}

void* __wrap__Znwm(std::size_t size) {
    ++count;
    return __real__Znwm(size);
}

void* __wrap__Znam(std::size_t size) {
    ++count;
    return __real__Znam(size);
}

void* __wrap__ZnwmSt11align_val_t(std::size_t size, std::align_val_t alignment) {
    ++count;
    return __real__ZnwmSt11align_val_t(size, alignment);
}
}
