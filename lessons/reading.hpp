#pragma once

#include "lessons/fields.hpp"
#include "lessons/lesson.hpp"

/// Parts of the reader: each turns one kind of table into its part of a Lesson.
namespace jw::reading {

struct Reading {
    Lesson lesson;
    Problems* problems = nullptr;

    std::vector<std::string> body_names() const;
    std::vector<std::string> joint_names() const;
    /// Index of a body or joint; reports an unknown name.
    std::optional<int> body(const Located<std::string>& name) const;
    std::optional<int> joint(const Located<std::string>& name) const;
};

void read_bodies(Fields& root, Reading& reading);
void read_joints(Fields& root, Reading& reading);
void read_drivers(Fields& root, Reading& reading);
/// Claims; after joints and drivers and the order of additions.
void read_claims(Fields& root, Reading& reading);

/// Colour by palette name or "#rrggbb".
std::optional<Colour> read_colour(Fields& fields);

/// R as the columns of the body's axes in the global frame (p normalised).
Mat3 rotation_of(const Body& body);

}  // namespace jw::reading
