#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tests/app/host/person.hpp"

namespace jw::test {

/// Somebody who does anything at all: moves, clicks, types, presses keys, resizes the window, looks
/// elsewhere, saves the file as another lesson meanwhile. Widgets are hit more often than by chance.
class RandomPerson {
public:
    /// @param file  the open lesson's file, overwritten with the text of `others` now and then
    RandomPerson(
        Person& person, std::uint32_t seed, std::filesystem::path file, std::vector<std::string> others);

    /// One to four events, then the frames that they need.
    void act();
    int events() const { return events_; }
    /// The events last done, oldest first, a line each.
    std::string trail() const;

private:
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint32_t>(n)); }
    float in(float from, float to);
    void push(const host::InputEvent& event, std::string what);
    void note(std::string what);
    void move();
    void use_button();
    void use_key();
    void use_text();
    void disturb();
    void open_something();
    void do_tasks();

    Person* person_;
    std::mt19937 random_;
    std::filesystem::path file_;
    std::vector<std::string> others_;
    int events_ = 0;
    int changes_ = 0;
    float x_ = 0.0F;
    float y_ = 0.0F;
    bool down_[3] = {};
    bool ctrl_ = false;
    bool shift_ = false;
    std::vector<std::string> trail_;
};

/// Picker that needs no picture: squares of the 3D view belong to bodies, joints and vectors.
host::Picker picker_of_squares(const host::Host& host);

}  // namespace jw::test
