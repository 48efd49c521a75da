#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "tests/app/session/catalogue_lessons.hpp"
#include "tests/app/session/picture_lessons.hpp"

namespace jw::test {

using namespace picture;

TEST_CASE("shapes of a lesson stand where the body's frame puts them", "[app][picture]") {
    Lesson lesson = one_joint("revolute");
    const Vec3 centre(0.1, -0.2, 0.3);
    lesson.looks[1].shapes = {Sphere{centre, 0.05}, Box{Vec3(0.2, 0.4, 0.6), centre}};
    lesson.looks[1].colour = Colour{0.5, 0.25, 0.75};
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const State& state = story.steps().front().state;
    const Picture picture = picture_of(story, style, 0);

    const Vec3 expected = state.r[1] + rotation_matrix(state.p[1]) * centre;
    int found = 0;
    for (const render::Shape& shape : picture.scene.shapes) {
        if (shape.colour != render::Colour{0.5F, 0.25F, 0.75F, 1.0F}) { continue; }
        ++found;
        if (const auto* sphere = std::get_if<render::Sphere>(&shape.geometry)) {
            CHECK((sphere->centre - expected).norm() < 1e-14);  // rounding of A s' + r
            CHECK(sphere->radius == 0.05);
        } else {
            const auto& box = std::get<render::Box>(shape.geometry);
            CHECK((box.pose.r - expected).norm() < 1e-14);
            CHECK((box.pose.A - rotation_matrix(state.p[1])).norm() < 1e-14);
            CHECK(box.half_size == Vec3(0.1, 0.2, 0.3));
        }
    }
    CHECK(found == 2);
}

TEST_CASE("the glyph of every joint is at the joint and alone is highlighted", "[app][picture]") {
    for (const JointType& type : kJointTypes) {
        INFO(type.name);
        const Lesson lesson = one_joint(type.name);
        const Story story(lesson);
        const PictureStyle style = picture_style(story);
        CHECK(highlighted(picture_of(story, style, 0)).empty());

        const Picture picture = picture_of(story, style, first_of(story, Step::Kind::equations));
        const std::vector<render::Shape> glyph = highlighted(picture);
        const bool bare = type.glyph == JointGlyph::none;  // nothing but vectors
        CHECK(glyph.empty() == bare);
        CHECK(is_finite(picture));
        if (bare) { continue; }
        const render::Bounds bounds = bounds_of(glyph);
        if (type.has_own_coordinate()) {
            // wheels reach from one centre to the other, a curve goes far from its bead
            const Vec3 P_j = placed(lesson.mechanism, 0, story.steps().front().state).P_j;
            CHECK(((P_j - bounds.lowest()).array() > 0.0).all());
            CHECK(((bounds.highest() - P_j).array() > 0.0).all());
            continue;
        }
        const double room = type.has_distance() ? 0.25 : 0.0;  // from the middle of the rod to its end
        CHECK((bounds.centre() - kPoint).norm() < room + 0.06 * style.unit);
        CHECK(bounds.diagonal() < 2.0 * room + 0.3 * style.unit);
    }
}

TEST_CASE("a picture names the vectors that the joint's equations use", "[app][picture]") {
    const auto picture = [](std::string_view type) {
        Lesson lesson = one_joint(type);
        // apart, so that there is a d
        lesson.mechanism.bodies[1].r += Vec3(0.2, 0.1, -0.1);
        const Story story(lesson);
        return picture_of(story, picture_style(story), first_of(story, Step::Kind::equations));
    };
    const Picture spherical = picture("spherical");
    CHECK(has_text(spherical, "P_i"));
    CHECK(has_text(spherical, "P_j"));
    CHECK_FALSE(has_text(spherical, "\\mathbf{s}_i"));

    const Picture revolute = picture("revolute");
    CHECK(has_text(revolute, "\\mathbf{s}_i"));
    CHECK(has_text(revolute, "\\mathbf{s}_j"));
    CHECK_FALSE(has_text(revolute, "\\mathbf{d}"));

    const Picture prismatic = picture("prismatic");
    CHECK(has_text(prismatic, "\\mathbf{d}"));
    CHECK(has_text(prismatic, "\\mathbf{h}_i"));
    CHECK(has_text(prismatic, "\\mathbf{h}_j"));
    CHECK(has_text(prismatic, "B_i"));

    const Picture screw = picture("screw");
    CHECK(has_text(screw, "\\mathbf{u}_i"));
    CHECK(has_text(screw, "\\mathbf{u}_j"));
    CHECK(has_text(picture("n2"), "\\mathbf{d}"));
    CHECK_FALSE(has_text(picture("n2"), "\\mathbf{s}_j"));
    CHECK(has_text(picture("distance"), "\\mathbf{d}"));
}

TEST_CASE("closed points carry one name, parallel vectors do not hide each other", "[app][picture]") {
    const Lesson lesson = one_joint("revolute");
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const Picture picture = picture_of(story, style, first_of(story, Step::Kind::assembled));
    CHECK(has_text(picture, "P"));
    CHECK_FALSE(has_text(picture, "P_i"));
    REQUIRE(picture.scene.arrows.size() == 2);
    const render::Arrow& s_i = picture.scene.arrows[0];
    const render::Arrow& s_j = picture.scene.arrows[1];
    const Vec3 apart = s_j.from - s_i.from;
    // side by side on the picture, with more than their own thickness between them
    CHECK(apart.norm() > 2.0 * (s_i.radius + s_j.radius));
    CHECK(std::abs(apart.dot(style.view)) < 1e-9 * style.unit);
    CHECK((s_i.to - s_i.from).normalized().cross((s_j.to - s_j.from).normalized()).norm() < 1e-9);
}

TEST_CASE("joints appear when they are added and only the new one is highlighted", "[app][picture]") {
    const Lesson lesson = chain();
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const auto glyph_at = [&](int index, int joint) {
        const Step& step = story.steps()[static_cast<std::size_t>(index)];
        const Vec3 P = placed(lesson.mechanism, joint, step.state).P_i;
        const Picture picture = picture_of(story, style, index);
        // only pins and balls have the colour of steel
        return std::ranges::any_of(picture.scene.shapes, [&](const render::Shape& shape) {
            return shape.colour == render::palette::kSteel &&
                   (bounds_of({shape}).centre() - P).norm() < 1e-6 * style.unit;
        });
    };
    for (int k = 0; k < static_cast<int>(story.steps().size()); ++k) {
        const int present = story.steps()[static_cast<std::size_t>(k)].additions;
        INFO("step " << k);
        for (int joint = 0; joint < 3; ++joint) { CHECK(glyph_at(k, joint) == (joint < present)); }
    }
}

TEST_CASE("a driven angle is an arc from u_i to u_j", "[app][picture]") {
    Lesson lesson = crank();
    lesson.mechanism.drivers.front().function.polynomial = {1.0};
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const Picture picture = picture_of(story, style, story.last_assembled());
    CHECK(has_text(picture, "θ"));
    CHECK_FALSE(has_text(picture, "\\mathbf{s}_i"));
    const auto& arc = picture.scene.polylines.front().points;
    const Vec3 centre = picture.scene.arrows[1].from;  // foot of u_i; arrow 0 is the head of the arc
    double length = 0.0;
    for (std::size_t k = 1; k < arc.size(); ++k) { length += (arc[k] - arc[k - 1]).norm(); }
    const double radius = (arc.front() - centre).norm();
    // 1 %: with 72 chords per turn an arc is too short by less than 0.1 %; the feet of u are a little apart
    CHECK(length == Approx(radius * 1.0).epsilon(0.01));
}

TEST_CASE("while everything moves a point leaves its path and no joint is highlighted", "[app][picture]") {
    const Lesson lesson = crank();
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const int last = static_cast<int>(story.steps().size()) - 1;
    const int first = first_of(story, Step::Kind::motion);
    const Picture picture = picture_of(story, style, last);
    CHECK(highlighted(picture).empty());
    REQUIRE(picture.scene.polylines.size() == 1);
    CHECK(picture.scene.polylines.front().points.size() == static_cast<std::size_t>(last - first + 1));
    CHECK(style.traced_body == 1);
    // a circle about the axis
    for (const Vec3& point : picture.scene.polylines.front().points) {
        const Vec3& start = picture.scene.polylines.front().points.front();
        CHECK((point - kPoint).cross(kAxis).norm() == Approx((start - kPoint).cross(kAxis).norm()));
    }
}

TEST_CASE(
    "vectors and formulas of one or two joints made of vectors alone stay while they move",
    "[app][picture]") {
    const auto [name, wanted] = GENERATE(table<std::string, std::vector<std::string>>(
        {{"vectors/perpendicular-vectors", {"n1", "n2"}}, {"parallel/parallel-vectors", {"p1", "p2"}}}));
    const Lesson lesson = lesson_named(name);
    const Story story(lesson);
    const int moment = first_of(story, Step::Kind::motion) + 3;
    const Picture picture = picture_of(story, picture_style(story), moment);
    const View view = view_of(story, moment);
    for (const std::string& joint_name : wanted) {
        CAPTURE(name, joint_name);
        const auto joint = std::ranges::find(lesson.mechanism.joints, joint_name, &Joint::name);
        const auto index = static_cast<int>(joint - lesson.mechanism.joints.begin());
        const auto of_joint = [&](const Annotation& a) {
            return a.link == Pointable::vector(index, Pointable::kVectorI);
        };
        // a vector that two of them share is named once
        const auto first = static_cast<int>(
            std::ranges::find(lesson.mechanism.joints, wanted.front(), &Joint::name) -
            lesson.mechanism.joints.begin());
        const auto named = std::ranges::count_if(picture.annotations, of_joint);
        CHECK((index == first ? named == 1 : named <= 1));
        const auto is_drawn = [&](const render::Arrow& arrow) {
            return arrow.id == picture_id(Pointable::vector(index, Pointable::kVectorI));
        };
        CHECK(std::ranges::any_of(picture.scene.arrows, is_drawn));
        const auto group = std::ranges::find(view.equations, index, &EquationGroup::joint);
        REQUIRE(group != view.equations.end());
        CHECK(group->owner == joint_name);
    }
}

TEST_CASE("a joint that was chosen shows its vectors and equations while it moves", "[app][picture]") {
    Session session(lesson_named("loops/four-bar"));
    session.apply(GoTo{session.index_of_time(0.5)});
    CHECK(session.view().equations.empty());
    const auto version = session.version();
    session.show_joint(2);
    CHECK(session.version() > version);
    REQUIRE_FALSE(session.view().equations.empty());
    CHECK(session.view().equations.front().joint == 2);
    const auto of_joint = [](const Annotation& a) {
        return a.link.kind == Pointable::Kind::vector && a.link.index == 2;
    };
    CHECK(std::ranges::any_of(session.picture().annotations, of_joint));
    SECTION("also after the lesson was changed") {
        session.apply(SetCoordinates{CoordinateChoice::omega_global});
        REQUIRE_FALSE(session.view().equations.empty());
        CHECK(session.view().equations.front().joint == 2);
    }
    SECTION("and not when it is chosen once more") {
        session.show_joint(2);
        CHECK(session.view().equations.empty());
    }
}

TEST_CASE("iterations show where the bodies came from, a failure what is missing", "[app][picture]") {
    Lesson lesson = one_joint("revolute");
    lesson.mechanism.bodies[1].r += Vec3(0.2, 0.1, -0.1);
    const Story story(lesson);
    const Picture moving = picture_of(story, picture_style(story), first_of(story, Step::Kind::iteration));
    const auto is_ghost = [](const render::Shape& shape) { return shape.colour.a < 1.0F; };
    CHECK(std::ranges::any_of(moving.scene.shapes, is_ghost));

    Lesson torn = chain();
    torn.mechanism.joints[2].geometry.P_j_local += Vec3(4.0, 0.0, 0.0);
    const Story failed(torn);
    REQUIRE(failed.failure() != nullptr);
    const Step& step = failed.steps().back();
    const Picture picture =
        picture_of(failed, picture_style(failed), static_cast<int>(failed.steps().size()) - 1);
    REQUIRE(picture.scene.polylines.size() == 1);
    const render::Polyline& gap = picture.scene.polylines.front();
    CHECK(gap.dashed);
    const PlacedJoint joint = placed(torn.mechanism, 2, step.state);
    CHECK(gap.points.front() == joint.P_i);
    CHECK(gap.points.back() == joint.P_j);
}

TEST_CASE("a thread is cut on the author's bar and turns with it", "[app][picture]") {
    Lesson lesson = one_joint("screw");
    const JointGeometry& g = lesson.mechanism.joints.front().geometry;
    lesson.looks[0].shapes = {
        Cylinder{g.P_i_local - 0.3 * g.s_i_local, g.P_i_local + 0.5 * g.s_i_local, 0.04}};
    const Story story(lesson);
    const PictureStyle style = picture_style(story);
    const Picture picture = picture_of(story, style, first_of(story, Step::Kind::assembled));
    int threads = 0;
    for (const render::Shape& shape : picture.scene.shapes) {
        const auto* screw = std::get_if<render::Screw>(&shape.geometry);
        if (screw == nullptr) { continue; }
        ++threads;
        CHECK((screw->from - (kPoint - 0.3 * kAxis)).norm() < 1e-9);
        CHECK((screw->to - (kPoint + 0.5 * kAxis)).norm() < 1e-9);
        CHECK(screw->pitch == Approx(2.0 * std::numbers::pi * 0.02));
    }
    CHECK(threads == 1);
}

}  // namespace jw::test
