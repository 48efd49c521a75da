#pragma once

/// Everything that a function calls is compiled into it: jets of a few numbers cost more to hand over than to
/// compute. Not with sanitizers, where that takes minutes and gigabytes to compile.
#if defined(__SANITIZE_ADDRESS__)
#define JW_FLATTEN
#else
#define JW_FLATTEN [[gnu::flatten]]
#endif
