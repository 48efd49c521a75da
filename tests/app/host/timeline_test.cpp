#include <catch2/catch.hpp>

#include <imgui.h>
#include <imgui_internal.h>

#include "app/host/parts/bar_buttons.hpp"
#include "app/host/parts/timeline_bar.hpp"
#include "app/session/output/pace.hpp"
#include "app/session/story/timeline.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/person.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;

constexpr const char* kMovingFourBar = "loops/four-bar.toml";

int last_of(const Person& person) { return static_cast<int>(person.session().story().steps().size()) - 1; }

int first_step_of(const Person& person, const std::string& name) {
    for (const Stretch& s : stretches_of(person.session().story())) {
        if (s.name == name) { return s.first; }
    }
    return -1;
}

/// Starts the motion and waits only a moment: a motion that plays does not come to rest.
void play_motion(Person& person) {
    person.host().push(host::InputEvent::typed('M'));
    person.wait(0.05);
}

}  // namespace

TEST_CASE("Keys go to the next step and back, to the joints, and to both ends") {
    Person person(kMovingFourBar);
    CHECK(person.session().index() == 0);
    person.press(Key::left);
    CHECK(person.session().index() == 0);
    person.press(Key::right);
    CHECK(person.session().index() == 1);
    person.type("n");
    CHECK(person.session().index() == 2);
    person.type("b");
    CHECK(person.session().index() == 1);
    person.press(Key::page_down);
    CHECK(person.session().index() == first_step_of(person, "B"));
    person.press(Key::page_down);
    CHECK(person.session().index() == first_step_of(person, "C"));
    person.press(Key::right);
    person.press(Key::page_up);
    CHECK(person.session().index() == first_step_of(person, "C"));
    person.press(Key::page_up);
    CHECK(person.session().index() == first_step_of(person, "B"));
    person.press(Key::end);
    CHECK(person.session().index() == last_of(person));
    person.press(Key::right);
    CHECK(person.session().index() == last_of(person));
    person.press(Key::home);
    CHECK(person.session().index() == 0);
}

TEST_CASE("Every step of the four-bar is the same forth and back") {
    Person person(kMovingFourBar);
    const int motion = person.session().story().last_assembled() + 5;
    std::vector<std::string> forth;
    for (int k = 0; k <= motion; ++k) {
        REQUIRE(person.session().index() == k);
        forth.push_back(text_of(person.view()));
        person.press(Key::right);
    }
    for (int k = motion; k >= 0; --k) {
        person.press(Key::left);
        REQUIRE(person.session().index() == k);
        REQUIRE(text_of(person.view()) == forth[static_cast<std::size_t>(k)]);
    }
}

TEST_CASE("It plays to the end, pauses where it is, and begins anew from the end") {
    Person person("joints/revolute.toml");
    person.press(Key::space);
    REQUIRE(person.host().state().playback.plays());
    person.wait(0.5);
    const int before = person.session().index();
    person.wait(seconds_of_step(person.session().story(), person.view()));
    CHECK(person.session().index() == before + 1);
    person.press(Key::space);
    CHECK_FALSE(person.host().state().playback.plays());
    const int paused = person.session().index();
    person.wait(3.0);
    CHECK(person.session().index() == paused);

    for (int k = 0; k < 4; ++k) { person.type("."); }
    CHECK(person.host().state().playback.speed() == 4.0);
    person.press(Key::space);
    for (int minute = 0; minute < 3 && person.host().state().playback.plays(); ++minute) {
        person.wait(60.0);
    }
    CHECK(person.session().index() == last_of(person));
    CHECK_FALSE(person.host().state().playback.plays());
    person.press(Key::space);
    CHECK(person.session().index() < last_of(person));
    CHECK(person.host().state().playback.plays());
    for (int k = 0; k < 6; ++k) { person.type(","); }
    CHECK(person.host().state().playback.speed() == 0.25);
}

TEST_CASE("No still is shown for more than ten seconds, and a long one at 260 words a minute") {
    const Person person(kMovingFourBar);
    const Story& story = person.session().story();
    double stills = 0.0;
    for (int k = 0; k <= story.last_assembled(); ++k) {
        const double seconds = seconds_of_step(story, view_of(story, k));
        CHECK(seconds >= 1.5);
        CHECK(seconds <= 10.0);
        const Step::Kind kind = story.steps()[static_cast<std::size_t>(k)].kind;
        stills += is_asked(kind) ? 0.0 : seconds;
    }
    // it was 189 s; time to think about questions is not counted
    CHECK(stills < 160.0);
    View view;
    view.kind = Step::Kind::equations;
    view.sentence = "one two three four five six seven eight nine ten eleven twelve thirteen";
    CHECK(seconds_to_look(view, 0.0) == Approx(1.5 + 13.0 * 60.0 / 260.0));
}

TEST_CASE("A still that is played counts down to the next step, a motion does not") {
    Person person(kMovingFourBar);
    const auto left = [&] { return person.host().state().playback.seconds_to_next_still(person.session()); };
    CHECK_FALSE(left().has_value());
    person.press(Key::space);
    REQUIRE(left().has_value());
    const double before = *left();
    CHECK(person.host().seconds_to_change() <= 0.25);
    person.wait(1.0);
    REQUIRE(left().has_value());
    CHECK(*left() == Approx(before - 1.0).margin(0.1));
    CHECK(host::play_label(true, 6.2) == "Pause 7 s###play");
    play_motion(person);
    CHECK_FALSE(left().has_value());
}

TEST_CASE("M plays the motion only, from its beginning") {
    Person person(kMovingFourBar);
    const int first = *first_moment(person.session().story());
    play_motion(person);
    CHECK(person.host().state().playback.plays());
    CHECK(person.session().index() >= first);
    CHECK(person.session().index() <= first + 5);
    person.wait(1.0);
    CHECK(person.session().index() > first + 10);
    play_motion(person);
    CHECK(person.session().index() <= first + 5);
    CHECK(person.host().state().playback.plays());
}

TEST_CASE("A click on the line jumps there, a drag scrubs, the wheel steps") {
    Person person(kMovingFourBar);
    const float y = static_cast<float>(person.host().layout().height) - 20.0F;
    std::vector<int> seen;
    for (float x = 360.0F; x <= 1080.0F; x += 70.0F) {
        person.click(x, y);
        if (!seen.empty()) { CHECK(person.session().index() >= seen.back()); }
        seen.push_back(person.session().index());
    }
    CHECK(seen.front() < first_step_of(person, "B"));
    CHECK(seen.back() > person.session().story().last_assembled());
    person.drag(1080.0F, y, 410.0F, y);
    CHECK(person.session().index() < first_step_of(person, "C"));
    const int before = person.session().index();
    person.wheel(-1.0F);
    CHECK(person.session().index() == before + 1);
    person.wheel(1.0F);
    CHECK(person.session().index() == before);
}

TEST_CASE("A quick drag, all of it between two frames, goes to where it ends") {
    Person person(kMovingFourBar);
    const float y = static_cast<float>(person.host().layout().height) - 20.0F;
    person.host().push(host::InputEvent::pointer(400.0F, y));
    person.host().push(host::InputEvent::button(0, true));
    person.host().push(host::InputEvent::pointer(700.0F, y));
    person.host().push(host::InputEvent::pointer(1080.0F, y));
    person.host().push(host::InputEvent::button(0, false));
    person.settle();
    CHECK(person.session().index() > person.session().story().last_assembled());
}

TEST_CASE("Every step lies on the line where a click finds it") {
    Person person(kMovingFourBar);
    const std::vector<Stretch> stretches = stretches_of(person.session().story());
    const host::TimelineScale scale(stretches, 230.0F, 860.0F);
    for (int k = 0; k <= last_of(person); ++k) { REQUIRE(scale.step_at(scale.x_of(k)) == k); }
}

TEST_CASE("A place in a lesson is a number from 1 on, a name, or a moment") {
    Person person(kMovingFourBar);
    const Story& story = person.session().story();
    const int last = last_of(person);
    CHECK(step_at(story, "12") == 11);
    CHECK(step_at(story, "1") == 0);
    CHECK(step_at(story, std::to_string(last + 1)) == last);
    CHECK(step_at(story, "B") == first_step_of(person, "B"));
    // the step after its question
    CHECK(step_at(story, "motor") == first_step_of(person, "motor") + 1);
    const auto half = step_at(story, "t=0.5");
    REQUIRE(half);
    int first_moment = 0;
    while (story.steps()[static_cast<std::size_t>(first_moment)].kind != Step::Kind::motion) {
        ++first_moment;
    }
    // 200 intervals in 4 s
    CHECK(story.steps()[static_cast<std::size_t>(*half)].t == Approx(0.5).margin(0.0101));
    CHECK(step_at(story, "t=-7") == first_moment);
    for (const std::string nonsense :
         {"", "0", "-1", "1.5", "b", "t=", "t=soon", "t=nan", "1e9", "12x", "t=0.5s", " 1"}) {
        CAPTURE(nonsense);
        CHECK_FALSE(step_at(story, nonsense));
    }
    CHECK_FALSE(step_at(story, std::to_string(last + 2)));
}

TEST_CASE("Buttons of an upright window are as large as a finger, and leave none out without the menu") {
    for (const float text : {0.75F, 1.0F, 1.5F}) {
        Person person("loops/four-bar.toml", Person::Pictures::none, 480, 960, false, text);
        const host::WindowLayout& layout = person.host().layout();
        REQUIRE(layout.upright);
        // a phone has 390 pixels of a page in this width
        constexpr float kFinger = 40.0F * 480.0F / 390.0F;
        const float y = layout.bar.bottom() - 0.5F * kFinger;
        std::vector<unsigned> seen;
        std::vector<float> widths;
        for (float x = 0.0F; x < layout.bar.right(); x += 1.0F) {
            person.point(x, y);
            const unsigned id = ImGui::GetCurrentContext()->HoveredId;
            if (id == 0) { continue; }
            if (seen.empty() || seen.back() != id) {
                seen.push_back(id);
                widths.push_back(0.0F);
                // as high as a finger, too
                person.point(x, y - 0.4F * kFinger);
                CHECK(ImGui::GetCurrentContext()->HoveredId == id);
                person.point(x, y + 0.3F * kFinger);
                CHECK(ImGui::GetCurrentContext()->HoveredId == id);
            }
            widths.back() += 1.0F;
        }
        CAPTURE(text);
        // step back, play, step on, lessons, menu; with usual letters all but speed and keys
        CHECK(seen.size() >= (text > 1.0F ? 5 : 7));
        for (const float width : widths) { CHECK(width >= kFinger - 2.0F); }
        person.click(layout.bar.right() - 30.0F, y);
        panels::Box menu;
        CHECK(open_popup(menu) != nullptr);
    }
}

}  // namespace jw::test
