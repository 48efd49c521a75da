#include <catch2/catch.hpp>

#include <map>
#include <set>

#include "jointwise/analysis.hpp"
#include "jointwise/lesson.hpp"
#include "tests/support/typed_door.hpp"

namespace jointwise::test {
namespace {

/// A joint as a table of a lesson and as the call that makes the same.
struct Case {
    std::string type;
    std::string keys;
    Place place;
};

const Vector3 kAt{0.3, -0.2, 0.5};
const Vector3 kTo{0.7, 0.4, 0.1};
const Vector3 kAxis{0.6, 0.0, 0.8};
const Vector3 kAcross{-0.8, 0.0, 0.6};
const std::string kOneAt = "at = [0.3, -0.2, 0.5]\n";
const std::string kTwo = kOneAt + "to = [0.7, 0.4, 0.1]\n";
const std::string kOneAxis = "axis = [0.6, 0.0, 0.8]\n";
const std::string kArms = kOneAxis + "axis2 = [-0.8, 0.0, 0.6]\n";
const std::string kSide = "side = [-0.8, 0.0, 0.6]\n";

std::vector<Case> cases() {
    const Place point{.at = kAt};
    const Place pin{.at = kAt, .axis = kAxis, .side = kAcross};
    const Place arms{.at = kAt, .axis = kAxis, .axis2 = kAcross};
    const Place rod{.at = kAt, .to = kTo};
    const Place slide{.at = kAt, .to = kTo, .axis = kAxis, .side = kAcross};
    const Place crossed{.at = kAt, .to = kTo, .axis = kAxis, .axis2 = kAcross};
    Place thread = slide;
    thread.pitch = 0.2;
    const Place wheels{.at = kAt, .to = kTo, .axis = kAxis, .ratio = -1.5};
    const Place curve{
        .at = kAt,
        .to = kTo,
        .curve = {{1.0, 0.0, 0.0}, {0.0, 1.5, 0.2}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}}};
    const Place rack{.at = kAt, .to = kTo, .axis = kAxis, .axis2 = kAcross, .radius = 0.3};
    const Place bevel{.at = kAt, .to = kTo, .axis = kAxis, .axis2 = kAcross, .ratio = 2.0};
    return {
        {"spherical", kOneAt, point},
        {"s", kOneAt, point},
        {"universal", kOneAt + kArms, arms},
        {"revolute", kOneAt + kOneAxis + kSide, pin},
        {"fixed", kOneAt + kOneAxis + kSide, pin},
        {"cylindrical", kTwo + kOneAxis + kSide, slide},
        {"prismatic", kTwo + kOneAxis + kSide, slide},
        {"screw", kTwo + kOneAxis + kSide + "pitch = 0.2\n", thread},
        {"planar", kTwo + kOneAxis + kSide, slide},
        {"distance", kTwo, rod},
        {"universal-spherical", kTwo, rod},
        {"n1", kArms, arms},
        {"n2", kTwo + kOneAxis, slide},
        {"point-in-plane", kTwo + kOneAxis, slide},
        {"p1", kOneAxis + kSide, pin},
        {"p2", kTwo + kOneAxis, slide},
        {"point-on-line", kTwo + kOneAxis, slide},
        {"revolute-spherical", kTwo + kOneAxis, slide},
        {"revolute-revolute", kTwo + kOneAxis + kSide, slide},
        {"revolute-revolute-crossed", kTwo + kArms, crossed},
        {"gear", kTwo + kOneAxis + "ratio = -1.5\n", wheels},
        {"belt", kTwo + kOneAxis + "ratio = -1.5\n", wheels},
        {"bevel-gear", kTwo + kArms + "ratio = 2\n", bevel},
        {"curve", kTwo + "curve = { points = [[1, 0, 0], [0, 1.5, 0.2], [-1, 0, 0], [0, -1, 0]] }\n", curve},
        {"rack", kTwo + kArms + "radius = 0.3\n", rack},
    };
}

const std::string kBodies = R"(format = 1
title = "Two bodies"
[[body]]
name = "one"
position = [0.1, 0.2, 0.3]
p = [0.8, 0.0, 0.6, 0.0]
[[body]]
name = "two"
position = [0.9, -0.4, 0.6]
p = [0.5, 0.5, -0.5, 0.5]
)";

Mechanism built(const Case& c) {
    Mechanism m;
    m.add_body("one", {0.1, 0.2, 0.3}, {0.8, 0.0, 0.6, 0.0});
    m.add_body("two", {0.9, -0.4, 0.6}, {0.5, 0.5, -0.5, 0.5});
    m.add_joint("joint", c.type, 1, 2, c.place);
    return m;
}

/// A pose that is not assembled, so that every term counts.
Pose moved(Pose pose) {
    pose.r[1] += Vector3(0.02, -0.03, 0.05);
    pose.p[2] = (pose.p[2] + Vector4(0.03, 0.05, -0.02, 0.04)).normalized();
    return pose;
}

/// A joint of a lesson against one that the library built.
void check_same_equations(const Case& c, const std::string& type, const std::string& keys) {
    const Lesson lesson = read_lesson_text(
        kBodies + "[[joint]]\nname = \"joint\"\ntype = \"" + type + "\"\nbodies = [\"one\", \"two\"]\n" +
        keys);
    const Mechanism& read = lesson.mechanism();
    const Mechanism own = built(c);
    Rates rates = start_rates(own);
    rates.omega_local[1] = {0.7, -0.4, 0.9};
    rates.r_dot[2] = {0.3, 0.2, -0.6};
    const Pose pose = moved(start_pose(own));
    for (const Coordinates coordinates :
         {Coordinates::true_euler_parameters, Coordinates::modified_euler_parameters,
          Coordinates::omega_local, Coordinates::omega_global}) {
        const Equations a = equations_at(own, pose, rates, coordinates);
        const Equations b = equations_at(read, pose, rates, coordinates);
        REQUIRE(a.rows.size() == b.rows.size());
        if (type == c.type) { CHECK(a.rows == b.rows); }
        // the same vectors, turned into the bodies by the same few products: rounding of numbers about 1
        CHECK((a.phi - b.phi).cwiseAbs().maxCoeff() < 1e-14);
        CHECK((a.jacobian - b.jacobian).cwiseAbs().maxCoeff() < 1e-14);
        CHECK((a.gamma - b.gamma).cwiseAbs().maxCoeff() < 1e-14);
    }
}

}  // namespace

TEST_CASE("Every joint built by the library has the equations of the same joint in a lesson", "[api]") {
    std::set<std::string> asked;
    for (const Case& c : cases()) {
        CAPTURE(c.type);
        asked.insert(c.type);
        check_same_equations(c, c.type, c.keys);
    }
    const std::vector<std::string> all = joint_types();
    CHECK(asked == std::set<std::string>(all.begin(), all.end()));
}

TEST_CASE("A formula that a lesson writes has the equations of the joint that it spells out", "[api]") {
    // the square of the distance from kAt to kTo is 0.68
    const std::map<std::string, std::string> spelt{
        {"distance", kTwo + "formula = '\\mathbf{d}^T \\mathbf{d} = 0.68'\n"},
        {"n2", kTwo + kOneAxis + "formula = '\\mathbf{s}_i^T \\mathbf{d}'\n"},
        {"point-in-plane",
         kTwo + kOneAxis + "formula = '\\mathbf{s}_i \\cdot \\mathbf{r}_j^P = s_i^T r_i^P'\n"}};
    for (const Case& c : cases()) {
        if (!spelt.contains(c.type)) { continue; }
        CAPTURE(c.type);
        check_same_equations(c, "formula", spelt.at(c.type));
    }
}

TEST_CASE("Numbers of the library are exact, those of a lesson are known to their digits", "[api]") {
    // two hinges on one axis, to five digits
    const Vector3 axis{0.21822, 0.43644, 0.87287};
    Mechanism own;
    const int door = own.add_body("door", Vector3::Zero());
    own.add_joint("lower", "revolute", 0, door, {.at = Vector3::Zero(), .axis = axis});
    own.add_joint("upper", "revolute", 0, door, {.at = Vector3{0.5, 1.0, 2.0}, .axis = axis});
    CHECK(rank_at(own, start_pose(own)).rank == 6);

    const std::string text = jw::test::typed_door();
    const Lesson lesson = read_lesson_text(text);
    CHECK(rank_at(lesson.mechanism(), start_pose(lesson.mechanism())).rank == 5);
    const Lesson exact = read_lesson_text(text + "[precision]\nexact = true\n");
    CHECK(rank_at(exact.mechanism(), start_pose(exact.mechanism())).rank == 6);
}

}  // namespace jointwise::test
