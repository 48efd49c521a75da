#include "app/host/lesson/address.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "app/session/encoding/base64.hpp"
#include "app/session/wording/typed_words.hpp"
#include "lessons/diagnostics/diagnostics.hpp"
#include "lessons/text/utf8.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/typed/typed.hpp"

namespace jw::host {

namespace {

// no browser keeps longer addresses
constexpr std::size_t kLongest = 1U << 20U;
// enough for a place of every body and a few changes of every joint in the largest lessons
constexpr std::size_t kMostExperiments = 1000;
// nearer to the poles, the heading of a picture is undefined; cameras turned by hand stay 1e-3 rad away
constexpr double kLeastTilt = 1e-6;
// of eye and target, relative to their distance from the origin
constexpr double kLeastDistance = 1e-12;
constexpr double kWidestView = 3.1;  // [rad]

constexpr const char* kTry = "try";
constexpr const char* kCamera = "camera";
/// Parts of an address that are one text each.
struct TextKey {
    std::string_view key;
    std::string Address::*text;
};
constexpr std::array kTexts{
    TextKey{"joint", &Address::joint}, TextKey{"tab", &Address::tab},
    TextKey{"exercise", &Address::exercise}};

/// A value of application/x-www-form-urlencoded.
std::string form_encoded(std::string_view text) {
    std::string out = percent_encoded(text, "*-._ ");
    std::ranges::replace(out, ' ', '+');
    return out;
}

std::string numbers_of(const render::Vector3d& v) {
    return writing::number_text(v.x()) + ' ' + writing::number_text(v.y()) + ' ' +
           writing::number_text(v.z());
}

/// "3 -4 2.5 to 0 0 0 up 0 1 0 angle 0.4 parallel": eye, target, and what differs from the usual camera.
std::string camera_text(const render::Camera& camera) {
    const render::Camera usual;
    std::string text = numbers_of(camera.eye) + " to " + numbers_of(camera.target);
    if (camera.up != usual.up) { text += " up " + numbers_of(camera.up); }
    if (camera.field_of_view != usual.field_of_view) {
        text += " angle " + writing::number_text(camera.field_of_view);
    }
    return text + (camera.orthographic ? " parallel" : "");
}

render::Camera read_camera(const std::string& text) {
    Words words(text);
    render::Camera camera;
    const auto place = [&](const std::string& what) {
        render::Vector3d v;
        for (double& x : v) { x = words.number(what); }
        return v;
    };
    camera.eye = place("a coordinate of the eye [m]");
    if (!words.take("to")) { throw Unreadable("expected 'to' and what the eye looks at, three numbers [m]"); }
    camera.target = place("a coordinate of what the eye looks at [m]");
    if (words.take("up")) { camera.up = place("a component of the direction upwards"); }
    if (words.take("angle")) { camera.field_of_view = words.number("the angle of view [rad]"); }
    camera.orthographic = words.take("parallel");
    words.finish();
    if (!can_be_told(camera)) {
        throw Unreadable(
            "the camera cannot see anything from there; expected an eye that is not at its target, an 'up' "
            "that is not along the view, and an angle of view above 0 and below " +
            writing::number_text(kWidestView) + " rad");
    }
    return camera;
}

class Reader {
public:
    explicit Reader(std::string_view text) : text_(text) {}

    Address read() {
        if (text_.size() > kLongest) {
            fail(
                kLongest, "the address is too long; expected at most " + std::to_string(kLongest) + " bytes");
        }
        begin_behind_url();
        const std::size_t end = std::min(text_.find('?', begin_), text_.size());
        read_place(end);
        std::size_t piece = end;
        while (piece < text_.size()) {
            const std::size_t next = std::min(text_.find('&', piece + 1), text_.size());
            if (next > piece + 1) { read_part(piece + 1, next); }
            piece = next;
        }
        if (address_.lesson.empty() && !(address_ == Address{})) {
            fail(begin_, "no lesson is named; expected the name of a lesson first, as in four-bar/D");
        }
        return std::move(address_);
    }

private:
    /// @param at  byte of the text, from 0
    [[noreturn]] void fail(std::size_t at, const std::string& what) const {
        throw std::runtime_error("at character " + std::to_string(characters_before(at) + 1) + ": " + what);
    }

    std::size_t characters_before(std::size_t at) const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < std::min(at, text_.size()); ++count) {
            k += std::max<std::size_t>(1, character_length(text_.substr(k)));
        }
        return count;
    }

    void begin_behind_url() {
        const std::size_t sharp = text_.find('#');
        const bool is_url = text_.find("://") < std::min(text_.find('?'), sharp);
        // a URL without # shows the list of lessons
        begin_ = sharp != std::string_view::npos ? sharp + 1 : (is_url ? text_.size() : 0);
    }

    /// Reads lesson and place: the place in the lesson follows the last slash.
    void read_place(std::size_t end) {
        const std::string_view path = text_.substr(begin_, end - begin_);
        const std::size_t slash = path.rfind('/');
        if (slash == std::string_view::npos) {
            address_.lesson = decoded(begin_, end, false);
            return;
        }
        address_.lesson = decoded(begin_, begin_ + slash, false);
        address_.at = decoded(begin_ + slash + 1, end, false);
    }

    void read_part(std::size_t begin, std::size_t end) {
        const std::size_t equals = std::min(text_.find('=', begin), end);
        const std::string key = decoded(begin, equals, true);
        const std::string value = equals < end ? decoded(equals + 1, end, true) : std::string();
        if (value.empty()) { fail(begin, in_quotes(key) + " is empty; expected a value after ="); }
        if (key == kTry) {
            if (address_.experiments.size() == kMostExperiments) {
                fail(begin, "one experiment too many; expected at most " + std::to_string(kMostExperiments));
            }
            address_.experiments.push_back(value);
        } else if (const auto* const part = std::ranges::find(kTexts, key, &TextKey::key);
                   part != kTexts.end()) {
            std::string& text = address_.*part->text;
            if (!text.empty()) { fail(begin, "a second " + key + "; expected one"); }
            text = value;
        } else if (key == kCamera) {
            if (address_.camera) { fail(begin, "a second camera; expected one"); }
            try {
                address_.camera = read_camera(value);
            } catch (const Unreadable& problem) {
                fail(begin, "camera " + in_quotes(value) + ": " + problem.what());
            }
        } else {
            fail(begin, "no part " + in_quotes(key) + "; expected one of try, joint, tab, exercise, camera");
        }
    }

    /// Text between two bytes, with each %XX replaced by the byte that it stands for.
    /// @param form  a + stands for a blank
    std::string decoded(std::size_t begin, std::size_t end, bool form) const {
        std::string out;
        for (std::size_t k = begin; k < end; ++k) {
            if (text_[k] != '%') {
                out += form && text_[k] == '+' ? ' ' : text_[k];
                continue;
            }
            unsigned byte = 0;
            const char* const digits = text_.data() + k + 1;
            if (k + 2 >= end || std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) {
                fail(
                    k, in_quotes(text_.substr(k, std::min<std::size_t>(3, end - k))) +
                           " is not a character; expected % and two hexadecimal digits, and %25 for a %");
            }
            out += static_cast<char>(byte);
            k += 2;
        }
        for (std::size_t k = 0; k < out.size();) {
            const std::size_t length = character_length(std::string_view(out).substr(k));
            if (length == 0) { fail(begin, "what begins here is not UTF-8; expected characters in UTF-8"); }
            k += length;
        }
        return out;
    }

    std::string_view text_;
    std::size_t begin_ = 0;  ///< of the address in the text
    Address address_;
};

}  // namespace

bool can_be_told(const render::Camera& camera) {
    const auto is_place = [](const render::Vector3d& v) {
        return v.allFinite() && v.cwiseAbs().maxCoeff() <= kLargestNumber;
    };
    if (!is_place(camera.eye) || !is_place(camera.target) || !is_place(camera.up)) { return false; }
    const render::Vector3d view = camera.target - camera.eye;
    const double far = std::max({1.0, camera.eye.norm(), camera.target.norm()});
    if (!(view.norm() > kLeastDistance * far) || !(camera.up.norm() > kLeastDistance)) { return false; }
    if (!(view.normalized().cross(camera.up.normalized()).norm() > kLeastTilt)) { return false; }
    return camera.field_of_view > kLeastTilt && camera.field_of_view < kWidestView;
}

std::string fragment_of(const Address& address) {
    if (address == Address{}) { return {}; }
    if (address.lesson.empty()) { throw std::invalid_argument("an address of no lesson has no other parts"); }
    std::string text = percent_encoded(address.lesson, "-._~=/");
    if (!address.at.empty() || address.lesson.find('/') != std::string::npos) {
        text += '/' + percent_encoded(address.at, "-._~=");
    }
    char before = '?';
    const auto add = [&](std::string_view key, const std::string& value) {
        if (value.empty()) { return; }
        text += before + std::string(key) + '=' + form_encoded(value);
        before = '&';
    };
    for (const std::string& experiment : address.experiments) { add(kTry, experiment); }
    for (const auto& [key, part] : kTexts) { add(key, address.*part); }
    if (!address.camera) { return text; }
    if (!can_be_told(*address.camera)) { throw std::invalid_argument("a camera that sees nothing"); }
    add(kCamera, camera_text(*address.camera));
    return text;
}

Address read_address(std::string_view text) { return Reader(text).read(); }

}  // namespace jw::host
