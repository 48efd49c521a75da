#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <sstream>

#include "core/jets/euler_parameters.hpp"
#include "tests/lessons/support.hpp"

using namespace jw;
using test::is_near;
using test::kRounding;
using test::lesson_of;
using test::with_two_bodies;

namespace {

const double kHalf = std::sqrt(0.5);

Body body_with(const std::string& keys) {
    const Lesson lesson = lesson_of("format = 1\ntitle = \"t\"\n[[body]]\nname = \"b\"\n" + keys + "\n");
    REQUIRE(lesson.mechanism.bodies.size() == 2);
    return lesson.mechanism.bodies[1];
}

const std::string kHinge =
    "[[joint]]\nname = \"j\"\ntype = \"cylindrical\"\nbodies = [\"base\", \"arm\"]\nat = [0, 0, 0]\n"
    "axis = [0, 0, 1]\n";

Driver driver_with(const std::string& keys) {
    const Lesson lesson = lesson_of(with_two_bodies(kHinge + "[[driver]]\nname = \"d\"\n" + keys + "\n"));
    REQUIRE(lesson.mechanism.drivers.size() == 1);
    return lesson.mechanism.drivers[0];
}

Claim claim_with(const std::string& keys) {
    const Lesson lesson = lesson_of(with_two_bodies(
        kHinge + "[[driver]]\nname = \"d\"\nquantity = \"angle\"\njoint = \"j\"\npolynomial_deg = [0]\n" +
        "[motion]\nto_s = 2\n[[expect]]\n" + keys + "\n"));
    REQUIRE(lesson.claims.size() == 1);
    return lesson.claims[0];
}

}  // namespace

TEST_CASE("The complete lesson of the documentation reads as it is described", "[lessons][reading]") {
    const Lesson lesson = lesson_of(test::documented_lesson());
    CHECK(lesson.title == "The slider-crank counts twice");
    CHECK(lesson.chapter == "loops");
    CHECK(lesson.source == "slides 8, 10");
    CHECK(lesson.text.starts_with("Four joints close a loop"));
    CHECK(!lesson.text.ends_with('\n'));

    const Mechanism& m = lesson.mechanism;
    REQUIRE(m.bodies.size() == 4);
    CHECK(m.bodies[0].name == "ground");
    CHECK(m.bodies[0].fixed);
    CHECK(m.bodies[3].name == "slider");
    CHECK(is_near(m.bodies[3].r, Vec3(0.7, 0, 0)));
    REQUIRE(m.joints.size() == 4);
    CHECK(m.joints[3].type->name == "prismatic");
    CHECK(lesson.step_texts.joints[3].starts_with("The loop closes."));
    REQUIRE(m.drivers.size() == 1);
    CHECK(m.drivers[0].function.at(1.0).f == Approx(2.0 * std::numbers::pi).margin(kRounding));
    REQUIRE(lesson.motion.has_value());
    CHECK(lesson.motion->duration == 4.0);
    CHECK(lesson.motion->steps == 120);
    CHECK(lesson.step_texts.motion == "One turn of the crank.");
    CHECK(lesson.claims.size() == 8);
    CHECK(lesson.looks[1].colour.has_value());
    REQUIRE(lesson.looks[3].shapes.size() == 1);
    CHECK(std::get<Box>(lesson.looks[3].shapes[0]).size == Vec3(0.12, 0.08, 0.08));
    CHECK(
        lesson.order == std::vector<Addition>{
                            {Addition::Kind::joint, 0},
                            {Addition::Kind::joint, 1},
                            {Addition::Kind::joint, 2},
                            {Addition::Kind::joint, 3},
                            {Addition::Kind::driver, 0}});
}

TEST_CASE("Every shape and function of time in the documentation reads", "[lessons][reading]") {
    const std::vector<std::string> blocks = test::documented_toml();
    std::istringstream shapes(blocks[1]);
    int count = 0;
    for (std::string line; std::getline(shapes, line); ++count) {
        INFO(line);
        CHECK(body_with(line).name == "b");
    }
    std::istringstream functions(blocks[2]);
    for (std::string line; std::getline(functions, line); ++count) {
        INFO(line);
        const bool angle = line.find("_deg = ") != std::string::npos;
        const std::string what = angle ? "angle" : "displacement";
        const Driver driver = driver_with("quantity = \"" + what + "\"\njoint = \"j\"\n" + line);
        CHECK(std::isfinite(driver.function.at(0.7).f));
    }
    CHECK(count == 12);
}

TEST_CASE("Euler parameters are used exactly as typed", "[lessons][reading]") {
    const Body body = body_with("p = [0.5001, 0.5, -0.5, 0.4998]");
    CHECK(body.p == Vec4(0.5001, 0.5, -0.5, 0.4998));
}

TEST_CASE("An orientation is the same by axis and angle and by axes", "[lessons][reading]") {
    const Vec4 quarter(kHalf, 0, 0, kHalf);
    CHECK(is_near(body_with("rotation = { axis = [0, 0, 7], angle_deg = 90 }").p, quarter));
    CHECK(is_near(body_with("rotation = { axis = [0, 0, 1], angle_rad = 1.5707963267948966 }").p, quarter));
    CHECK(is_near(body_with("rotation = { axis = [0, 0, -1], angle_deg = -90 }").p, quarter));
    CHECK(is_near(body_with("axes = { x = [0, 2, 0], y = [-3, 0, 0] }").p, quarter));
    CHECK(is_near(body_with("axes = { y = [-1, 0, 0], z = [0, 0, 1] }").p, quarter));
    CHECK(is_near(body_with("axes = { z = [0, 0, 1], x = [0, 1, 0] }").p, quarter));
    CHECK(is_near(body_with("axes = { x = [0, 1, 0], y = [-1, 0, 0], z = [0, 0, 1] }").p, quarter));
    // half a turn, where e0 = 0
    const Vec4 half = body_with("axes = { x = [1, 0, 0], y = [0, -1, 0] }").p;
    CHECK(std::abs(half.dot(Vec4(0, 1, 0, 0))) == Approx(1.0).margin(kRounding));
}

TEST_CASE("Axes typed with three digits are made orthonormal, x first", "[lessons][reading]") {
    const Mat3 A = rotation_matrix(body_with("axes = { x = [0.6, 0.8, 0], y = [-0.8, 0.6005, 0] }").p);
    CHECK((A.transpose() * A - Mat3::Identity()).cwiseAbs().maxCoeff() < kRounding);
    CHECK(is_near(A.col(0), Vec3(0.6, 0.8, 0)));
}

TEST_CASE("Velocities are read in either frame", "[lessons][reading]") {
    const std::string turned = "rotation = { axis = [0, 0, 1], angle_deg = 90 }\n";
    CHECK(body_with("velocity = [1, -2, 0.5]").r_dot == Vec3(1, -2, 0.5));
    CHECK(body_with(turned + "omega_local_rad_per_s = [1, 2, 3]").omega_local == Vec3(1, 2, 3));
    CHECK(is_near(body_with(turned + "omega_global_rad_per_s = [1, 2, 3]").omega_local, Vec3(2, -1, 3)));
    CHECK(is_near(
        body_with("omega_local_deg_per_s = [180, 0, -90]").omega_local,
        Vec3(std::numbers::pi, 0, -std::numbers::pi / 2)));
}

TEST_CASE("Polynomials, harmonics and steps add up", "[lessons][reading]") {
    const std::string angle = "quantity = \"angle\"\njoint = \"j\"\n";
    const double pi = std::numbers::pi;
    const TimeFunction polynomial = driver_with(angle + "polynomial_deg = [90, 180, -36]").function;
    CHECK(polynomial.at(0.5).f == Approx(pi * (0.5 + 0.5 - 0.05)).margin(kRounding));
    CHECK(polynomial.at(0.5).f_dot == Approx(pi * (1.0 - 0.2)).margin(kRounding));
    CHECK(driver_with(angle + "polynomial_rad = [1, 2]").function.at(3.0).f == 7.0);

    const TimeFunction harmonic =
        driver_with(angle + "harmonics = [{ amplitude_deg = 18, frequency_hz = 0.5, phase_deg = 90 }]")
            .function;
    CHECK(harmonic.at(0.0).f == Approx(0.1 * pi).margin(kRounding));
    CHECK(harmonic.at(1.0).f == Approx(-0.1 * pi).margin(kRounding));
    CHECK(harmonic.at(0.5).f_dot == Approx(-0.1 * pi * pi).margin(kRounding));

    const std::string slide = "quantity = \"displacement\"\njoint = \"j\"\n";
    const TimeFunction sum =
        driver_with(
            slide +
            "polynomial = [1]\nharmonics = [{ amplitude = 0.25, omega_rad_per_s = 2, phase_rad = 1 }]\n"
            "step = { from = 2, to = 4, start_s = 1, end_s = 3 }")
            .function;
    CHECK(sum.at(0.0).f == Approx(1.0 + 0.25 * std::sin(1.0) + 2.0).margin(kRounding));
    CHECK(sum.at(2.0).f == Approx(1.0 + 0.25 * std::sin(5.0) + 3.0).margin(kRounding));
    CHECK(sum.at(9.0).f == Approx(1.0 + 0.25 * std::sin(19.0) + 4.0).margin(kRounding));
    const TimeFunction step = driver_with(angle + "step = { to_deg = 180, end_s = 2 }").function;
    CHECK(step.at(1.0).f == Approx(pi / 2).margin(kRounding));
    CHECK(step.at(2.0).f_dot == 0.0);
}

TEST_CASE("Drivers measure angles, displacements, distances and coordinates", "[lessons][reading]") {
    const Driver angle = driver_with("quantity = \"angle\"\njoint = \"j\"\npolynomial_deg = [0]");
    CHECK(angle.joint == 0);
    CHECK(std::holds_alternative<AngleMeasure>(angle.measure));
    const Driver slide = driver_with("quantity = \"displacement\"\njoint = \"j\"\npolynomial = [0]");
    CHECK(std::get<DisplacementMeasure>(slide.measure).s_i_local == Vec3(0, 0, 1));

    const Driver local = driver_with(
        "quantity = \"distance\"\nbodies = [\"base\", \"arm\"]\npoint_i = [1, 0, 0]\npolynomial = [2]");
    CHECK(local.body_i == 1);
    CHECK(local.body_j == 2);
    CHECK(std::get<SquaredDistanceMeasure>(local.measure).P_i_local == Vec3(1, 0, 0));
    CHECK(std::get<SquaredDistanceMeasure>(local.measure).P_j_local == Vec3::Zero());
    const Driver global = driver_with(
        "quantity = \"distance\"\nbodies = [\"base\", \"arm\"]\nat = [1, 0, 0]\nto = [1, 3, 3]\n"
        "polynomial = [2]");
    CHECK(is_near(std::get<SquaredDistanceMeasure>(global.measure).P_j_local, Vec3(1, 0, 0)));

    const Driver e3 =
        driver_with("quantity = \"coordinate\"\nbody = \"arm\"\ncoordinate = \"e3\"\npolynomial = [0.7]");
    CHECK(e3.body_j == 2);
    CHECK(std::get<CoordinateMeasure>(e3.measure).coordinate == 6);
}

TEST_CASE("A driver can go on from the start pose", "[lessons][reading]") {
    const auto start_of = [](const std::string& keys) {
        return driver_with(keys + "\nfrom_start = true").function.at(0.0).f;
    };
    CHECK(std::abs(start_of("quantity = \"angle\"\njoint = \"j\"\npolynomial_deg = [0, 90]")) < kRounding);
    CHECK(
        start_of("quantity = \"coordinate\"\nbody = \"arm\"\ncoordinate = \"y\"\npolynomial = [0.5, 1]") ==
        2.5);
    CHECK(
        start_of("quantity = \"distance\"\nbodies = [\"ground\", \"arm\"]\npoint_j = [0, 0, -1]\n"
                 "harmonics = [{ amplitude = 1, frequency_hz = 1 }]") == Approx(3.0).margin(kRounding));
}

TEST_CASE("The order is the author's, and what is not named follows", "[lessons][reading]") {
    std::string text = with_two_bodies(
        kHinge + "[[driver]]\nname = \"d\"\nquantity = \"angle\"\njoint = \"j\"\npolynomial_deg = [0]\n" +
        "[[joint]]\nname = \"k\"\ntype = \"n1\"\nbodies = [\"ground\", \"arm\"]\naxis_i = [1, 0, 0]\n" +
        "axis_j = [0, 1, 0]\n");
    text.insert(text.find("[[body]]"), "order = [\"k\"]\n");
    using Kind = Addition::Kind;
    CHECK(
        lesson_of(text).order ==
        std::vector<Addition>{{Kind::joint, 1}, {Kind::joint, 0}, {Kind::driver, 0}});
}

TEST_CASE("Motion, camera and coordinates are read, defaults included", "[lessons][reading]") {
    const Lesson plain = lesson_of(with_two_bodies(""));
    CHECK(plain.coordinates == CoordinateChoice::modified_euler_parameters);
    CHECK(!plain.motion);
    CHECK(!plain.camera.from);
    CHECK(!plain.camera.orthographic);

    std::string text = with_two_bodies(
        "[motion]\nfrom_s = 0.5\nto_s = 2\n[camera]\nfrom = [0, -3, 4]\ntarget = [1, 2, 3]\ndistance = 2.5\n"
        "up = [0, 2, 0]\northographic = true\n");
    text.insert(text.find("[[body]]"), "coordinates = \"omega-global\"\n");
    const Lesson lesson = lesson_of(text);
    CHECK(lesson.coordinates == CoordinateChoice::omega_global);
    CHECK(lesson.motion->from == 0.5);
    CHECK(lesson.motion->to == 2.0);
    CHECK(lesson.motion->duration == 1.5);
    CHECK(lesson.motion->steps == 100);
    CHECK(is_near(*lesson.camera.from, Vec3(0, -0.6, 0.8)));
    CHECK(*lesson.camera.target == Vec3(1, 2, 3));
    CHECK(*lesson.camera.distance == 2.5);
    CHECK(*lesson.camera.up == Vec3(0, 1, 0));
    CHECK(lesson.camera.orthographic);
}

TEST_CASE("Words are read for every kind of step", "[lessons][reading]") {
    const Lesson lesson = lesson_of(with_two_bodies(
        kHinge + "[motion]\nto_s = 2\n[[step]]\nat = \"bodies\"\ntext = \"free\"\n" +
        "[[step]]\nat = \"j\"\ntext = \"hinge\"\n[[step]]\nat_s = 1.5\ntext = \"late\"\n" +
        "[[step]]\nat_s = 0.5\ntext = \"early\"\n[[step]]\nat = \"motion\"\ntext = \"go\"\n"));
    CHECK(lesson.step_texts.bodies == "free");
    CHECK(lesson.step_texts.joints == std::vector<Text>{"hinge"});
    CHECK(lesson.step_texts.motion == "go");
    REQUIRE(lesson.step_texts.times.size() == 2);
    CHECK(lesson.step_texts.times[0].text == "early");
    CHECK(lesson.step_texts.times[1].from == 1.5);
}

TEST_CASE("Each fact of an expectation becomes a claim with its place", "[lessons][reading]") {
    const Lesson lesson = lesson_of(with_two_bodies(
        kHinge +
        "[[expect]]\nafter = \"j\"\nrank = 4\ndof = 8\nresidual_below = 1e-9\ndropped = \"j p2 z\"\n" +
        "closes = true\nwhy = \"because\"\n"));
    REQUIRE(lesson.claims.size() == 5);
    for (const Claim& claim : lesson.claims) {
        CHECK(std::get<AfterAddition>(claim.when).count == 1);
        CHECK(claim.why == "because");
        CHECK(claim.span.line >= 15);
    }
    CHECK(std::get<CountClaim>(lesson.claims[0].fact).value == 4);
    CHECK(lesson.claims[0].span.column == 8);
    bool dropped = false;
    for (const Claim& claim : lesson.claims) {
        if (const auto* fact = std::get_if<DroppedClaim>(&claim.fact)) {
            dropped = fact->joint == 0 && fact->role == Role::distance_parallel && fact->component == 2;
        }
    }
    CHECK(dropped);
}

TEST_CASE("Claims are made for a moment", "[lessons][reading]") {
    CHECK(std::get<AtTime>(claim_with("at_s = 1.25\nrank = 5").when).t == 1.25);
    CHECK(std::holds_alternative<AsGiven>(claim_with("as_given = true\nrank = 5").when));
    CHECK(std::get<AfterAddition>(claim_with("rank = 5").when).count == 2);
    CHECK(std::get<AfterAddition>(claim_with("after = \"d\"\nrank = 5").when).count == 2);
}

TEST_CASE("Quantities of claims are resolved, in SI and radians", "[lessons][reading]") {
    const auto fact_of = [](const std::string& keys) {
        return std::get<QuantityClaim>(claim_with("at_s = 1\n" + keys).fact);
    };
    const QuantityClaim angle = fact_of("quantity = \"j.angle\"\nvalue_deg = 90\ntolerance_deg = 0.18");
    CHECK(std::holds_alternative<AngleMeasure>(std::get<MeasureQuantity>(angle.quantity).measure));
    CHECK(angle.value == Approx(std::numbers::pi / 2).margin(kRounding));
    CHECK(angle.tolerance == Approx(std::numbers::pi / 1000).margin(kRounding));
    CHECK(angle.in_degrees);
    const QuantityClaim rate =
        fact_of("quantity = \"j.angle\"\nderivative = 1\nvalue_deg_per_s = 180\ntolerance_deg_per_s = 1");
    CHECK(rate.derivative == 1);
    CHECK(rate.value == Approx(std::numbers::pi).margin(kRounding));

    const QuantityClaim point =
        fact_of("quantity = \"arm.point.y\"\npoint = [0.5, 0, 0]\nvalue = -2\ntolerance = 1e-9");
    CHECK(std::get<PointQuantity>(point.quantity).body == 2);
    CHECK(std::get<PointQuantity>(point.quantity).component == 1);
    CHECK(std::get<PointQuantity>(point.quantity).s_local == Vec3(0.5, 0, 0));
    CHECK(point.value == -2.0);

    const QuantityClaim omega =
        fact_of("quantity = \"arm.omega_local.z\"\nvalue_rad_per_s = 3\ntolerance_rad_per_s = 0.1");
    CHECK(std::get<AngularVelocityQuantity>(omega.quantity).local);
    CHECK(std::get<AngularVelocityQuantity>(omega.quantity).component == 2);
    const QuantityClaim x = fact_of("quantity = \"arm.x\"\nderivative = 2\nvalue = 1\ntolerance = 0.1");
    CHECK(x.derivative == 2);
    CHECK(std::get<CoordinateMeasure>(std::get<MeasureQuantity>(x.quantity).measure).coordinate == 0);
}

TEST_CASE("Shapes and colours are read", "[lessons][reading]") {
    const auto look_of = [](const std::string& keys) {
        return lesson_of("format = 1\ntitle = \"t\"\n[[body]]\nname = \"b\"\n" + keys + "\n").looks[1];
    };
    const Look box = look_of(
        "shape = { box = { size = [1, 2, 3], at = [0, 0, 1], axes = { x = [0, 1, 0], z = [0, 0, 1] } } }");
    CHECK(std::get<Box>(box.shapes[0]).centre == Vec3(0, 0, 1));
    CHECK(is_near(std::get<Box>(box.shapes[0]).axes.col(1), Vec3(-1, 0, 0)));
    const Look several = look_of(
        "colour = \"#ff0080\"\nshape = [{ sphere = { radius = 0.5 } }, { rod = { from = [0, 0, 0], to = [1, "
        "0, 0], "
        "radius = 0.1 } }, { cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = 0.25 } }]");
    REQUIRE(several.shapes.size() == 3);
    CHECK(std::get<Sphere>(several.shapes[0]).radius == 0.5);
    CHECK(std::get<Rod>(several.shapes[1]).to == Vec3(1, 0, 0));
    CHECK(std::get<Cylinder>(several.shapes[2]).radius == 0.25);
    CHECK(several.colour->red == 1.0);
    CHECK(several.colour->green == 0.0);
    CHECK(several.colour->blue == Approx(128.0 / 255.0));
}

TEST_CASE("A file with Windows line ends reads the same", "[lessons][reading]") {
    std::string text = test::documented_lesson();
    std::string windows;
    for (const char c : text) { windows += c == '\n' ? std::string("\r\n") : std::string(1, c); }
    const Lesson a = lesson_of(text);
    const Lesson b = lesson_of(windows);
    CHECK(a.text == b.text);
    CHECK(a.claims.size() == b.claims.size());
    CHECK(a.claims[0].span == b.claims[0].span);
}
