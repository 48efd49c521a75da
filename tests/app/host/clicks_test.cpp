#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "lessons/files/catalogue.hpp"
#include "lessons/read/reader.hpp"
#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::Key;

/// Kinds of changes that were seen to happen.
using Seen = std::set<std::string>;

void compare(const Lesson& a, const Lesson& b, Seen& seen) {
    if (a.coordinates != b.coordinates) { seen.insert("coordinates"); }
    if (a.order != b.order) { seen.insert("present"); }
    for (std::size_t k = 0; k < std::min(a.mechanism.joints.size(), b.mechanism.joints.size()); ++k) {
        const Joint& i = a.mechanism.joints[k];
        const Joint& j = b.mechanism.joints[k];
        if (i.parallel_form != j.parallel_form) { seen.insert("parallel form"); }
        if (i.geometry.screw_angle_form != j.geometry.screw_angle_form) { seen.insert("screw form"); }
        if (i.without != j.without) { seen.insert("equation"); }
        if (i.geometry.s_i_local != j.geometry.s_i_local) { seen.insert("axis"); }
        if (i.geometry.P_i_local != j.geometry.P_i_local) { seen.insert("point"); }
    }
    for (std::size_t k = 0; k < a.mechanism.drivers.size() && k < b.mechanism.drivers.size(); ++k) {
        if (a.mechanism.drivers[k].function.polynomial != b.mechanism.drivers[k].function.polynomial) {
            seen.insert("driver");
        }
    }
}

/// Calls `act`, and checks whether everything is still sound.
template <class Do>
void attempt(Person& person, Seen& seen, const std::string& what, const Do& act) {
    const Lesson before = person.session().lesson();
    const int index = person.session().index();
    const host::UiState state = person.host().state();
    act();
    if (person.host().task() != host::DrawingTask::none) { person.host().done(""); }
    const std::string fault = fault_of(person.host());
    INFO(person.session().lesson().file_name << ", tab " << static_cast<int>(state.tab) << ": " << what);
    REQUIRE(fault == "");
    compare(before, person.session().lesson(), seen);
    if (index != person.session().index()) { seen.insert("step"); }
    // anything that moves by itself would move the widgets that are looked for next
    if (person.host().state().playback.freedom() >= 0) {
        seen.insert("freedom");
        person.ask(Command::let_go);
    }
    if (person.host().state().playback.plays()) { person.ask(Command::play); }
    if (person.host().state().tab != state.tab) { seen.insert("tab"); }
    if (person.host().state().browser) {
        seen.insert("browser");
        person.press(Key::escape);
    }
    if (person.host().state().help) {
        seen.insert("help");
        person.press(Key::escape);
    }
    if (person.host().state().tab != state.tab) {
        person.type(std::to_string(static_cast<int>(state.tab) + 1));
    }
}

std::string place(const Widget& w) { return std::to_string(w.x) + ", " + std::to_string(w.y); }

/// Clicks what a list offers, entry by entry; it is opened again for each.
void click_list(Person& person, Seen& seen, const Widget& opener, panels::Box list) {
    seen.insert("list");
    for (const Widget& entry : widgets_in(person, list)) {
        panels::Box again;
        if (open_popup(again) == nullptr) { person.click(opener.x, opener.y); }
        if (open_popup(again) == nullptr) { return; }
        attempt(person, seen, "entry at " + place(entry), [&] { person.click(entry.x, entry.y); });
    }
    person.click(5.0F, 5.0F);
}

/// A short drag, because every move tells the lesson again.
void drag(Person& person, const Widget& w) {
    host::Host& host = person.host();
    host.push(host::InputEvent::pointer(w.x, w.y));
    host.push(host::InputEvent::button(0, true));
    host.push(host::InputEvent::pointer(w.x + 25.0F, w.y + 10.0F));
    host.push(host::InputEvent::button(0, false));
    person.settle();
}

void use(Person& person, Seen& seen, const Widget& w, bool thorough) {
    attempt(person, seen, "click at " + place(w), [&] { person.click(w.x, w.y); });
    panels::Box list;
    const bool opened = open_popup(list) != nullptr;
    if (opened && thorough) { return click_list(person, seen, w, list); }
    if (opened) { person.click(5.0F, 5.0F); }
    if (!thorough) { return; }
    // for sliders, the sphere and the plot; a drag does no harm to a button
    attempt(person, seen, "drag from " + place(w), [&] { drag(person, w); });
}

void use_all(Person& person, Seen& seen, const panels::Box& box, const char* window, bool thorough) {
    const int most = window == nullptr ? 0 : notches_of(person, window);
    // pages overlap
    constexpr int kPage = 5;
    std::set<unsigned> used;
    for (int notches = 0; notches <= most + kPage - 1; notches += kPage) {
        if (window != nullptr) { scroll_to(person, box, std::min(notches, most)); }
        for (const Widget& w : widgets_in(person, box)) {
            if (!used.insert(w.id).second) { continue; }
            use(person, seen, w, thorough);
            // the next widget is tried on the lesson as it was, not after many changes
            if (person.session().is_changed()) { person.ask(Command::start_over); }
        }
    }
}

/// Makes the line about the last change appear: then widgets do not move while they are looked for.
void change_something(Person& person) {
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    person.drag(300.0F, 300.0F, 320.0F, 310.0F);
    person.host().set_picker({});
    person.ask(Command::start_over);
}

/// Properties that decide which widgets a lesson has. Other combinations of them are left to the person who
/// clicks at random.
using Widgets = std::set<std::string>;
Widgets widgets_of(const std::filesystem::path& file) {
    Widgets kinds;
    const Lesson lesson = *read_lesson_file(file).lesson;
    for (const Joint& joint : lesson.mechanism.joints) { kinds.insert(std::string(joint.type->name)); }
    for (const Driver& driver : lesson.mechanism.drivers) {
        kinds.insert("driver " + std::to_string(driver.measure.index()));
    }
    if (lesson.dynamics) { kinds.insert("dynamics"); }
    if (!lesson.trials.empty()) { kinds.insert("trials"); }
    return kinds;
}

/// @param thorough  lists and drags as well
Seen try_all(const std::filesystem::path& lesson, bool thorough) {
    Seen seen;
    Person person(lesson.string());
    change_something(person);
    person.go_to(std::min(person.session().story().last_assembled(), 6));
    const panels::Box column = person.host().layout().column;
    person.type("2");
    use_all(person, seen, column, "try", thorough);
    // these tabs differ between lessons only in what they draw
    for (const char* const tab : {"1", "3", "4"}) {
        person.type(tab);
        if (thorough) { use_all(person, seen, column, nullptr, true); }
    }
    if (!thorough) { return seen; }
    const auto width = static_cast<float>(person.host().layout().width);
    const auto height = static_cast<float>(person.host().layout().height);
    use_all(person, seen, {0.0F, height - 54.0F, width, 50.0F}, nullptr, thorough);
    use_all(person, seen, person.host().layout().tabs, nullptr, thorough);
    return seen;
}

}  // namespace

TEST_CASE(
    "Everything that can be clicked or dragged on any kind of lesson leaves it sound, and together does all "
    "there is") {
    Seen seen;
    std::set<std::filesystem::path> chapters;
    Widgets widgets;
    std::vector<std::filesystem::path> lessons = lessons_below(catalogue_folder());
    // every widget in the shortest lesson that has it
    std::ranges::stable_sort(lessons, {}, [](const auto& lesson) { return file_size(lesson); });
    for (const auto& lesson : lessons) {
        const std::size_t known = widgets.size();
        widgets.merge(widgets_of(lesson));
        if (widgets.size() == known) { continue; }
        const bool first_of_chapter = chapters.insert(lesson.parent_path()).second;
        seen.merge(try_all(lesson, first_of_chapter));
    }
    for (const char* const kind :
         {"coordinates", "present", "parallel form", "screw form", "equation", "axis", "point", "driver",
          "step", "freedom", "tab", "browser", "help", "list"}) {
        INFO(kind);
        CHECK(seen.contains(kind));
    }
}

}  // namespace jw::test
