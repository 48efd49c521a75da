#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson/lesson.hpp"
#include "lessons/typed/exact_text.hpp"

/// Parts of the writer: each turns its part of a Lesson into one kind of table.
namespace jw::writing {

/// The file under construction.
class Lines {
public:
    /// A comment across the page, "# ---- joints ----".
    void section(const std::string& title);
    /// "[motion]" or "[[body]]", after an empty line.
    void table(const std::string& header);
    /// "name = value", with a comment behind it where there is one.
    void key(const std::string& name, const std::string& value, const std::string& comment = {});
    void key(const std::string& name, double value, const std::string& comment = {});
    void key(const std::string& name, const Vec3& value, const std::string& comment = {});
    /// A text in every language, "text = ..." and "zh-Hant.text = ...".
    void text(const std::string& name, const Text& text);
    /// The same for a text whose line feeds at the end do not matter.
    void words(const std::string& name, const Text& text);
    /// A list of texts in every language that one of them has.
    void texts(const std::string& name, const std::vector<Text>& texts);
    /// Writes an angle; its unit is appended to the name.
    void angle(const std::string& name, double radians_of, const std::string& per = {});
    /// Writes several angles as one list.
    void angles(const std::string& name, std::span<const double> radians_of, const std::string& per = {});

    std::string take() { return std::move(text_); }

private:
    /// The text in other languages, each as `written` gives it.
    void translations(const std::string& name, const Text& text, std::string (*written)(const std::string&));

    std::string text_;
};

/// Keys of an inline table: "{ size = [1, 1, 1], radius = 0.1 }".
class Inline {
public:
    Inline& add(const std::string& name, const std::string& value) {
        text_ += (text_.empty() ? "" : ", ") + name + " = " + value;
        return *this;
    }
    Inline& add(const std::string& name, const Vec3& v) { return add(name, vector_text(v)); }
    Inline& add(const std::string& name, double x) { return add(name, number_text(x)); }
    /// An angle or, if `angle` is false, any other value.
    Inline& add(const std::string& name, double x, bool angle) {
        const AngleTexts typed = angle ? typed_angles({&x, 1}) : AngleTexts{"", {x}};
        return add(angle ? name + '_' + typed.unit : name, typed.values[0]);
    }
    /// For write_members: there is no room for comments.
    void key(const std::string& name, const std::string& value, const std::string& /*comment*/) {
        add(name, value);
    }
    std::string text() const { return "{ " + text_ + " }"; }

private:
    std::string text_;
};

/// Parts of a lesson that are written.
struct Written {
    explicit Written(const Lesson& whole);

    bool has(const Addition& addition) const;
    const std::string& name_of(const Addition& addition) const;
    const std::string& body(int index) const;
    /// "["ground", "crank"]"
    std::string pair(int body_i, int body_j) const;

    const Lesson* lesson;
    std::vector<Addition> order;  ///< without additions that have been taken out
};

void write_head(const Written& written, Lines& lines);
void write_motion(const Lesson& lesson, Lines& lines);
void write_precision(const Precision& precision, Lines& lines);
void write_camera(const Lesson& lesson, Lines& lines);
void write_steps(const Lesson& lesson, Lines& lines);
void write_bodies(const Lesson& lesson, Lines& lines);
void write_joints(const Written& written, Lines& lines);
void write_drivers(const Written& written, Lines& lines);
void write_dynamics(const Written& written, Lines& lines);
void write_questions(const Written& written, Lines& lines);
void write_claims(const Written& written, Lines& lines);

/// Keys of a function of time; for an angle, with their unit.
void write_time_function(const TimeFunction& function, bool angle, Lines& lines);
/// Keys `mass`, `centre`, `inertia`.
void write_mass(const MassProperties& mass, Lines& lines);
/// Key `point` of a quantity whose name leaves the point open.
void write_point(const Quantity& quantity, const std::string& name, Lines& lines);
/// Values of a quantity, all in degrees or none; the names of angles and of their rates end with the unit.
using NamedValue = std::pair<const char*, double>;
void write_values(
    const Quantity& quantity, int derivative, bool in_degrees, const std::vector<NamedValue>& values,
    Lines& lines);
/// Key `shape`.
void write_shapes(const std::vector<Shape>& shapes, Lines& lines);
/// "blue" or "#2f78b7".
std::string colour_text(const Colour& colour);

}  // namespace jw::writing
