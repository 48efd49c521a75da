#pragma once

namespace jw {

/// A piece of one line of a lesson file. Line and column count from 1, the column in characters (code
/// points); line 0: the file as a whole.
struct SourceSpan {
    int line = 0;
    int column = 0;
    int length = 0;  ///< characters, at least 1 where there is a line

    bool operator==(const SourceSpan&) const = default;
};

}  // namespace jw
