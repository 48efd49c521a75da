#include <catch2/catch.hpp>

#include <cstring>

#include <imgui.h>

#include "lessons/files/catalogue.hpp"
#include "tests/app/host/person.hpp"

namespace jw::test {
namespace {

/// Draw data of ImGui as text.
std::string drawn() {
    const ImDrawData& data = *ImGui::GetDrawData();
    std::string all;
    for (int k = 0; k < data.CmdListsCount; ++k) {
        const ImDrawList& list = *data.CmdLists[k];
        const auto add = [&](const auto& buffer) {
            const auto* begin = reinterpret_cast<const char*>(buffer.Data);
            all.append(begin, static_cast<std::size_t>(buffer.size_in_bytes()));
        };
        add(list.VtxBuffer);
        add(list.IdxBuffer);
    }
    return all;
}

/// Two seconds in which nothing happens, in frames as long as those of a slow machine: whatever moves by
/// itself shows within one of them.
void look_on(Person& person) {
    for (int k = 0; k < 20; ++k) { person.host().frame(0.1); }
}

}  // namespace

TEST_CASE("Frames in which nothing happens compute nothing, and look the same") {
    for (const auto& lesson : lessons_below(catalogue_folder())) {
        Person person(lesson.string());
        for (const char* const tab : {"1", "2", "3", "4"}) {
            person.press(host::Key::home);
            for (const host::Key to : {host::Key::page_down, host::Key::end}) {
                person.press(to);
                person.type(tab);
                person.rest();
                INFO(lesson.filename().string() << ", tab " << tab);
                const std::uint64_t views = person.session().views_computed();
                const std::uint64_t version = person.session().version();
                const std::uint64_t picture = person.host().shown().version();
                const std::string before = drawn();
                look_on(person);
                CHECK(person.session().views_computed() == views);
                CHECK(person.session().version() == version);
                CHECK(person.host().shown().version() == picture);
                CHECK((drawn() == before));
                CHECK(person.host().seconds_to_change() > 0.1);
            }
        }
    }
}

TEST_CASE("The list of lessons at rest waits, too") {
    Person person("");
    person.wait(1.0);
    const std::string before = drawn();
    look_on(person);
    CHECK((drawn() == before));
    CHECK(person.host().seconds_to_change() > 0.1);
}

}  // namespace jw::test
