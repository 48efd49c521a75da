#include <catch2/catch.hpp>

#include <imgui.h>
#include <imgui_internal.h>

#include "tests/app/host/person.hpp"

/// Questions at the window that are answered with the mouse.
namespace jw::test {
namespace {

using host::Key;

/// The first question of the open lesson with an answer of this kind; the window stands there.
template <class AnswerKind>
int go_to_question(Person& person) {
    const Story& story = person.session().story();
    for (std::size_t k = 0; k < story.steps().size(); ++k) {
        const Step& step = story.steps()[k];
        if (step.kind != Step::Kind::question) { continue; }
        const Question& question = question_of(story.lesson(), step);
        if (!std::holds_alternative<AnswerKind>(question.answer)) { continue; }
        person.go_to(static_cast<int>(k));
        person.settle();
        return step.question;
    }
    FAIL("no such question");
    return -1;
}

/// Clicks on the first place of the column that means `wanted`.
bool click_on(Person& person, const Pointable& wanted) {
    const panels::Box column = person.host().layout().column;
    for (float y = column.y + 4.0F; y < column.bottom(); y += 6.0F) {
        for (float x = column.x + 4.0F; x < column.right(); x += 6.0F) {
            person.host().push(host::InputEvent::pointer(x, y));
            person.frame();
            if (person.host().state().pointed_at != wanted) { continue; }
            person.click(x, y);
            person.settle();
            return true;
        }
    }
    return false;
}

/// Drags a body in the picture.
void pull(Person& person, int body) {
    person.host().set_picker([body](float, float) { return picture_id(Pointable::body(body)); });
    person.drag(300.0F, 250.0F, 340.0F, 280.0F);
}

/// Types an answer; an empty one hands in what was moved by hand, or skips the question.
void hand_in(Person& person, const std::string& text) {
    person.type("a");
    person.type(text);
    person.press(Key::enter);
    person.settle();
}

}  // namespace

TEST_CASE("A row that is clicked before its joint is added is the answer", "[pointing]") {
    for (const auto& [number, right] : {std::pair{5, true}, std::pair{3, false}}) {
        Person person("joints/revolute.toml");
        const int question = go_to_question<PointedAnswer>(person);
        const int asked = person.session().index();
        // of s x, s y, s z, p1 x, p1 y, p1 z
        REQUIRE(click_on(person, Pointable::equation(0, number)));
        REQUIRE(person.host().predictions().given(question) != nullptr);
        CHECK(person.host().predictions().given(question)->right == right);
        CHECK(person.session().index() == asked + 1);
        CHECK_FALSE(person.session().is_changed());
    }
}

TEST_CASE("A vector that is clicked in the picture is the answer, a drag and a body are none", "[pointing]") {
    Person person("vectors/perpendicular-vectors.toml");
    const int question = go_to_question<PointedAnswer>(person);
    const int joint = person.session().lesson().questions[static_cast<std::size_t>(question)].addition.index;
    const auto given = [&] { return person.host().predictions().given(question); };
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(0)); });
    person.click(300.0F, 200.0F);
    person.settle();
    CHECK(given() == nullptr);
    person.host().set_picker([&](float, float) { return picture_id(Pointable::vector(joint, 1)); });
    person.drag(300.0F, 200.0F, 360.0F, 240.0F);
    person.settle();
    CHECK(given() == nullptr);
    go_to_question<PointedAnswer>(person);
    person.click(300.0F, 200.0F);
    person.settle();
    REQUIRE(given() != nullptr);
    CHECK(given()->right);
}

TEST_CASE("A name that is typed is the answer, a wrong name an objection", "[pointing]") {
    Person person("vectors/perpendicular-vectors.toml");
    const int question = go_to_question<PointedAnswer>(person);
    const int asked = person.session().index();
    hand_in(person, "n1 s_k");
    CHECK(person.host().predictions().given(question) == nullptr);
    CHECK(person.session().index() == asked);
}

TEST_CASE("A body is dragged to its pose and handed in, without changing the lesson", "[pointing]") {
    Person person("joints/revolute.toml");
    const int question = go_to_question<PoseAnswer>(person);
    const int asked = person.session().index();
    pull(person, 1);
    person.settle();
    REQUIRE(person.session().in_hand());
    CHECK(person.view().kind == Step::Kind::question);
    CHECK_FALSE(person.session().is_changed());
    hand_in(person, "");
    REQUIRE(person.host().predictions().given(question) != nullptr);
    CHECK_FALSE(person.session().in_hand());
    CHECK(person.session().index() == asked + 1);
    CHECK_FALSE(person.session().is_changed());
}

TEST_CASE("An objection is to one question, and goes when that is skipped", "[pointing]") {
    Person person("joints/revolute.toml");
    go_to_question<PointedAnswer>(person);
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    person.click(300.0F, 250.0F);
    person.settle();
    CHECK_FALSE(person.host().predictions().objection().empty());
    hand_in(person, "");
    CHECK(person.session().step().kind == Step::Kind::question);
    CHECK(person.host().predictions().objection().empty());
}

TEST_CASE("What is said while a body is dragged does not cover the field of the answer", "[pointing]") {
    Person person("joints/revolute.toml");
    go_to_question<PoseAnswer>(person);
    // into the hinge: the lever cannot follow
    person.host().set_picker([](float, float) { return picture_id(Pointable::body(1)); });
    person.drag(430.0F, 275.0F, 474.0F, 215.0F);
    person.frame();
    const ImDrawList* const said = ImGui::GetForegroundDrawList();
    REQUIRE(said->VtxBuffer.Size > 0);
    const ImGuiWindow* const sheet = ImGui::FindWindowByName("prediction");
    REQUIRE(sheet != nullptr);
    for (const ImDrawVert& v : said->VtxBuffer) { REQUIRE_FALSE(sheet->Rect().Contains(v.pos)); }
}

TEST_CASE("Escape takes the body back, and an empty field skips the question", "[pointing]") {
    Person person("joints/revolute.toml");
    const int question = go_to_question<PoseAnswer>(person);
    const int asked = person.session().index();
    pull(person, 1);
    person.press(Key::escape);
    person.settle();
    CHECK_FALSE(person.session().in_hand());
    CHECK(person.session().index() == asked);
    hand_in(person, "");
    CHECK(person.host().predictions().given(question) == nullptr);
    CHECK(person.session().index() == asked + 1);
}

}  // namespace jw::test
