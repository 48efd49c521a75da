#pragma once

#include <array>
#include <functional>

#include "core/poses/typed/typed_number.hpp"
#include "lessons/read/reading.hpp"

/// The numbers of a lesson that were rounded when they were typed, and how changing them changes its joints.
namespace jw::reading {

class RoundedNumbers {
public:
    explicit RoundedNumbers(const Reading& reading) : reading_(reading) {}

    /// Points, axes, sides and lengths of the joints, in the order of the mechanism.
    void add_joints(const std::vector<Fields>& joints);
    /// Poses of bodies that have vectors in their own frame. @param joints those of the mechanism
    void add_poses(std::vector<Fields>& bodies, const std::vector<Fields>& joints);

    const std::vector<TypedNumber>& all() const { return all_; }

    /// Name and place of the number, key or kind that needs more digits: it has three times the effect of all
    /// others together.
    /// @param effects  of half a unit of each number
    /// @return  without a place if it is a kind, or several kinds
    Located<std::string> short_of_digits(const VectorX& effects) const;

private:
    using Change = TypedNumber::Change;
    /// Changes of the geometry per unit of one of the numbers of a key.
    using Changes = std::function<std::vector<Change>(Eigen::Index)>;
    /// A vector of the geometry, and the matrix that gives it from the vector that was typed.
    struct Target {
        Vec3 JointGeometry::*vector;
        Mat3 way;
    };
    /// Places of a number and of its key in the text, and their names.
    struct Place {
        SourceSpan span;
        std::string text;
        SourceSpan key;        ///< of all numbers of its key
        std::string key_name;  ///< "'axis' of revolute joint 'hinge'"
        bool is_of_pose = false;
    };
    /// How a number of a pose moves the body [m, global] and turns it [rad, local].
    struct Displacement {
        Vec3 shift = Vec3::Zero();
        Vec3 turn_local = Vec3::Zero();
    };
    /// Key of a joint that gives a vector in the frame of body i (side 0) or j (side 1).
    struct LocalKey {
        std::string_view key;
        int side;
        Vec3 JointGeometry::*vector;
    };
    static constexpr std::array<LocalKey, 6> kLocalKeys{{
        {"point_i", 0, &JointGeometry::P_i_local},
        {"point_j", 1, &JointGeometry::P_j_local},
        {"axis_i", 0, &JointGeometry::s_i_local},
        {"axis_j", 1, &JointGeometry::s_j_local},
        {"side_i", 0, &JointGeometry::h_i_local},
        {"side_j", 1, &JointGeometry::h_j_local},
    }};
    /// Vectors of a joint that were typed in the frame of a body.
    struct LocalVectors {
        int joint = 0;
        std::vector<Vec3 JointGeometry::*> vectors;
    };

    /// @param pose_of  body whose pose the table gives; empty: the table is of a joint
    void add(
        const Fields& fields, const std::string& pose_of, std::string_view key, std::size_t count,
        const Changes& changes, double by = 1.0);
    void add_joint(const Fields& fields, int joint);
    void add_axes(const Fields& fields, int joint, const Mat3& to_i, const Mat3& to_j);
    void add_vector(
        const Fields& fields, int joint, std::string_view key, const std::vector<Target>& targets,
        bool is_unit = false);
    void add_scalar(
        const Fields& fields, int joint, std::string_view key, double JointGeometry::*scalar,
        double by = 1.0);
    void add_pose(Fields& fields, int body, const std::vector<LocalVectors>& locals);
    void add_frame(
        Fields& axes, const std::string& what, const Body& body, const std::vector<LocalVectors>& locals);
    std::vector<Change> moved(
        const Body& body, const std::vector<LocalVectors>& locals, const Displacement& by) const;

    const Reading& reading_;
    std::vector<TypedNumber> all_;
    std::vector<Place> places_;  ///< one for each number
};

}  // namespace jw::reading
