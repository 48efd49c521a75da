#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/diagnostics/read_text.hpp"

/// Collects the mistakes in a lesson.
namespace jw {

/// A value with the place where it stands.
template <class T>
struct Located {
    T value{};
    SourceSpan span;
};

/// The value of a key; nothing if the key is absent or its value is wrong.
template <class T>
using IfGiven = std::optional<Located<T>>;

/// Collects the errors and warnings of a file.
class Problems {
public:
    /// @param source  text of the file; must outlive this object
    Problems(std::string file, const std::string& source) : file_(std::move(file)), source_(&source) {}

    const std::string& source() const { return *source_; }

    /// A warning does not prevent the lesson from being read.
    void add(
        Code code, const SourceSpan& span, std::string message, std::string hint = {},
        Severity severity = Severity::error);
    void warn(Code code, const SourceSpan& span, std::string message, std::string hint = {}) {
        add(code, span, std::move(message), std::move(hint), Severity::warning);
    }

    int errors_count() const { return errors_count_; }
    /// True at kMostProblems: nobody reads more, so looking for more is not worth the time.
    bool is_full() const { return list_.size() >= kMostProblems; }
    /// Takes all diagnostics out, sorted by position.
    std::vector<Diagnostic> take();
    /// The texts for people that were read, in the order of reading.
    std::vector<ReadText>& texts() { return texts_; }

private:
    std::string file_;
    const std::string* source_;
    std::vector<Diagnostic> list_;
    std::vector<ReadText> texts_;
    int errors_count_ = 0;
};

SourceSpan span_of(const toml::source_region& region);

}  // namespace jw
