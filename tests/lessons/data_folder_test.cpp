
#include <catch2/catch.hpp>

#include <fstream>

#include "lessons/files/catalogue.hpp"
#include "tests/support/temporary_folder.hpp"

namespace jw::test {
namespace {

namespace fs = std::filesystem;

/// A prefix or a build tree with data of its own.
struct Tree : TemporaryFolder {
    Tree() { fs::create_directories(path() / "bin"); }
    fs::path program() const { return path() / "bin" / "jointwise"; }
    void put_data() const { fs::create_directories(path() / "share" / "jointwise" / "lessons"); }
};

}  // namespace

TEST_CASE("An installed program has its data beside its own folder", "[lessons][data]") {
    const Tree tree;
    tree.put_data();
    CHECK(data_folder_of(tree.program()) == tree.path() / "share" / "jointwise");
}

TEST_CASE("A program deep in a build tree has the data of that tree", "[lessons][data]") {
    const Tree tree;
    tree.put_data();
    const fs::path deep = tree.path() / "tests" / "app" / "run" / "program";
    // a folder that only has data is not a build tree: its owner may be somebody else
    CHECK(data_folder_of(deep) != tree.path() / "share" / "jointwise");
    std::ofstream(tree.path() / "CMakeCache.txt") << "#\n";
    CHECK(data_folder_of(deep) == tree.path() / "share" / "jointwise");
}

TEST_CASE("What is installed comes before a build tree around it", "[lessons][data]") {
    const Tree tree;
    tree.put_data();
    std::ofstream(tree.path() / "CMakeCache.txt") << "#\n";
    const fs::path prefix = tree.path() / "prefix";
    CHECK(data_folder_of(prefix / "bin" / "jointwise") == tree.path() / "share" / "jointwise");
    fs::create_directories(prefix / "share" / "jointwise" / "lessons");
    CHECK(data_folder_of(prefix / "bin" / "jointwise") == prefix / "share" / "jointwise");
}

TEST_CASE("Without data the place where they should be is named", "[lessons][data]") {
    const Tree tree;
    CHECK(data_folder_of(tree.program()) == tree.path() / "share" / "jointwise");
}

TEST_CASE("Programs of a build tree read the lessons of its sources", "[lessons][data]") {
    CHECK(catalogue_folder() == fs::canonical(fs::path(JW_SOURCE_ROOT) / "lessons" / "catalogue"));
}

}  // namespace jw::test
