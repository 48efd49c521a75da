#pragma once

#include <string>
#include <vector>

struct ImGuiIO;

/// Mouse and keyboard events as values, made by a window or by tests.
namespace jw::host {

/// Longest motion of the pointer [pixels] between press and release of a click; a longer one is a drag.
inline constexpr float kLongestClick = 3.0F;

/// Number of a button that no mouse has. It turns the view, whatever is below the pointer, as a finger does.
inline constexpr int kTurningButton = 3;

enum class Key {
    none,
    left,
    right,
    up,
    down,
    home,
    end,
    page_up,
    page_down,
    space,
    enter,
    escape,
    tab,
    backspace,
    del,
    a,
    c,
    o,
    q,
    r,
    s,
    v,
    x,
    y,
    z,
    f1,
    f5,
    ctrl,
    shift,
    count,
};

/// Key of a letter, for commands with Ctrl and for ImGui; `none` if nothing uses the letter.
Key key_of_letter(char letter);

struct InputEvent {
    enum class Kind {
        pointer,  ///< x, y: pixels of the framebuffer
        button,   ///< number 0 left, 1 right, 2 middle, kTurningButton; down
        wheel,    ///< y: notches, positive away from the user
        key,      ///< key, down
        text,     ///< character: a Unicode code point that was typed
        leave,    ///< the pointer is no longer over the window, or the window lost the keyboard
    };
    Kind kind = Kind::pointer;
    float x = 0.0F;
    float y = 0.0F;
    int number = 0;
    Key key = Key::none;
    unsigned character = 0;
    bool down = false;

    static InputEvent pointer(float x, float y) { return {.kind = Kind::pointer, .x = x, .y = y}; }
    static InputEvent button(int number, bool down) {
        return {.kind = Kind::button, .number = number, .down = down};
    }
    static InputEvent wheel(float notches) { return {.kind = Kind::wheel, .y = notches}; }
    static InputEvent pressed(Key key, bool down = true) {
        return {.kind = Kind::key, .key = key, .down = down};
    }
    static InputEvent typed(unsigned character) { return {.kind = Kind::text, .character = character}; }
    static InputEvent leave() { return {.kind = Kind::leave}; }
};

/// Events that wait for their frame. ImGui looks at buttons and keys once a frame: a press and its release
/// must not be in the same frame, or ImGui would miss both.
class InputQueue {
public:
    void push(const InputEvent& event) { waiting_.push_back(event); }
    bool empty() const { return waiting_.empty(); }
    /// The events of one frame: up to the second change of a button or key, and never both a move and the
    /// release that ends it.
    std::vector<InputEvent> take();

private:
    std::vector<InputEvent> waiting_;
};

/// Tells ImGui the numbers of the keys; call it once per context.
void map_keys(ImGuiIO& io);
/// Passes an event on to ImGui.
void feed(ImGuiIO& io, const InputEvent& event);

}  // namespace jw::host
