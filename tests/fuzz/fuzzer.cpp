// A target for libFuzzer, which provides main and looks for inputs that reach new code. JW_FUZZ_TARGET is the
// name of the target.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "tests/fuzz/targets.hpp"
#include "tests/fuzz/words.hpp"
#include "tests/support/mutated_text.hpp"

// names and types are those of libFuzzer
extern "C" {
size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t max_size);
int LLVMFuzzerInitialize(int* argc, char*** argv);
int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed);
}

namespace {

const jw::fuzz::Target* target = nullptr;
std::vector<std::string> words;

}  // namespace

int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    const char* const name = std::getenv("JW_FUZZ_TARGET");
    target = &jw::fuzz::target_called(name == nullptr ? "" : name);
    words = jw::fuzz::read_words(std::string(JW_FUZZ) + "/words/" + target->name + ".dict");
    // objects that a target makes once for all inputs are made here, where no time limit runs
    for (const jw::fuzz::Kept& kept :
         jw::fuzz::kept_inputs(std::string(JW_FUZZ) + "/corpus/" + target->name)) {
        LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(kept.text.data()), kept.text.size());
    }
    return 0;
}

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    try {
        target->check({reinterpret_cast<const char*>(data), size});
    } catch (const jw::fuzz::Broken& broken) {
        std::fprintf(stderr, "broken promise: %s\n", broken.what());
        std::abort();
    }
    return 0;
}

/// Mutates by whole words half of the time: keys and values that have a meaning get past the parser.
size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t max_size, unsigned seed) {
    std::mt19937 random(seed);
    if (size == 0 || seed % 2 == 0) { return LLVMFuzzerMutate(data, size, max_size); }
    const std::string text = jw::test::mutated({reinterpret_cast<const char*>(data), size}, random, words);
    const size_t kept = std::min(text.size(), max_size);
    std::memcpy(data, text.data(), kept);
    return kept;
}
