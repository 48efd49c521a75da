#include <catch2/catch.hpp>

#include <fstream>
#include <iterator>

#include "app/session/wording/messages.hpp"
#include "app/session/wording/shown_lesson.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/kept_fonts.hpp"
#include "tests/app/host/picture_values.hpp"
#include "tests/app/host/random_person.hpp"
#include "tests/app/session/all_experiments.hpp"

namespace jw::test {
namespace {

using host::Address;
using host::fragment_of;

std::string text_of_file(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Text and numbers that a session shows, every number exactly.
std::string seen_of(const Session& session) {
    return lesson_text(session.lesson()) + text_of(session.view()) + values_of(session.picture());
}

/// Setup of a window that knows the same lessons, and nothing else.
host::HostSetup setup_with(const std::filesystem::path& recent) {
    host::HostSetup setup;
    setup.catalogue = catalogue_folder();
    setup.recent_file = recent;
    setup.load_fonts = kept_fonts;
    return setup;
}

/// True if the lesson is as its file is now, from which an address begins.
bool is_as_file(const Session& session, const std::filesystem::path& file) {
    const ReadResult read = read_lesson_file(file);
    return read.lesson && lesson_text(shown_lesson(*read.lesson)) == lesson_text(session.as_written());
}

struct Followed {
    int addresses = 0;
    int with_experiments = 0;
    int with_camera = 0;
    int elsewhere = 0;
};

/// Goes to the address of a window in another one, and compares what both show.
void follow(const host::Host& host, const std::filesystem::path& recent, Followed& followed) {
    const Address address = host.address();
    const std::string fragment = fragment_of(address);
    INFO(fragment);
    host::Host other(setup_with(recent));
    const bool arrived = other.go_to(host::read_address("#" + fragment));
    INFO(other.notice().mistakes());
    REQUIRE(arrived);
    CHECK(fragment_of(other.address()) == fragment);
    other.frame(1.0);
    CHECK(fragment_of(other.address()) == fragment);
    if (!host.session()->in_hand()) { CHECK(seen_of(*other.session()) == seen_of(*host.session())); }
    if (address.camera) { CHECK(other.camera() == *address.camera); }
    ++followed.addresses;
    followed.with_experiments += address.experiments.empty() ? 0 : 1;
    followed.with_camera += address.camera ? 1 : 0;
    followed.elsewhere += address.at.empty() ? 0 : 1;
}

}  // namespace

TEST_CASE(
    "Wherever a random person has come to, the address leads another window to the same state", "[address]") {
    constexpr int kEvents = 160;
    constexpr int kBetween = 40;
    const std::vector<std::filesystem::path> lessons = lessons_below(catalogue_folder());
    Followed followed;
    for (std::size_t k = 0; k < lessons.size(); k += 4) {
        const TemporaryFolder folder;
        const std::string text = text_of_file(lessons[k]);
        const std::filesystem::path file = folder.write(lessons[k].filename().string(), text);
        Person person(file.string());
        const std::filesystem::path recent = person.folder().path() / "state" / "recent";
        RandomPerson somebody(person, 77 + static_cast<std::uint32_t>(k), file, {text});
        for (int next = kBetween; somebody.events() < kEvents; next += kBetween) {
            while (somebody.events() < next) { somebody.act(); }
            const host::Host& host = person.host();
            if (!host.shows_lesson() || !is_as_file(*host.session(), file)) { continue; }
            INFO(lessons[k].stem() << "\n" << somebody.trail());
            follow(host, recent, followed);
        }
    }
    set_language("en");
    // with few changes there would be little to find again
    CHECK(followed.addresses > 15);
    CHECK(followed.with_camera > 3);
    CHECK(followed.elsewhere > 8);
}

TEST_CASE("Whatever was tried with a lesson, its address leads another window to the same", "[address]") {
    Random random(13);
    Followed followed;
    const std::vector<std::filesystem::path> lessons = lessons_below(catalogue_folder());
    for (std::size_t lesson = 0; lesson < lessons.size(); lesson += 2) {
        const std::filesystem::path& file = lessons[lesson];
        Session session(read_lesson_file(file).lesson.value(), false);
        const auto any = [&](std::size_t size) {
            return std::min(
                size - 1, static_cast<std::size_t>(random.number(0.0, 1.0) * static_cast<double>(size)));
        };
        for (int k = 0; k < 6; ++k) {
            const std::vector<Experiment> all = all_experiments(session.lesson(), random);
            session.apply(all[any(all.size())]);
            session.apply(GoTo{static_cast<int>(any(session.story().steps().size()))});
        }
        host::Host host(setup_with({}));
        Address address;
        address.lesson = host::name_in_addresses(file, catalogue_folder());
        address.experiments = session.tried();
        address.tab = "try";
        INFO(fragment_of(address));
        REQUIRE(host.go_to(address));
        CHECK(lesson_text(host.session()->lesson()) == lesson_text(session.lesson()));
        // its story has a motion, too
        address.at = std::to_string(1 + any(host.session()->story().steps().size()));
        if (address.at == "1") { address.at.clear(); }
        if (!session.lesson().mechanism.joints.empty()) {
            address.joint = session.lesson().mechanism.joints.back().name;
        }
        address.camera = render::Camera{random.vector(5.0), random.vector(1.0)};
        const std::uint64_t told = host.session()->told();
        REQUIRE(host.go_to(address));
        // nothing was tried since
        CHECK(host.session()->told() == told);
        CHECK(host.address() == address);
        follow(host, {}, followed);
    }
    CHECK(followed.with_experiments > followed.addresses / 2);
}

}  // namespace jw::test
