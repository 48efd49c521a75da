#pragma once

#include <compare>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Which keys a reader asks of the tables of a file: for the tests that compare them with those of the
/// schema.
namespace jw {

/// A key that was asked for.
struct AskedKey {
    std::string table;  ///< keys that lead to its table, with dots: "body.shape.rod"; "" for the file
    std::string key;
    std::string as;  ///< the access of `Fields`: "number", "vector"; "known" if just looked for
    std::vector<std::string> words;  ///< those that a word is expected to be one of
    int least = 0;                   ///< of a whole number
    int most = 0;

    auto operator<=>(const AskedKey&) const = default;
};

/// Collects the keys that are asked for in this thread as long as it lives. One at a time.
class AskedKeys {
public:
    AskedKeys();
    AskedKeys(const AskedKeys&) = delete;
    AskedKeys& operator=(const AskedKeys&) = delete;
    ~AskedKeys();

    const std::set<AskedKey>& all() const { return all_; }

    /// The one that collects; nullptr if nobody does, which costs nothing.
    static AskedKeys* listening();
    void add(AskedKey asked) { all_.insert(std::move(asked)); }

private:
    std::set<AskedKey> all_;
};

}  // namespace jw
