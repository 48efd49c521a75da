#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstring>

#include <sys/inotify.h>
#include <unistd.h>

#include "tests/app/snapshot/suite.hpp"

namespace jw::test {
namespace {

namespace fs = std::filesystem;

/// A folder of two lessons with their golden snapshots.
class TwoLessons {
public:
    TwoLessons() {
        fs::create_directories(folder_.path("lessons/loops"));
        folder_.file("lessons/crank.toml", kCrank);
        folder_.file("lessons/loops/plate.toml", kPlate);
        REQUIRE(ran("record", {"--only", "bodies"}).status == 0);
        fs::remove(folder_.path("lessons/loops/plate.toml"));
    }
    Ran ran(const std::string& verb, const std::vector<std::string>& more = {}, const char* of = "lessons") {
        std::vector<std::string> arguments{verb, folder_.path(of), "--golden", folder_.path("golden")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return Suite::snapshot(arguments);
    }
    std::string golden(const std::string& name) const { return folder_.path("golden/" + name); }
    void remove_crank() const { fs::remove(folder_.path("lessons/crank.toml")); }

private:
    Folder folder_;
};

/// A question before anything moves.
constexpr const char* kQuestion = R"([[question]]
at = "pivot"
ask = "How many freedoms are left?"
count = "dof"
why = "One turn."
)";

constexpr const char* kTold = R"([[step]]
at_s = 0.25
text = "A quarter of a second."
)";

/// Names of files that were moved into a folder, in the order of their arrival.
class Arrivals {
public:
    explicit Arrivals(const std::string& folder) : file_(::inotify_init1(IN_NONBLOCK)) {
        REQUIRE(::inotify_add_watch(file_, folder.c_str(), IN_MOVED_TO) >= 0);
    }
    ~Arrivals() { ::close(file_); }
    Arrivals(const Arrivals&) = delete;
    Arrivals& operator=(const Arrivals&) = delete;

    std::vector<std::string> take() const {
        std::vector<std::string> names;
        alignas(inotify_event) std::array<char, 1U << 16U> bytes{};
        const ssize_t size = ::read(file_, bytes.data(), bytes.size());
        for (ssize_t at = 0; at < size;) {
            inotify_event event{};
            std::memcpy(&event, bytes.data() + at, sizeof event);
            names.emplace_back(bytes.data() + at + sizeof event);
            at += static_cast<ssize_t>(sizeof event + event.len);
        }
        return names;
    }

private:
    int file_;
};

}  // namespace

TEST_CASE("a lesson that is deleted from the compared folder fails, and says how to go on", "[snapshot]") {
    TwoLessons lessons;
    const Ran ran = lessons.ran("compare");
    INFO(ran.out << ran.err);
    CHECK(ran.status == 1);
    CHECK(says(ran, "loops/plate: 0 of 1 snapshot same\n  why: the lesson is deleted, and its golden"));
    CHECK(says(ran, "'jointwise snapshot bless' of the folder of lessons, with --reason, removes them"));
    CHECK(says(ran, "1 lesson is deleted"));
    CHECK(says(lessons.ran("compare", {"--format", "junit"}), "<failure type=\"deleted\""));
    // single files do not tell which lessons exist
    CHECK(lessons.ran("compare", {}, "lessons/crank.toml").status == 0);
}

TEST_CASE("golden snapshots of a deleted lesson are removed with a reason that is kept", "[snapshot]") {
    TwoLessons lessons;
    std::ofstream(lessons.golden("loops/notes.txt")) << "mine";
    CHECK(lessons.ran("bless", {"--reason", "one step", "--only", "bodies"}).status == 2);
    REQUIRE(fs::exists(lessons.golden("loops/plate/bodies.json")));
    const Ran ran = lessons.ran("bless", {"--reason", "told elsewhere"});
    CHECK(ran.out == "loops/plate: the lesson is deleted, its snapshots are removed\n");
    CHECK_FALSE(fs::exists(lessons.golden("loops/plate")));
    CHECK(fs::exists(lessons.golden("loops/notes.txt")));
    const auto kept = nlohmann::json::parse(bytes_of(lessons.golden("removed.json")));
    CHECK(kept["removed"][0]["lesson"] == "loops/plate");
    CHECK(kept["removed"][0]["reason"] == "told elsewhere");
    CHECK(lessons.ran("compare").status == 0);
}

TEST_CASE("the deletion of every lesson fails, and is accepted with a reason", "[snapshot]") {
    TwoLessons lessons;
    lessons.remove_crank();
    const Ran ran = lessons.ran("compare");
    INFO(ran.out << ran.err);
    CHECK(ran.status == 1);
    CHECK(says(ran, "crank: 0 of 1 snapshot same\n  why: the lesson is deleted, and its golden"));
    CHECK(says(ran, "2 lessons are deleted"));
    CHECK(lessons.ran("bless", {"--reason", "one step", "--only", "bodies"}).status == 2);
    REQUIRE(fs::exists(lessons.golden("crank/bodies.json")));
    CHECK(lessons.ran("bless", {"--reason", "the course is over"}).status == 0);
    CHECK_FALSE(fs::exists(lessons.golden("crank")));
    const auto kept = nlohmann::json::parse(bytes_of(lessons.golden("removed.json")));
    CHECK(kept["removed"].size() == 2);
    CHECK(lessons.ran("compare").status == 0);
    // without lessons nothing is recorded
    CHECK(lessons.ran("record").status == 2);
}

TEST_CASE("an empty folder is refused where no lesson was deleted", "[snapshot]") {
    const Folder folder;
    fs::create_directories(folder.path("lessons"));
    fs::create_directories(folder.path("golden"));
    for (const char* const verb : {"compare", "bless"}) {
        std::vector<std::string> arguments{verb, folder.path("lessons"), "--golden", folder.path("golden")};
        if (std::string(verb) == "bless") { arguments.insert(arguments.end(), {"--reason", "r"}); }
        const Ran ran = Suite::snapshot(arguments);
        CHECK(ran.status == 2);
        CHECK(says(ran, "there is no lesson below this folder"));
    }
}

TEST_CASE("a golden file that allows far more than the program does is blind", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies"});
    const std::string record = bytes_of(suite.golden("bodies.json"));
    const std::size_t at = record.find("plate · r · x\",");
    REQUIRE(at != std::string::npos);
    const std::string line = record.substr(at, record.find(']', at) - at);
    const std::string loose = line.substr(0, line.rfind(',') + 1) + "1000000000.0";
    suite.change_golden("bodies.json", line, loose);
    const Ran ran = suite.compare();
    INFO(ran.out);
    CHECK(ran.status == 1);
    CHECK(says(ran, "BLIND: tolerances of the golden file are more than 100 times those of the program"));
    CHECK(says(ran, "plate · r · x: 1e+09 m may differ, of "));
    CHECK(suite.bless("as the program computes it").status == 0);
    CHECK(suite.compare().status == 0);
}

TEST_CASE("the moments that the author tells something at are taken", "[snapshot]") {
    const Suite suite(std::string(kCrank) + kTold, {"--moments", "1"});
    CHECK(fs::exists(suite.golden("motion-0.25.json")));
    CHECK_FALSE(fs::exists(suite.golden("motion-0.5.json")));
}

TEST_CASE("missing steps are listed before changed facts", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies", "--only", "pivot"});
    for (const char* const ending : {".json", ".png", ".ids.png", ".depth.png"}) {
        fs::copy_file(
            suite.golden(std::string("bodies") + ending), suite.golden(std::string("lost") + ending));
    }
    suite.change_golden("lost.json", R"("name": "bodies")", R"("name": "lost")");
    suite.change_golden("pivot.json", R"(["rank","rank",5])", R"(["rank","rank",4])");
    const Ran ran = suite.compare();
    INFO(ran.out);
    CHECK(ran.status == 1);
    CHECK(says(
        ran,
        "why: no value of the lesson has changed, and the lesson has no step 'lost' any more\n  lost: "));
}

TEST_CASE("a question that is left out changes the number of steps once, and no snapshot", "[snapshot]") {
    Suite suite(
        std::string(kCrank) + kQuestion, {"--only", "bodies", "--only", "pivot", "--only", "motion-1"});
    suite.change(kQuestion, "");
    const Ran ran = suite.compare();
    INFO(ran.out);
    CHECK(ran.status == 1);
    CHECK(says(ran, "crank: 3 of 3 snapshots same\n  why: question"));
    CHECK(says(ran, "\n  the lesson has 10 steps, 12 before\n"));
    CHECK(says(ran, "1 lesson, 3 snapshots: 3 same, 1 lesson has another number of steps"));
    CHECK(says(suite.compare({"--format", "junit"}), "failures=\"1\""));
    CHECK(suite.bless("the question was too easy").status == 0);
    CHECK(suite.compare().status == 0);
}

TEST_CASE("with another number of steps, all else on the picture still counts", "[snapshot]") {
    Suite suite(std::string(kPlate) + kQuestion, {"--only", "bodies"});
    suite.change(kQuestion, "");
    suite.change("colour = \"blue\"", "colour = \"vermilion\"");
    const Ran ran = suite.compare();
    INFO(ran.out);
    CHECK(says(ran, "0 of 1 snapshot same"));
    CHECK(says(ran, "colours: "));
}

TEST_CASE("a record comes before the pictures that it replaces, and after new ones", "[snapshot]") {
    // so that the reason is kept, and no record lacks its pictures, if the program is killed in between
    Suite suite(kPlate, {"--only", "bodies"});
    suite.change("radius = 0.05", "radius = 0.051");
    const std::string old_picture = bytes_of(suite.golden("bodies.ids.png"));
    const Arrivals arrivals(suite.golden("."));
    REQUIRE(suite.bless("thicker").status == 0);
    const std::vector<std::string> blessed = arrivals.take();
    REQUIRE(blessed.size() == 5);
    CHECK(blessed.front() == "bodies.json");

    // as if it had been killed after the record
    suite.write_golden("bodies.ids.png", old_picture);
    CHECK(suite.compare().status == 1);
    REQUIRE(suite.bless("thicker").status == 0);
    const auto record = nlohmann::json::parse(bytes_of(suite.golden("bodies.json")));
    CHECK(record["blessed"] == nlohmann::json{"thicker"});

    fs::remove(suite.golden("bodies.json"));
    static_cast<void>(arrivals.take());
    REQUIRE(Suite::snapshot({"record", suite.lesson(), "--golden", suite.golden()}).status == 0);
    CHECK(arrivals.take().back() == "bodies.json");
}

TEST_CASE("an empty golden folder, and rules behind a link to nothing, are refused", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies"});
    const Ran empty = Suite::snapshot({"record", suite.lesson(), "--golden", ""});
    CHECK(empty.status == 2);
    CHECK(says(empty, "--golden: it is empty; expected a folder"));
    fs::create_symlink("nothing.toml", suite.golden() + "/rules.toml");
    const Ran dangling = suite.compare();
    CHECK(dangling.status == 2);
    CHECK(says(dangling, "rules.toml"));
}

TEST_CASE("a golden file sends no commands to a terminal", "[snapshot]") {
    const Suite suite(kPlate, {"--only", "bodies"});
    suite.change_golden(
        "bodies.json", R"(["text","title",")", R"(["text","title","\u001b]0;mine\u0007\u009b31m)");
    const Ran ran = suite.compare();
    CHECK(ran.status == 1);
    CHECK(says(ran, "]0;mine"));
    for (const char* const control : {"\x1b", "\a", "\xc2\x9b"}) { CHECK_FALSE(says(ran, control)); }
}

}  // namespace jw::test
