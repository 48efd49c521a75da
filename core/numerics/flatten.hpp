#pragma once

/// Inlines everything that a function calls: passing jets of a few numbers costs more than computing them.
/// Disabled with sanitizers, because compiling would take minutes and gigabytes.
#if defined(__SANITIZE_ADDRESS__)
#define JW_FLATTEN
#else
#define JW_FLATTEN [[gnu::flatten]]
#endif
