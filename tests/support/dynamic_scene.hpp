#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lessons/lesson/lesson.hpp"

/// Construction of a lesson of dynamics in code.
namespace jw::test {

inline const Vec3 kX = Vec3::UnitX();
inline const Vec3 kY = Vec3::UnitY();
inline const Vec3 kZ = Vec3::UnitZ();
inline constexpr double kGravity = 9.81;

/// A solid box about its middle, edges along the axes of its frame.
MassProperties box_mass(double mass, const Vec3& edges);
/// Mass of two bodies that are fixed to each other, both given in the same frame.
MassProperties together(const MassProperties& a, const MassProperties& b);

/// A bar between two points and a hub across its end: what a link of a plane mechanism looks like.
std::vector<Shape> link_shapes(const Vec3& from, const Vec3& to, double radius, const Vec3& hub_axis);

class DynamicScene {
public:
    DynamicScene(const std::string& title, const std::string& source, const std::string& text);

    struct Part {
        std::string name;
        Vec3 r = Vec3::Zero();
        Vec4 p = Vec4::Unit(0);
        MassProperties mass{};
        Vec3 r_dot = Vec3::Zero();
        Vec3 omega_local = Vec3::Zero();
        std::string_view colour{};
        std::vector<Shape> shapes{};
    };
    /// @return its index
    int add(const Part& part);
    void look_of_ground(const std::vector<Shape>& shapes);

    // axes are the same in the frames of both bodies; returned for their index in the order
    void hinge(const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& axis);
    void ball(const std::string& name, const BodyPoint& i, const BodyPoint& j);
    void slide(const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& axis);
    void cross(
        const std::string& name, const BodyPoint& i, const BodyPoint& j, const Vec3& arm_i,
        const Vec3& arm_j);
    /// Words at the joint added last.
    void say(const std::string& text);

    /// Claims after everything has been put together: equations, rank, and that it is assembled.
    void claim(int rows, int rank, int dof, const std::string& why = {});

    /// A claim about a quantity during the motion; `why` derives the value, in SI and radians.
    void prove(double t, const std::string& name, double value, double tolerance, const std::string& why);

    DynamicsPlan& plan() { return *lesson.dynamics; }

    Lesson lesson;

private:
    Joint& add_joint(std::string_view type, const std::string& name, const BodyPoint& i, const BodyPoint& j);
};

}  // namespace jw::test
