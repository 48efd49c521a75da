#include "app/panels/column/newton_panel.hpp"

#include <array>

#include <imgui.h>

#include "app/panels/parts/text.hpp"
#include "app/panels/parts/theme.hpp"
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
    float turn = 0.84F;
    float fraction = 0.92F;
    float rank = 1.0F;
};
constexpr Places kPlaces;
constexpr float kNoteGap = 0.03F;

// the part taken says it already
constexpr const char* kStepLimited = "step limited";

struct Line {
    const Canvas& canvas;
    const Box& box;
    float y;
    Colour ink;

    void number(float part, std::string_view text) const {
        canvas.text({box.x + part * box.width, y}, canvas.fonts().small, ink, text, Align::right);
    }
    void words(float from, float to, std::string_view text) const {
        const ImFont& small = *canvas.fonts().small;
        const float room = (to - from) * box.width;
        canvas.text({box.x + from * box.width, y}, &small, ink, shortened(small, text, room));
    }
};

void draw_head(const Canvas& canvas, const Box& box) {
    const Line line{canvas, box, box.y, theme::kSoft};
    line.number(kPlaces.k, "k");
    line.number(kPlaces.phi, "‖Φ‖");
    line.words(kPlaces.label, kPlaces.value, "largest equation");
    line.number(kPlaces.delta, "‖Δq‖");
    line.number(kPlaces.turn, "turn");
    line.number(kPlaces.fraction, "part");
    line.number(kPlaces.rank, "rank");
}

bool is_worth_a_line(const Canvas& canvas, const Box& box, const NewtonRow& row) {
    if (row.note.empty()) { return false; }
    if (row.stepped) { return row.note != kStepLimited; }
    const float room = (kPlaces.rank - kPlaces.value - kNoteGap) * box.width;
    return canvas.text_width(canvas.fonts().small, row.note) > room;
}

void draw_current_mark(const Canvas& canvas, const Box& row) {
    const float margin = canvas.px(6.0F);
    canvas.fill({row.x - margin, row.y - 1.0F, row.width + 2.0F * margin, row.height}, theme::kSubject);
    canvas.fill({row.x - margin, row.y - 1.0F, canvas.px(3.0F), row.height}, theme::kSubjectMark);
}

void draw_step(const Line& line, const NewtonRow& row) {
    line.number(kPlaces.delta, small_text(row.delta_norm));
    line.number(kPlaces.turn, fixed_text(row.turn_deg, row.turn_deg < 10.0 ? 2 : 1) + "°");
    line.number(kPlaces.fraction, number_text(row.fraction, 2));
    line.number(kPlaces.rank, std::to_string(row.rank));
}

/// @return height taken
float draw_row(const Canvas& canvas, const Box& box, const NewtonRow& row, bool current) {
    const ImFont* const small = canvas.fonts().small;
    const float height = canvas.line_height(small) + canvas.px(2.0F);
    const bool second_line = is_worth_a_line(canvas, box, row);
    const float total = height + (second_line ? canvas.line_height(small) : 0.0F);
    if (current) { draw_current_mark(canvas, {box.x, box.y, box.width, total}); }

    const Line line{canvas, box, box.y, theme::kInk};
    const std::string value = small_text(row.largest_value);
    const float value_room = canvas.text_width(small, value) + canvas.px(8.0F);
    line.number(kPlaces.k, std::to_string(row.iteration));
    line.number(kPlaces.phi, small_text(row.phi_norm));
    line.words(kPlaces.label, kPlaces.value - value_room / box.width, row.largest_row);
    line.number(kPlaces.value, value);
    if (row.stepped) { draw_step(line, row); }
    if (second_line) {
        const Line below{canvas, box, box.y + height - canvas.px(2.0F), theme::kWarning};
        below.words(kPlaces.label, kPlaces.rank, row.note);
    } else if (!row.stepped) {
        line.words(kPlaces.value + kNoteGap, kPlaces.rank, row.note);
    }
    return total;
}

std::size_t most_rows(Density density) {
    return density == Density::roomy ? 12 : (density == Density::compact ? 8 : 5);
}

}  // namespace

float newton_panel(
    const Canvas& canvas, const Box& box, const std::vector<NewtonRow>& rows, Density density) {
    const std::size_t most = most_rows(density);
    const std::size_t first = rows.size() > most ? rows.size() - most : 0;
    const std::string note = first > 0 ? std::to_string(first) + " earlier not shown" : "Φq Δq = −Φ";
    float height = heading(canvas, box, "Newton–Raphson", note);
    draw_head(canvas, {box.x, box.y + height, box.width, 0.0F});
    height += canvas.line_height(canvas.fonts().small) + canvas.px(3.0F);
    for (std::size_t k = first; k < rows.size(); ++k) {
        const Box rest{box.x, box.y + height, box.width, 0.0F};
        height += draw_row(canvas, rest, rows[k], k + 1 == rows.size());
    }
    return height;
}

}  // namespace jw::panels
