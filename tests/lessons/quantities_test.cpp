#include <catch2/catch.hpp>

#include <set>

#include "core/quantity/evaluate.hpp"
#include "core/quantity/names.hpp"
#include "lessons/files/catalogue.hpp"
#include "lessons/typed/exact_text.hpp"
#include "lessons/write/writer.hpp"
#include "tests/lessons/random_lessons.hpp"
#include "tests/lessons/support.hpp"
#include "tests/support/moved_along.hpp"

using namespace jw;
using test::random_lesson;

namespace {

std::vector<Lesson> shipped_lessons() {
    std::vector<Lesson> lessons;
    for (const auto& file : lessons_below(std::filesystem::path(JW_SOURCE_ROOT) / "lessons" / "catalogue")) {
        ReadResult read = read_lesson_file(file);
        INFO(read.report());
        REQUIRE(read.lesson.has_value());
        lessons.push_back(std::move(*read.lesson));
    }
    return lessons;
}

/// Quantities of a mechanism, with one of each kind that needs points or directions.
std::vector<NamedQuantity> every_quantity(const Mechanism& mechanism) {
    std::vector<NamedQuantity> list = quantities_of(mechanism);
    const int last = static_cast<int>(mechanism.bodies.size()) - 1;
    const Vec3 a(0.1, -2.5e-7, 1.0 / 3.0);
    const Vec3 b(0.7, 0.2, -0.4);
    const std::array<Quantity, 4> parametrised{
        PointQuantity{last, a, 1}, PointSpeedQuantity{last, a}, DirectionsQuantity{0, a, last, b},
        MeasureQuantity{SquaredDistanceMeasure{a, b}, 0, last, -1, -1}};
    for (const Quantity& quantity : parametrised) {
        for (int k = 0; k <= derivatives_of(quantity); ++k) { list.push_back({quantity, k}); }
    }
    return list;
}

/// Name of the quantity that a driver prescribes.
std::string name_of_target(const Mechanism& mechanism, const Driver& driver) {
    const MeasureQuantity target{driver.measure, driver.body_i, driver.body_j, driver.joint, -1};
    return name_of(target, 0, mechanism);
}

/// `text` of a written lesson, its drivers with the name of a quantity in place of the keys for one.
std::string with_named_targets(const std::string& text, const Mechanism& mechanism) {
    const std::set<std::string> replaced{"joint", "bodies", "point_i", "point_j",
                                         "at",    "to",     "body",    "coordinate"};
    std::istringstream lines(text);
    std::string out;
    std::size_t next = 0;
    bool in_driver = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("[")) { in_driver = line == "[[driver]]"; }
        const std::string key = line.substr(0, line.find(' '));
        if (in_driver && replaced.contains(key)) { continue; }
        if (in_driver && key == "quantity") {
            line = "quantity = " + writing::string_text(name_of_target(mechanism, mechanism.drivers[next++]));
        }
        out += line + '\n';
    }
    CHECK(next == mechanism.drivers.size());
    return out;
}

/// Checks that every name belongs to one quantity only, and is read back as that quantity.
void check_names(const Mechanism& mechanism) {
    std::set<std::string> names;
    for (const NamedQuantity& named : every_quantity(mechanism)) {
        const std::string name = name_of(named.quantity, named.derivative, mechanism);
        INFO(name);
        CHECK(names.insert(name).second);
        const std::optional<ReadName> read = read_name(name, mechanism);
        REQUIRE(read.has_value());
        CHECK(read->named.derivative == named.derivative);
        CHECK(read->named.quantity.index() == named.quantity.index());
        CHECK(name_of(read->named.quantity, read->named.derivative, mechanism) == name);
        CHECK(read->name_of_today.empty());
        CHECK_FALSE(read->wants_point);
    }
}

/// Any motion through the start pose: rates are asked for wherever it leads.
struct AnyPath {
    AnyPath(const Lesson& lesson, unsigned seed) : start(start_state(lesson.mechanism)) {
        test::Random random(seed);
        velocity = zero_motion(lesson.mechanism);
        acceleration = velocity;
        for (std::size_t b = 0; b < start.r.size(); ++b) {
            start.p[b].normalize();
            if (lesson.mechanism.bodies[b].fixed) { continue; }
            velocity.r_dot[b] = random.vector();
            velocity.omega_local[b] = random.vector();
            acceleration.r_dot[b] = random.vector();
            acceleration.omega_local[b] = random.vector();
        }
        for (std::size_t k = 0; k < start.theta.size(); ++k) {
            velocity.theta_dot[k] = random.number();
            acceleration.theta_dot[k] = random.number();
        }
        auto own = std::make_shared<System>(lesson.mechanism, everything(lesson.mechanism));
        own->choose_rows(start);
        system = own;
        if (lesson.dynamics) {
            scene = std::make_shared<const Centroidal>(centroidal(lesson.mechanism, lesson.dynamics->loads));
        }
    }

    Instant at(double t) const {
        Instant instant;
        // functions of time may begin at 0, with a corner in their second derivative
        constexpr double under_way = 0.37;
        instant.t = under_way + t;
        instant.system = system;
        instant.scene = scene;
        instant.state = test::moved_along(start, velocity, acceleration, t);
        for (Vec4& p : instant.state.p) { p.normalize(); }
        instant.velocity = velocity;
        for (std::size_t b = 0; b < start.r.size(); ++b) {
            instant.velocity.r_dot[b] += t * acceleration.r_dot[b];
            instant.velocity.omega_local[b] += t * acceleration.omega_local[b];
        }
        for (std::size_t k = 0; k < start.theta.size(); ++k) {
            instant.velocity.theta_dot[k] += t * acceleration.theta_dot[k];
        }
        instant.acceleration = acceleration;
        return instant;
    }

    State start;
    Motion velocity;
    Motion acceleration;
    std::shared_ptr<const System> system;
    std::shared_ptr<const Centroidal> scene;
};

/// True except for reactions, ranks and conditions, which take long at poses that are not assembled.
bool has_derivatives(const Quantity& quantity) { return derivatives_of(quantity) > 0; }

void check_derivatives(const Lesson& lesson, unsigned seed) {
    const AnyPath path(lesson, seed);
    for (const NamedQuantity& named : every_quantity(lesson.mechanism)) {
        if (named.derivative > 0 || !has_derivatives(named.quantity)) { continue; }
        if (needs_masses(named.quantity) && !path.scene) { continue; }
        INFO(name_of(named.quantity, 0, lesson.mechanism) << " of " << lesson.title);
        const auto value_at = [&](double t) { return evaluate(named.quantity, path.at(t)).value(); };
        const QuantityValue now = evaluate(named.quantity, path.at(0.0));
        REQUIRE_FALSE(std::isnan(now.value()));
        double largest = 0.0;
        for (const double t : {-4e-3, 0.0, 4e-3}) { largest = std::max(largest, std::abs(value_at(t))); }
        if (now.absences[1] != Absence::none) { continue; }  // a corner, or an equation without a row
        // a size has a corner at 0, and large derivatives near it
        if (std::holds_alternative<BodySizeQuantity>(named.quantity) && now.value() < 0.1) { continue; }
        // a jump of an angle by a turn between two of the moments is not a rate
        if (is_modulo_turn(named.quantity) && largest > 3.0) { continue; }
        const double rate = test::rate_by_difference(value_at);
        const double size = std::max({1.0, largest, std::abs(now.rate())});
        // thirty times what moved_along promises for sizes of 1 to 10: functions of time are up to 30 Hz.
        // Stiff springs have larger derivatives: differences over twice the interval are 16 times as far off
        // and show by how much
        const double coarse = 0.5 * test::rate_by_difference([&](double t) { return value_at(2.0 * t); });
        CHECK(std::abs(rate - now.rate()) < 1e-6 * size + 0.1 * std::abs(coarse - rate));
        if (derivatives_of(named.quantity) < 2 || now.absences[2] != Absence::none) { continue; }
        const double acceleration = test::acceleration_by_difference(value_at);
        CHECK(std::abs(acceleration - now.acceleration()) < 1e-4 * std::max(size, std::abs(acceleration)));
    }
}

}  // namespace

TEST_CASE("Every quantity of every shipped lesson has a name of its own", "[lessons][quantities]") {
    for (const Lesson& lesson : shipped_lessons()) {
        INFO(lesson.file_name);
        check_names(lesson.mechanism);
    }
}

TEST_CASE("Every quantity of random lessons has a name of its own", "[lessons][quantities]") {
    for (unsigned seed = 0; seed < 12; ++seed) { check_names(random_lesson(seed).mechanism); }
}

TEST_CASE("Rates and accelerations of shipped lessons are differences", "[lessons][quantities]") {
    unsigned seed = 0;
    for (const Lesson& lesson : shipped_lessons()) {
        if (lesson.mechanism.bodies.size() < 6) { check_derivatives(lesson, ++seed); }
    }
}

TEST_CASE("Every joint that is free to turn or to shift has that measure", "[lessons][quantities]") {
    const Mechanism mechanism = random_lesson(1).mechanism;
    const auto is_there = [&](const std::string& name) { return read_name(name, mechanism).has_value(); };
    for (const Joint& joint : mechanism.joints) {
        INFO(joint.name);
        CHECK(is_there(joint.name + ".angle") == (joint.type->has_angle() || joint.type->artificial > 0));
        CHECK(is_there(joint.name + ".displacement") == joint.type->has_displacement());
        CHECK(is_there(joint.name + ".distance") == joint.type->uses(Role::length));
    }
    CHECK(is_there("the planar.angle"));
    CHECK(is_there("the p1.angle"));
    CHECK(is_there("the p2.displacement"));
}

TEST_CASE("Names of before are read as those of today", "[lessons][quantities]") {
    const Mechanism mechanism = random_lesson(1).mechanism;
    const auto today = [&](const std::string& name) {
        const std::optional<ReadName> read = read_name(name, mechanism);
        return read ? read->name_of_today : "nothing";
    };
    CHECK(today("j.r.x") == "j.x");
    CHECK(today("j.x rate") == "j.r_dot.x");
    CHECK(today("the revolute.angle rate") == "the revolute.angle_dot");
    CHECK(today("the revolute.angle acceleration") == "the revolute.angle_ddot");
    CHECK(today("the screw.theta_dot") == "the screw.angle_dot");
    CHECK(today("j.point speed") == "j.point.speed");
    CHECK(today("kinetic_J") == "energy.kinetic");
    CHECK(today("j.x") == "");
    CHECK(today("j.w") == "nothing");
    CHECK(today("nobody.x") == "nothing");
    CHECK(today("j.point[1 2].x") == "nothing");
    CHECK(today("j.angle[0 0 0].i[1 0 0]") == "nothing");
}

TEST_CASE("A driver's target by name is the one by keys", "[lessons][quantities]") {
    std::set<std::size_t> measures;
    std::vector<Lesson> lessons = shipped_lessons();
    for (unsigned seed = 0; seed < 200; ++seed) { lessons.push_back(random_lesson(seed)); }
    for (const Lesson& lesson : lessons) {
        INFO(lesson.title);
        const std::string by_keys = lesson_text(lesson);
        const ReadResult read = read_lesson(with_named_targets(by_keys, lesson.mechanism), "by-name.toml");
        INFO(read.report());
        REQUIRE(read.lesson.has_value());
        CHECK(lesson_text(*read.lesson) == by_keys);
        for (const Driver& driver : lesson.mechanism.drivers) { measures.insert(driver.measure.index()); }
    }
    CHECK(measures.size() == std::variant_size_v<Measure>);
}

TEST_CASE("A quantity that no driver can prescribe is refused", "[lessons][quantities]") {
    const std::string joints =
        "[[joint]]\nname = \"pin\"\ntype = \"cylindrical\"\nbodies = [\"base\", \"arm\"]\nat = [0, 0, 0]\n"
        "axis = [0, 0, 1]\n";
    const auto report_of = [&](const std::string& quantity) {
        std::string text = test::with_two_bodies(joints);
        text.insert(text.find("name = \"base\"\n"), "fixed = true\n");
        text += "[[driver]]\nname = \"motor\"\nquantity = \"" + quantity + "\"\npolynomial" +
                (quantity.find("angle") == std::string::npos ? "" : "_deg") + " = [1, 2]\n";
        return read_lesson(text, "test.toml").report();
    };
    for (const char* const right :
         {"pin.angle", "pin.displacement", "arm.x", "arm.e3", "base.distance[0 0 0].arm[1 0 0]"}) {
        CHECK(report_of(right) == "");
    }
    const auto says = [&](const std::string& quantity, const std::string& words) {
        const std::string report = report_of(quantity);
        INFO(report);
        CHECK(report.find("test.toml:18:12: error: ") != std::string::npos);
        CHECK(report.find(words) != std::string::npos);
    };
    says("pin.angle_dot", "no driver can prescribe 'pin.angle_dot'; expected the angle or displacement");
    says("energy.sum", "needs masses and forces");
    says("arm.omega.z", "no driver can prescribe 'arm.omega.z'");
    says("base.x", "body 'base' is fixed; expected one that moves");
    says("arm.distance[0 0 0].arm[1 0 0]", "belong to one body");
    says("pen.angle", "is not a quantity; expected NAME.WHAT");
    says("pin.speed", "is not a quantity of joint 'pin'");
    says("speed", "one of");
}

TEST_CASE("Distances and angles between bodies are what geometry says", "[lessons][quantities]") {
    Lesson lesson = test::lesson_of(test::with_two_bodies(""));
    const AnyPath path(lesson, 1);
    const auto value_of = [&](const std::string& name) {
        return evaluate(read_name(name, lesson.mechanism)->named.quantity, path.at(0.0)).value();
    };
    // arm stands at (1, 2, 3), turned by 90 deg about z
    CHECK(value_of("base.distance[0 0 0].arm[0 0 0]") == Approx(std::sqrt(14.0)));
    CHECK(value_of("base.angle[1 0 0].arm[0 1 0]") == Approx(std::numbers::pi));
    CHECK(value_of("base.angle[2 0 0].arm[1 0 0]") == Approx(0.5 * std::numbers::pi));
    CHECK(value_of("arm.point[1 0 0].y") == Approx(3.0));
}

TEST_CASE("Every row of the table of quantities is a name", "[lessons][quantities]") {
    const std::string page = test::text_of_file("docs/quantities.md");
    Mechanism mechanism = random_lesson(1).mechanism;
    mechanism.bodies[1].name = "crank";
    mechanism.bodies[2].name = "rocker";
    for (Joint& joint : mechanism.joints) {
        if (joint.type->name == "revolute") { joint.name = "hinge"; }
        if (joint.type->name == "cylindrical") { joint.name = "slide"; }
        if (joint.type->name == "distance") { joint.name = "link"; }
    }
    mechanism.drivers.back().name = "drive";
    std::set<std::size_t> kinds;
    int rows = 0;
    std::istringstream lines(page);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("## Names of before")) { break; }
        if (!line.starts_with("| `")) { continue; }
        const std::string cell = line.substr(2, line.find(" | ") - 2);
        ++rows;
        for (std::size_t at = cell.find('`'); at != std::string::npos; at = cell.find('`', at)) {
            const std::size_t end = cell.find('`', at + 1);
            std::string name = cell.substr(at + 1, end - at - 1);
            // in a table a bar is written with a backslash
            std::erase(name, '\\');
            INFO(name);
            at = end + 1;
            const std::optional<ReadName> read = read_name(name, mechanism);
            REQUIRE(read.has_value());
            CHECK(read->name_of_today.empty());
            kinds.insert(read->named.quantity.index());
        }
    }
    CHECK(rows > 12);
    CHECK(kinds.size() == std::variant_size_v<Quantity>);
}

TEST_CASE("Claims that nothing can judge are refused with their place", "[lessons][quantities]") {
    const auto report_of = [](const std::string& claim, bool masses) {
        std::string text = test::with_two_bodies(
            "[[joint]]\nname = \"pin\"\ntype = \"revolute\"\nbodies = [\"base\", \"arm\"]\nat = [0, 0, 0]\n"
            "axis = [0, 0, 1]\n");
        if (masses) {
            for (const char* body : {"name = \"base\"\n", "name = \"arm\"\n"}) {
                text.insert(text.find(body) + std::string(body).size(), "mass = 1\ninertia = [1, 1, 1]\n");
            }
            text += "[dynamics]\nduration = 2\n";
        }
        return read_lesson(text + "[[expect]]\n" + claim, "test.toml").report();
    };
    const std::string value = "value = 1\ntolerance = 1\n";
    CHECK(report_of("at_s = 1\nquantity = \"energy.sum\"\n" + value, true) == "");
    CHECK(report_of("at_s = 2\nquantity = \"pin.force.x\"\n" + value, true) == "");
    const auto says = [&](const std::string& claim, bool masses, const std::string& words) {
        const std::string report = report_of(claim, masses);
        INFO(report);
        CHECK(report.find("test.toml:") != std::string::npos);
        CHECK(report.find(words) != std::string::npos);
    };
    says(
        "quantity = \"energy.sum\"\n" + value, false, "needs masses and forces; expected a table [dynamics]");
    says("quantity = \"energy.som\"\n" + value, true, "is not a quantity; expected energy.kinetic");
    says(
        "quantity = \"pin.force.x\"\n" + value, true,
        "reactions belong to a motion or an equilibrium; expected 'at_s' or 'at_rest'");
    CHECK(report_of("at_rest = true\nquantity = \"pin.force.x\"\n" + value, true) == "");
    says("at_rest = true\nquantity = \"pin.angle_dot\"\n" + value, true, "nothing moves at rest");
    says("at_rest = true\ncloses = true\n", true, "'closes' cannot be claimed of an equilibrium");
    says("at_rest = true\ncloses = true\n", false, "no forces lead to an equilibrium; expected masses");
    says("stable = true\n", true, "expected 'at_rest = true' beside 'stable'");
    says("at_s = 3\nquantity = \"energy.sum\"\n" + value, true, "from 0 to 'duration' of [dynamics]");
    says("at_s = 1\nof = \"motion\"\nquantity = \"energy.sum\"\n" + value, true, "of [motion]");
    says("quantity = \"arm.r_dot.x\"\n" + value, true, "nothing moves before the motion");
    says("quantity = \"arm.r.x\"\n" + value, true, "'arm.r.x' is now called 'arm.x'");
    says("quantity = \"arm.point.x\"\n" + value, true, "point");
}
