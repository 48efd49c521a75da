#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"

namespace jw::panels {

namespace {

struct Figure {
    std::string number;
    const char* name;
    float share;  ///< of the width
    Colour ink = theme::kInk;
};

void draw_figure(const Canvas& canvas, const Box& cell, const Figure& figure) {
    const render::Fonts& fonts = canvas.fonts();
    canvas.text({cell.x, cell.y}, fonts.title, figure.ink, figure.number);
    canvas.text({cell.x, cell.y + canvas.line_height(fonts.title)}, fonts.small, theme::kSoft, figure.name);
}

float width_of(const Canvas& canvas, const Figure& figure) {
    const render::Fonts& fonts = canvas.fonts();
    return std::max(
        canvas.text_width(fonts.title, figure.number), canvas.text_width(fonts.small, figure.name));
}

std::array<Figure, 6> figures_of(const RankView& rank) {
    const bool grown = rank.rank_before >= 0 && rank.rank_before != rank.rank;
    const bool here = rank.differs_once_assembled();
    const int redundant = rank.redundant();
    // a growth of the rank that assembling undoes is not shown
    const std::string number = grown && !here
                                   ? std::to_string(rank.rank_before) + " → " + std::to_string(rank.rank)
                                   : std::to_string(rank.rank);
    return {{
        {number, here ? tr("rank here") : tr("rank"), 0.27F, theme::kAccent},
        {std::to_string(rank.rows), tr("rows"), 0.13F},
        {std::to_string(rank.columns), tr("columns"), 0.15F},
        {std::to_string(rank.dof), rank.dof == 1 ? tr("freedom") : tr("freedoms"), 0.16F},
        {std::to_string(redundant), tr("redundant"), 0.16F, redundant > 0 ? theme::kRedundant : theme::kInk},
        {std::to_string(rank.mobility_by_counting), tr("Grübler"), 0.13F},
    }};
}

/// The first `most` texts, then the number of the others.
float list_of_texts(
    const Canvas& canvas, const Box& box, const std::vector<std::string>& texts, std::size_t most,
    std::size_t lines_each) {
    const ImFont* const small = canvas.fonts().small;
    const float indent = canvas.px(12.0F);
    const std::size_t shown = texts.size() == most + 1 ? texts.size() : std::min(most, texts.size());
    float height = 0.0F;
    for (std::size_t k = 0; k < shown; ++k) {
        canvas.square(
            {box.x + canvas.px(3.0F), box.y + height + 0.5F * canvas.line_height(small)}, canvas.px(3.0F),
            theme::kSoft, true);
        const Box rest{box.x + indent, box.y + height, box.width - indent, 0.0F};
        height += paragraph(canvas, rest, small, theme::kInk, texts[k], lines_each);
    }
    if (shown < texts.size()) {
        const std::string more = tr("and {0} more", texts.size() - shown);
        canvas.text({box.x + indent, box.y + height}, small, theme::kSoft, more);
        height += canvas.line_height(small);
    }
    return height;
}

float titled_list(
    const Canvas& canvas, const Box& box, const char* title, const std::vector<std::string>& texts,
    std::size_t most, std::size_t lines_each) {
    if (texts.empty()) { return 0.0F; }
    const ImFont* const small = canvas.fonts().small;
    canvas.text({box.x, box.y}, small, theme::kSoft, title);
    const float line = canvas.line_height(small);
    return line + list_of_texts(canvas, below(box, line), texts, most, lines_each) + canvas.px(4.0F);
}

float warning(const Canvas& canvas, const Box& box, const std::string& text) {
    const ImFont* const small = canvas.fonts().small;
    const float margin = canvas.px(6.0F);
    const Box inner{box.x + 2.0F * margin, box.y + margin, box.width - 3.0F * margin, 0.0F};
    const float height = paragraph(canvas.measuring(), inner, small, theme::kWarning, text) + 2.0F * margin;
    canvas.fill({box.x, box.y, box.width, height}, theme::kWarningShade, canvas.px(3.0F));
    canvas.fill({box.x, box.y, canvas.px(3.0F), height}, theme::kSubjectMark);
    paragraph(canvas, inner, small, theme::kWarning, text);
    return height + canvas.px(4.0F);
}

/// "10 once assembled, 8 before: 1 redundant", if the rank once assembled is not that of the pose.
float once_assembled_line(const Canvas& canvas, const Box& box, const RankView& rank) {
    if (!rank.differs_once_assembled()) { return 0.0F; }
    const int once = *rank.once_assembled;
    const std::string text = rank.rank_before >= 0
                                 ? tr("rank {0} once assembled, {1} before: then {2} redundant", once,
                                      rank.rank_before, rank.rows - once)
                                 : tr("rank {0} once assembled: then {1} redundant", once, rank.rows - once);
    return paragraph(canvas, box, canvas.fonts().small, theme::kAccent, text);
}

}  // namespace

float rank_figures(const Canvas& canvas, const Box& box, const View& view, Density /*density*/) {
    const RankView& rank = view.rank;
    const float top = heading(
        canvas, box, tr("Rank"),
        rank.assembled ? tr("of joints and drivers, in (r, ω′)")
                       : tr("of the matrix here, not assembled yet"));
    const float row = canvas.line_height(canvas.fonts().title) + canvas.line_height(canvas.fonts().small);
    const std::array<Figure, 6> figures = figures_of(rank);
    // large text in a narrow window: two lines of three
    const bool narrow = std::ranges::any_of(figures, [&](const Figure& figure) {
        return width_of(canvas, figure) + canvas.px(3.0F) > figure.share * box.width;
    });
    float x = box.x;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const float lower = narrow && k >= 3 ? row : 0.0F;
        if (narrow && k % 3 == 0) { x = box.x; }
        draw_figure(canvas, {x, box.y + top + lower, 0.0F, 0.0F}, figures[k]);
        x += (narrow ? 1.0F / 3.0F : figures[k].share) * box.width;
    }
    const float height = top + (narrow ? 2.0F : 1.0F) * row;
    return height + once_assembled_line(canvas, below(box, height), rank);
}

float rank_warnings(const Canvas& canvas, const Box& box, const View& view, Density /*density*/) {
    const RankView& rank = view.rank;
    float height = 0.0F;
    if (!rank.assembled) {
        height += warning(
            canvas, below(box, height),
            tr("Not assembled: the largest |Φ| is {0}. Which rows are redundant is decided once the "
               "equations hold.",
               small_text(rank.residual)));
    }
    for (const std::string& doubt : rank.doubts) { height += warning(canvas, below(box, height), doubt); }
    if (rank.near_singular) {
        height += warning(
            canvas, below(box, height),
            tr("Nearly singular: a singular value is small, but above the threshold. The rank is about to "
               "drop."));
    }
    return height;
}

float rank_words(const Canvas& canvas, const Box& box, const View& view, Density density) {
    const RankView& rank = view.rank;
    const auto most = at_density<std::size_t>(density, 3, 2, 1);
    const std::size_t lines = density >= Density::tight ? 1 : 2;
    float height = rank_warnings(canvas, box, view, density);
    height +=
        titled_list(canvas, below(box, height), tr("Dependent equations"), rank.combinations, most, lines);
    const char* const title = rank.dof == 1 ? tr("The freedom that is left") : tr("Freedoms that are left");
    height += titled_list(canvas, below(box, height), title, rank.told_motions(), most, lines);
    return height;
}

}  // namespace jw::panels
