#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "core/linear.hpp"
#include "lessons/diagnostics.hpp"

/// Typed access to a TOML table that collects what is wrong instead of throwing.
namespace jw {

/// Longest list that is read; absurd sizes are errors, not a long wait.
inline constexpr std::size_t kLongestList = 10000;
/// Largest number that is taken for a length, an angle or a time.
inline constexpr double kLargestNumber = 1e9;

/// A value with the place where it stands.
template <class T>
struct Located {
    T value{};
    SourceSpan span;
};

/// Where errors go.
class Problems {
public:
    Problems(std::string file, std::string_view source) : file_(std::move(file)), source_(source) {}

    void add(const SourceSpan& span, std::string message, std::string hint = {});
    SourceSpan span_of(const toml::node& node) const;
    SourceSpan span_of(const toml::key& key) const;

    bool empty() const { return list_.empty(); }
    /// All of them, by position.
    std::vector<Diagnostic> take();

private:
    SourceSpan span_of(const toml::source_region& region) const;

    std::string file_;
    std::string_view source_;
    std::vector<Diagnostic> list_;
};

/// One table. Keys that are read are remembered; `finish` reports the others as unknown.
class Fields {
public:
    Fields(const toml::table& table, std::string what, Problems& problems)
        : table_(&table), what_(std::move(what)), problems_(&problems) {}

    bool has(std::string_view key);
    SourceSpan span() const { return problems_->span_of(*table_); }
    SourceSpan span(std::string_view key) const;
    Problems& problems() const { return *problems_; }
    const std::string& what() const { return what_; }

    // absent keys give nothing; wrong ones give nothing and a diagnostic
    std::optional<Located<std::string>> text(std::string_view key);
    std::optional<Located<double>> number(std::string_view key);
    std::optional<Located<double>> positive(std::string_view key);
    std::optional<Located<int>> integer(std::string_view key);
    std::optional<Located<bool>> flag(std::string_view key);
    std::optional<Located<Vec3>> vector(std::string_view key);
    /// A vector that is not zero.
    std::optional<Located<Vec3>> direction(std::string_view key);
    std::optional<Located<std::vector<double>>> numbers(std::string_view key, std::size_t count = 0);
    std::optional<Located<std::vector<Located<std::string>>>> texts(std::string_view key);
    std::optional<Fields> table(std::string_view key);
    /// A list of tables, or one table as a list of one.
    std::vector<Fields> tables(std::string_view key);
    /// Index of the text among `words`.
    std::optional<std::size_t> word(std::string_view key, const std::vector<std::string>& words);

    /// A number under `key` + "_deg" or `key` + "_rad" [rad].
    std::optional<Located<double>> angle(std::string_view key);

    /// Says that `key` must be given.
    void missing(std::string_view key, std::string_view expected);
    /// At most one of the keys may be there.
    bool at_most_one(const std::vector<std::string>& keys);
    /// Reports unknown keys.
    void finish();

private:
    const toml::node* find(std::string_view key);
    void wrong_type(std::string_view key, const toml::node& node, std::string_view expected);
    std::optional<double> finite(const toml::node& node, std::string_view what);

    const toml::table* table_;
    std::string what_;
    Problems* problems_;
    std::set<std::string, std::less<>> known_;
};

}  // namespace jw
