#include "tests/app/host/random_person.hpp"

#include <array>
#include <fstream>

#include "app/session/picture/pointable.hpp"

namespace jw::test {

namespace {

using host::InputEvent;
using host::Key;

constexpr std::size_t kTrail = 20;
constexpr std::array kSizes{std::array{1280, 720},  std::array{640, 400}, std::array{2560, 1440},
                            std::array{1000, 1300}, std::array{1, 1},     std::array{320, 90},
                            std::array{1920, 1080}};
// characters of a number that is typed into a slider, and a few that are not
constexpr std::string_view kTyped = "0123456789.-+eE*/ abAZ(~";

std::string name_of(Key key) { return "key " + std::to_string(static_cast<int>(key)); }

}  // namespace

RandomPerson::RandomPerson(
    Person& person, std::uint32_t seed, std::filesystem::path file, std::vector<std::string> others)
    : person_(&person), random_(seed), file_(std::move(file)), others_(std::move(others)) {
    person.host().set_picker(picker_of_squares(person.host()));
}

float RandomPerson::in(float from, float to) {
    return from + (to - from) * static_cast<float>(below(1 << 16)) / 65536.0F;
}

void RandomPerson::note(std::string what) {
    ++events_;
    trail_.push_back(std::to_string(events_) + ": " + std::move(what));
    if (trail_.size() > kTrail) { trail_.erase(trail_.begin()); }
}

std::string RandomPerson::trail() const {
    std::string all;
    for (const std::string& line : trail_) { all += line + '\n'; }
    return all;
}

void RandomPerson::push(const InputEvent& event, std::string what) {
    const bool change = event.kind == InputEvent::Kind::button || event.kind == InputEvent::Kind::key;
    if (change) { ++changes_; }
    person_->host().push(event);
    note(std::move(what));
}

void RandomPerson::move() {
    const host::Host& host = person_->host();
    const auto width = static_cast<float>(host.layout().width);
    const auto height = static_cast<float>(host.layout().height);
    const panels::Box column = host.layout().column;
    switch (below(8)) {
        case 0:
            x_ = in(-30.0F, width + 30.0F);
            y_ = in(-30.0F, height + 30.0F);
            break;
        case 1:
            x_ = in(0.0F, width);
            y_ = height - in(0.0F, 56.0F);
            break;
        case 2:
        case 3:
        case 4:
            x_ = column.x + in(0.0F, column.width);
            y_ = column.y - 20.0F + in(0.0F, column.height + 20.0F);
            break;
        default:
            // a short way: within popups, along sliders
            x_ += in(-60.0F, 60.0F);
            y_ += in(-40.0F, 40.0F);
            break;
    }
    push(InputEvent::pointer(x_, y_), "pointer " + std::to_string(x_) + ' ' + std::to_string(y_));
}

void RandomPerson::use_button() {
    const int roll = below(10);
    const int number = roll < 8 ? 0 : roll - 7;
    bool& down = down_[number];
    down = !down;
    push(InputEvent::button(number, down), "button " + std::to_string(number) + (down ? " down" : " up"));
    // mostly a click
    if (down && below(3) != 0) {
        down = false;
        push(InputEvent::button(number, false), "button " + std::to_string(number) + " up");
    }
}

void RandomPerson::use_key() {
    const auto table = host::command_table();
    const host::CommandInfo& info = table[static_cast<std::size_t>(below(static_cast<int>(table.size())))];
    const int way = below(12);
    if (way == 0) {
        ctrl_ = !ctrl_;
        return push(InputEvent::pressed(Key::ctrl, ctrl_), ctrl_ ? "ctrl down" : "ctrl up");
    }
    if (way == 1) {
        shift_ = !shift_;
        return push(InputEvent::pressed(Key::shift, shift_), shift_ ? "shift down" : "shift up");
    }
    if (way == 2) {
        const auto key = static_cast<Key>(1 + below(static_cast<int>(Key::count) - 3));
        push(InputEvent::pressed(key), name_of(key));
        return push(InputEvent::pressed(key, false), name_of(key) + " up");
    }
    if (info.character != 0) {
        return push(
            InputEvent::typed(static_cast<unsigned char>(info.character)),
            std::string("types ") + info.character);
    }
    const Key key = info.key != Key::none ? info.key : info.ctrl;
    push(InputEvent::pressed(key), name_of(key));
    push(InputEvent::pressed(key, false), name_of(key) + " up");
}

void RandomPerson::use_text() {
    if (below(8) == 0) {
        constexpr unsigned kOdd[] = {0x3C6, 0x1F600, 0xFFFD, 0x7F, 0x200B};
        const unsigned c = kOdd[below(5)];
        return push(InputEvent::typed(c), "types U+" + std::to_string(c));
    }
    const char c = kTyped[static_cast<std::size_t>(below(static_cast<int>(kTyped.size())))];
    push(InputEvent::typed(static_cast<unsigned char>(c)), std::string("types ") + c);
}

void RandomPerson::disturb() {
    switch (below(4)) {
        case 0: {
            const auto& [width, height] = kSizes[static_cast<std::size_t>(below(kSizes.size()))];
            person_->host().resize(width, height);
            return note("resize " + std::to_string(width) + ' ' + std::to_string(height));
        }
        case 1:
            for (bool& down : down_) { down = false; }
            ctrl_ = shift_ = false;
            return push(InputEvent::leave(), "leave");
        case 2: return open_something();
        default: return person_->host().resize(1280, 720);
    }
}

void RandomPerson::open_something() {
    if (below(3) == 0) {
        person_->host().open(file_, std::to_string(1 + below(40)));
        return note("open the file");
    }
    const auto which = static_cast<std::size_t>(below(static_cast<int>(others_.size())));
    std::ofstream(file_, std::ios::binary) << others_[which];
    // two writes within the clock's resolution must still count as two
    std::filesystem::last_write_time(
        file_, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(events_));
    person_->host().look_at_file();
    note("the file is saved anew as lesson " + std::to_string(which));
}

void RandomPerson::do_tasks() {
    host::Host& host = person_->host();
    if (host.task() == host::DrawingTask::none) { return; }
    host.done("as " + host.task_path().filename().string());
}

void RandomPerson::act() {
    changes_ = 0;
    const int count = 1 + below(4);
    for (int k = 0; k < count; ++k) {
        const int roll = below(100);
        if (roll < 40) {
            move();
        } else if (roll < 65) {
            use_button();
        } else if (roll < 70) {
            const float notches = in(-3.0F, 3.0F);
            push(InputEvent::wheel(notches), "wheel " + std::to_string(notches));
        } else if (roll < 88) {
            use_key();
        } else if (roll < 96) {
            use_text();
        } else {
            disturb();
        }
    }
    constexpr double kFrames[] = {1.0 / 60.0, 1.0 / 60.0, 0.1, 1.5};
    for (int k = 0; k <= changes_; ++k) {
        person_->host().frame(kFrames[below(4)]);
        do_tasks();
    }
}

host::Picker picker_of_squares(const host::Host& host) {
    return [&host](float x, float y) {
        const Mechanism& mechanism = host.session()->lesson().mechanism;
        constexpr float kSquare = 40.0F;
        const int square = static_cast<int>(x / kSquare) + 5 * static_cast<int>(y / kSquare);
        const auto bodies = static_cast<int>(mechanism.bodies.size());
        const auto joints = static_cast<int>(mechanism.joints.size());
        switch (square % 4) {
            case 0: return picture_id(Pointable::body(square / 4 % bodies));
            case 1: return joints == 0 ? 0 : picture_id(Pointable::vector(square / 4 % joints, square % 3));
            case 2: return joints == 0 ? 0 : picture_id(Pointable::joint(square / 4 % joints));
            default: return 0;
        }
    };
}

}  // namespace jw::test
