#include <catch2/catch.hpp>

#include <algorithm>
#include <map>
#include <sstream>

#include <imgui.h>

#include "tests/app/host/checks.hpp"
#include "tests/app/host/reach.hpp"

namespace jw::test {
namespace {

using host::Command;
using host::CommandInfo;
using host::Key;

constexpr const char* kLessons[] = {"loops/four-bar.toml", "hard/cannot-close.toml"};

/// Text of everything that a command could change.
std::string all_of(Person& person) {
    host::Host& host = person.host();
    const host::UiState& ui = host.state();
    const render::Camera& c = host.camera();
    const char* const copied = ImGui::GetClipboardText();
    std::ostringstream out;
    out << host.session()->index() << ' ' << host.session()->told() << ' ' << host.session()->in_hand() << ' '
        << static_cast<int>(ui.tab) << ui.browser << ui.help << ui.dark << ui.playback.plays() << ' '
        << ui.text_scale << ' ' << ui.playback.speed() << ' ' << ui.playback.freedom() << ' '
        << c.eye.transpose() << ' ' << c.target.transpose() << ' ' << static_cast<int>(host.task())
        << host.wants_to_close() << person.folder().files() << host.notice().text()
        << (copied == nullptr ? "" : copied) << ' ' << ui.column.offset << ' ' << ui.caption.offset;
    // every person has a folder of their own
    std::string text = out.str();
    const std::string folder = person.folder().path().string();
    if (const std::size_t at = text.find(folder); at != std::string::npos) { text.erase(at, folder.size()); }
    return text;
}

/// Does what must have happened before a command has an effect.
void prepare(Person& person, Command command) {
    person.go_to(4);
    switch (command) {
        case Command::undo:
        case Command::start_over:
        case Command::redo:
            person.drag(300.0F, 300.0F, 350.0F, 330.0F);
            REQUIRE(person.session().is_changed());
            if (command == Command::redo) { person.ask(Command::undo); }
            break;
        case Command::let_go: person.ask(Command::play_freedom); break;
        case Command::tab_step: person.ask(Command::tab_plot); break;
        case Command::fit: person.ask(Command::view_top); break;
        default: break;
    }
    // messages go, cameras come to rest
    if (command != Command::let_go) { person.rest(); }
}

/// A person in a window where a body can be pulled at every place.
std::unique_ptr<Person> somebody_at(const char* lesson) {
    auto person = std::make_unique<Person>(lesson);
    const int body = static_cast<int>(person->session().lesson().mechanism.bodies.size()) - 1;
    person->host().set_picker([body](float, float) { return picture_id(Pointable::body(body)); });
    return person;
}

/// "Ctrl+Z", "Page down", "n" as somebody presses it.
void press_as_read(Person& person, const std::string& key) {
    static const std::map<std::string, Key> names{{"Right", Key::right},
                                                  {"Left", Key::left},
                                                  {"Up", Key::up},
                                                  {"Down", Key::down},
                                                  {"Home", Key::home},
                                                  {"End", Key::end},
                                                  {"Page up", Key::page_up},
                                                  {"Page down", Key::page_down},
                                                  {"Space", Key::space},
                                                  {"Escape", Key::escape},
                                                  {"Tab", Key::tab},
                                                  {"F1", Key::f1},
                                                  {"F5", Key::f5}};
    static const std::map<char, Key> letters{
        {'Z', Key::z}, {'Y', Key::y}, {'O', Key::o}, {'S', Key::s}, {'Q', Key::q}};
    if (key.starts_with("Ctrl+")) { return person.press(letters.at(key.back()), true); }
    if (const auto found = names.find(key); found != names.end()) { return person.press(found->second); }
    INFO("a key named '" << key << "'");
    REQUIRE(key.size() == 1);
    person.type(key);
}

std::vector<std::string> keys_of(const CommandInfo& info) {
    const std::string all = info.keys;
    // the comma itself is a key
    if (all.size() == 1) { return {all}; }
    std::vector<std::string> keys;
    std::size_t from = 0;
    for (std::size_t at = all.find(", "); at != std::string::npos; at = all.find(", ", from)) {
        keys.push_back(all.substr(from, at - from));
        from = at + 2;
    }
    keys.push_back(all.substr(from));
    return keys;
}

/// Opens the menu and clicks the n-th entry of a group.
void choose_in_menu(Person& person, host::Group group, int entry) {
    const auto height = static_cast<float>(person.host().layout().height);
    const Widget button = [&] {
        const unsigned wanted = id_of("timeline bar", {"Menu"});
        for (const Widget& w : widgets_in(person, {1080.0F, height - 50.0F, 200.0F, 40.0F})) {
            if (w.id == wanted) { return w; }
        }
        throw std::runtime_error("no button 'Menu'");
    }();
    person.click(button.x, button.y);
    panels::Box menu;
    REQUIRE(open_popup(menu) != nullptr);
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const float top = ImGui::GetStyle().WindowPadding.y + 0.4F * line;
    person.click(menu.x + 20.0F, menu.y + top + line * static_cast<float>(group));
    panels::Box entries;
    REQUIRE(open_popup(entries) != nullptr);
    REQUIRE(entries.y != menu.y - 1.0F);
    person.click(entries.x + 20.0F, entries.y + top + line * static_cast<float>(entry));
    CHECK(open_popup(entries) == nullptr);
}

}  // namespace

TEST_CASE("Every key that the table names does what its command does") {
    for (const char* lesson : kLessons) {
        for (const CommandInfo& info : host::command_table()) {
            std::string first;
            for (const std::string& key : keys_of(info)) {
                const auto person = somebody_at(lesson);
                prepare(*person, info.command);
                const std::string before = all_of(*person);
                press_as_read(*person, key);
                const std::string after = all_of(*person);
                INFO(lesson << ": " << info.text << " by " << key);
                CHECK(before != after);
                CHECK(fault_of(person->host()) == "");
                if (!first.empty()) { CHECK(first == after); }
                first = after;
            }
        }
    }
}

TEST_CASE("Every entry of the menu does what its key does") {
    for (const CommandInfo& info : host::command_table()) {
        int entry = 0;
        for (const CommandInfo& other : host::command_table()) {
            if (other.command == info.command) { break; }
            entry += other.group == info.group ? 1 : 0;
        }
        const std::string wanted = [&] {
            const auto by_key = somebody_at(kLessons[0]);
            prepare(*by_key, info.command);
            by_key->ask(info.command);
            return all_of(*by_key);
        }();
        const auto by_menu = somebody_at(kLessons[0]);
        prepare(*by_menu, info.command);
        if (info.command == Command::let_go) { continue; }  // the free motion goes on while the menu is open
        INFO(info.text);
        choose_in_menu(*by_menu, info.group, entry);
        CHECK(wanted == all_of(*by_menu));
    }
}

TEST_CASE("Every command is in the table once, and no key stands for two") {
    std::map<std::string, int> seen;
    int commands = 0;
    for (const CommandInfo& info : host::command_table()) {
        CHECK(&host::info_of(info.command) == &info);
        ++commands;
        for (const std::string& key : keys_of(info)) { CHECK(++seen[key] == 1); }
    }
    CHECK(commands == static_cast<int>(Command::quit) + 1);
}

TEST_CASE("Letters that somebody types into the search are no commands") {
    Person person("");
    const bool dark = person.host().state().dark;
    const Widget field = find(person, "lessons head", {"##search"});
    person.click(field.x, field.y);
    person.type("dark");
    CHECK(person.host().state().dark == dark);
    CHECK(person.host().shelf().search() == "dark");
}

}  // namespace jw::test
