#include "app/panels/column/panels.hpp"

#include <array>

#include <imgui.h>

#include "app/panels/parts/text_lines.hpp"
#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

/// Right edges of numbers and left edges of words, in parts of the width.
struct Places {
    float k = 0.045F;
    float phi = 0.175F;
    float label = 0.205F;
    float value = 0.595F;
    float delta = 0.735F;
    float turn = 0.83F;
    float fraction = 0.92F;
    float rank = 1.0F;
};
constexpr float kNoteGap = 0.03F;
constexpr float kLeastLabel = 0.2F;  // of the width, for the name of an equation

/// Places of the columns for this width. With large text in a narrow column they follow from the widths of
/// the numbers, and the least important columns are left out: their place is 0.
Places places_of(const Canvas& canvas, const Box& box) {
    const auto part = [&](const char* text) {
        return (canvas.text_width(canvas.fonts().small, text) + canvas.px(6.0F)) / box.width;
    };
    const Places usual;
    const float number = part("−1.9e−01");
    const float size = part("1.9e−01");  // of values that are never negative
    if (usual.phi - usual.k >= size && usual.delta - usual.value >= size &&
        usual.turn - usual.delta >= part("53.6°")) {
        return usual;
    }
    Places places;
    places.k = part("100");
    places.phi = places.k + size;
    places.label = places.phi + part(" ");
    for (int left_out = 0; left_out < 4; ++left_out) {
        float right = 1.0F;
        const auto next = [&](bool shown, float width) {
            const float place = shown ? right : 0.0F;
            right -= shown ? width : 0.0F;
            return place;
        };
        places.rank = next(left_out < 2, part(tr("rank")));
        places.fraction = next(left_out < 1, part(tr("share")));
        places.turn = next(left_out < 3, part("206.1°"));
        places.delta = next(true, size);
        places.value = right;
        if (places.value - number - places.label >= kLeastLabel) { break; }
    }
    return places;
}

// this note gets no line of its own: the column 'share' already shows it
constexpr const char* kStepLimited = tr_later("step limited");

struct Line {
    const Canvas& canvas;
    const Box& box;
    float y;
    Colour ink;
    Places places;

    void number(float part, std::string_view text) const {
        if (part <= 0.0F) { return; }
        canvas.text({box.x + part * box.width, y}, canvas.fonts().small, ink, text, Align::right);
    }
    void words(float from, float to, std::string_view text) const {
        const ImFont& small = *canvas.fonts().small;
        const float room = (to - from) * box.width;
        canvas.text({box.x + from * box.width, y}, &small, ink, shortened(small, text, room));
    }
};

void draw_head(const Canvas& canvas, const Box& box) {
    const Line line{canvas, box, box.y, theme::kSoft, places_of(canvas, box)};
    line.number(line.places.k, "k");
    line.number(line.places.phi, "‖Φ‖");
    line.words(line.places.label, line.places.value, tr("largest residual"));
    line.number(line.places.delta, "‖Δq‖");
    line.number(line.places.turn, tr("turn"));
    line.number(line.places.fraction, tr("share"));
    line.number(line.places.rank, tr("rank"));
}

bool is_worth_a_line(const Canvas& canvas, const Box& box, const NewtonRow& row) {
    if (row.note.empty()) { return false; }
    if (row.stepped) { return row.note != tr(kStepLimited); }
    const float room = (1.0F - places_of(canvas, box).value - kNoteGap) * box.width;
    return canvas.text_width(canvas.fonts().small, row.note) > room;
}

void draw_current_mark(const Canvas& canvas, const Box& row) {
    const float margin = canvas.px(6.0F);
    canvas.fill({row.x - margin, row.y - 1.0F, row.width + 2.0F * margin, row.height}, theme::kSubject);
    canvas.fill({row.x - margin, row.y - 1.0F, canvas.px(3.0F), row.height}, theme::kSubjectMark);
}

void draw_step(const Line& line, const NewtonRow& row) {
    line.number(line.places.delta, small_text(row.delta_norm));
    line.number(line.places.turn, fixed_text(row.turn_deg, row.turn_deg < 10.0 ? 2 : 1) + "°");
    line.number(line.places.fraction, number_text(row.fraction, 2));
    line.number(line.places.rank, std::to_string(row.rank));
}

/// @return height taken
float draw_row(const Canvas& canvas, const Box& box, const NewtonRow& row, bool current) {
    const ImFont* const small = canvas.fonts().small;
    const float height = canvas.line_height(small) + canvas.px(2.0F);
    const bool second_line = is_worth_a_line(canvas, box, row);
    const float total = height + (second_line ? canvas.line_height(small) : 0.0F);
    if (current) { draw_current_mark(canvas, {box.x, box.y, box.width, total}); }

    const Line line{canvas, box, box.y, theme::kInk, places_of(canvas, box)};
    const std::string value = small_text(row.largest_value);
    const float value_room = canvas.text_width(small, value) + canvas.px(8.0F);
    line.number(line.places.k, std::to_string(row.iteration));
    line.number(line.places.phi, small_text(row.phi_norm));
    line.words(line.places.label, line.places.value - value_room / box.width, row.largest_row);
    line.number(line.places.value, value);
    if (row.stepped) { draw_step(line, row); }
    if (second_line) {
        const Line below{canvas, box, box.y + height - canvas.px(2.0F), theme::kWarning, line.places};
        below.words(line.places.label, 1.0F, row.note);
    } else if (!row.stepped) {
        line.words(line.places.value + kNoteGap, 1.0F, row.note);
    }
    return total;
}

}  // namespace

float newton_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    const std::vector<NewtonRow>& rows = view.newton;
    if (rows.empty()) { return 0.0F; }
    const auto most = at_density<std::size_t>(density, 12, 8, 5);
    const std::size_t first = rows.size() > most ? rows.size() - most : 0;
    const std::string note = first > 0 ? tr("{0} earlier ones not shown", first) : "Φq Δq = −Φ";
    float height = heading(canvas, box, tr("Newton–Raphson"), note);
    draw_head(canvas, below(box, height));
    height += canvas.line_height(canvas.fonts().small) + canvas.px(3.0F);
    for (std::size_t k = first; k < rows.size(); ++k) {
        height += draw_row(canvas, below(box, height), rows[k], k + 1 == rows.size());
    }
    return height;
}

}  // namespace jw::panels
