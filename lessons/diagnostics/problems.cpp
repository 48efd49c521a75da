#include "lessons/diagnostics/problems.hpp"

#include <algorithm>

namespace jw {

void Problems::add(Code code, const SourceSpan& span, std::string message, std::string hint) {
    ++errors_count_;
    if (is_full()) { return; }
    list_.push_back({file_, span, code, std::move(message), std::move(hint), Severity::error});
}

void Problems::warn(Code code, const SourceSpan& span, std::string message, std::string hint) {
    if (is_full()) { return; }
    list_.push_back({file_, span, code, std::move(message), std::move(hint), Severity::warning});
}

std::vector<Diagnostic> Problems::take() {
    std::ranges::stable_sort(list_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.span.line, a.span.column) < std::pair(b.span.line, b.span.column);
    });
    return std::move(list_);
}

SourceSpan span_of(const toml::source_region& region) {
    SourceSpan span{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), 1};
    if (region.end.line == region.begin.line && region.end.column > region.begin.column) {
        span.length = static_cast<int>(region.end.column - region.begin.column);
    }
    return span;
}

}  // namespace jw
