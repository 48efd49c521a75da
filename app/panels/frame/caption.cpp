#include "app/panels/frame/frame.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <imgui.h>

#include "app/panels/parts/rich_text.hpp"
#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/session/wording/shown_lesson.hpp"

namespace jw::panels {

namespace {

void draw_progress(const Canvas& canvas, const Box& box, const View& view) {
    const float height = canvas.px(3.0F);
    const Box line{box.x, box.bottom() - height, box.width, height};
    const float part = static_cast<float>(view.step + 1) / static_cast<float>(std::max(1, view.steps));
    canvas.fill(line, theme::kLine);
    canvas.fill({line.x, line.y, std::round(line.width * std::min(part, 1.0F)), height}, theme::kAccent);
}

/// "t = 0.500 s   ·   step 12 of 40"
std::string position_text(const View& view) {
    std::string text = view.steps > 0 ? tr("step {0} of {1}", view.step + 1, view.steps) : "";
    if (view.kind == Step::Kind::motion) { text = "t = " + fixed_text(view.t, 3) + " s   ·   " + text; }
    return text;
}

/// @return left edge of what was drawn
float draw_position(const Canvas& canvas, const Box& box, const View& view) {
    const render::Fonts& fonts = canvas.fonts();
    const std::string text = position_text(view);
    const float source_room = 0.4F * box.width;
    const std::string source = shortened(*fonts.small, shown_slides(view.source), source_room);
    canvas.text({box.right(), box.y}, fonts.small, theme::kSoft, source, Align::right);
    const float y = box.y + canvas.line_height(fonts.small) + canvas.px(6.0F);
    canvas.text({box.right(), y}, fonts.normal, theme::kInk, text, Align::right);
    return box.right() -
           std::max(canvas.text_width(fonts.small, source), canvas.text_width(fonts.normal, text));
}

constexpr float kBetweenTitleLines = 1.0F;

float height_of_three_lines(const Canvas& canvas) {
    const render::Fonts& fonts = canvas.fonts();
    return canvas.line_height(fonts.small) + canvas.line_height(fonts.title) +
           canvas.line_height(fonts.normal) + 2.0F * canvas.px(kBetweenTitleLines);
}

/// Three lines: the lesson; the step; its source and its number.
void draw_three_lines(const Canvas& canvas, const Box& box, const View& view) {
    const render::Fonts& fonts = canvas.fonts();
    const float gap = canvas.px(kBetweenTitleLines);
    float y = box.y;
    canvas.text({box.x, y}, fonts.small, theme::kSoft, shortened(*fonts.small, view.lesson_title, box.width));
    y += canvas.line_height(fonts.small) + gap;
    canvas.text({box.x, y}, fonts.title, theme::kInk, shortened(*fonts.title, view.title, box.width));
    y += canvas.line_height(fonts.title) + gap;
    const std::string position = position_text(view);
    canvas.text({box.right(), y}, fonts.normal, theme::kInk, position, Align::right);
    const float room = box.width - canvas.text_width(fonts.normal, position) - canvas.px(16.0F);
    const float drop = std::round(fonts.normal->Ascent) - std::round(fonts.small->Ascent);
    canvas.text(
        {box.x, y + drop}, fonts.small, theme::kSoft,
        room > 0.0F ? shortened(*fonts.small, shown_slides(view.source), room) : "");
}

Box inside_caption(const Canvas& canvas, const Box& box) {
    return shrunk(box, canvas.px(theme::kMargin), canvas.px(12.0F));
}

/// Font of the sentence: the large one if three lines are enough.
const ImFont* font_of_sentence(const Canvas& canvas, const Box& inner, const View& view) {
    const render::Fonts& fonts = canvas.fonts();
    return wrapped(*fonts.normal, view.sentence, inner.width).size() > 3 ? fonts.small : fonts.normal;
}

/// Paragraphs of a question or an answer, one below the other.
struct Asked {
    std::string text;
    bool soft = false;
};

std::vector<Asked> paragraphs_of(const QuestionView& question) {
    std::vector<Asked> list{{typeset(run_on(question.ask)), question.answered}};
    if (question.answered) {
        list.push_back({tr("Answer:  {0}", typeset(run_on(question.answer)))});
        if (!question.why.empty()) { list.push_back({typeset(run_on(question.why)), true}); }
        return list;
    }
    for (std::size_t k = 0; k < question.choices.size(); ++k) {
        list.push_back({std::to_string(k + 1) + ")  " + typeset(run_on(question.choices[k]))});
    }
    return list;
}

constexpr float kBetweenParagraphs = 4.0F;

float question_height(const Canvas& canvas, const ImFont* font, float width, const QuestionView& question) {
    float height = 0.0F;
    for (const Asked& asked : paragraphs_of(question)) {
        height += paragraph_height(canvas, font, asked.text, width) + canvas.px(kBetweenParagraphs);
    }
    return height;
}

void draw_question(const Canvas& canvas, Box box, const QuestionView& question) {
    const render::Fonts& fonts = canvas.fonts();
    const float gap = canvas.px(kBetweenParagraphs);
    const bool fits = question_height(canvas, fonts.normal, box.width, question) <= box.height;
    const ImFont* const font = fits ? fonts.normal : fonts.small;
    for (const Asked& asked : paragraphs_of(question)) {
        const Colour colour = asked.soft ? theme::kSoft : theme::kInk;
        const float used = paragraph(canvas, box, font, colour, asked.text) + gap;
        box.y += used;
        box.height -= used;
    }
}

}  // namespace

void draw_title(const Canvas& canvas, const Box& box, const View& view) {
    const render::Fonts& fonts = canvas.fonts();
    if (view.steps > 0) { draw_progress(canvas, box, view); }
    const Box inner = shrunk(box, canvas.px(theme::kMargin), canvas.px(8.0F));
    if (inner.height >= height_of_three_lines(canvas)) { return draw_three_lines(canvas, inner, view); }
    const float right = draw_position(canvas, inner, view) - canvas.px(20.0F);
    const float room = right - inner.x;
    canvas.text(
        {inner.x, inner.y}, fonts.small, theme::kSoft, shortened(*fonts.small, view.lesson_title, room));
    const float y = inner.y + canvas.line_height(fonts.small) + canvas.px(1.0F);
    canvas.text({inner.x, y}, fonts.title, theme::kInk, shortened(*fonts.title, view.title, room));
}

float caption_height(const Canvas& canvas, const Box& box, const View& view) {
    const Box inner = inside_caption(canvas, box);
    const auto height_of = [&](const ImFont* font, const std::string& text) {
        return paragraph_height(canvas, font, text, inner.width);
    };
    float height = height_of(font_of_sentence(canvas, inner, view), view.sentence);
    const std::string text = typeset(run_on(view.author_text));
    if (!text.empty()) { height += canvas.px(8.0F) + height_of(canvas.fonts().small, text); }
    if (view.question) {
        height = question_height(canvas, canvas.fonts().small, inner.width, *view.question);
    }
    return std::max(box.height, std::ceil(height) + box.height - inner.height);
}

void draw_caption(const Canvas& canvas, const Box& box, const View& view) {
    const render::Fonts& fonts = canvas.fonts();
    canvas.fill({box.x, box.y, box.width, std::max(1.0F, canvas.px(1.0F))}, theme::kLine);
    if (view.question) { return draw_question(canvas, inside_caption(canvas, box), *view.question); }
    const Box inner = inside_caption(canvas, box);
    const ImFont* const font = font_of_sentence(canvas, inner, view);
    const auto lines_of = [&](const ImFont* f, float room) {
        return static_cast<std::size_t>(std::max(0.0F, std::floor(room / canvas.line_height(f))));
    };
    float height = paragraph(canvas, inner, font, theme::kInk, view.sentence, lines_of(font, inner.height));

    const std::string text = typeset(run_on(view.author_text));
    if (text.empty()) { return; }
    height += canvas.px(8.0F);
    const Box below{inner.x, inner.y + height, inner.width, inner.height - height};
    const bool fits = paragraph_height(canvas, fonts.normal, text, below.width) <= below.height;
    const ImFont* const author = fits ? fonts.normal : fonts.small;
    if (math::has_marks(text)) {
        const RichText rich = layout_rich_to(fonts, *author, text, below.width, below.height + 0.5F);
        return draw_rich(canvas, {below.x, below.y}, author, theme::kSoft, rich);
    }
    paragraph(canvas, below, author, theme::kSoft, text, lines_of(author, below.height));
}

}  // namespace jw::panels
