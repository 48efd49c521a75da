#include "app/panels/column/panels.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <imgui.h>

#include "app/panels/parts/theme.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::panels {

namespace {

Block matrix_block(const Canvas& canvas, const View& view) {
    // a huge matrix is a pattern of dots: it must not displace other panels
    const auto height = [&](float cell) {
        return std::min(matrix_panel_height(canvas, view.matrix, cell), canvas.px(260.0F));
    };
    Block block;
    block.draw = [&view](const Canvas& c, const Box& box, Density) {
        return matrix_panel(c, box, view.matrix);
    };
    block.fills = true;
    block.least = {height(10.0F), height(8.0F), height(5.0F)};
    block.good = matrix_panel_height(canvas, view.matrix, 14.0F);
    block.wish = matrix_panel_height(canvas, view.matrix, 20.0F);
    return block;
}

/// Curves below a heading, which fill the given height; nothing if there are no values.
Block plot_block(
    const Canvas& canvas, bool has_values, float wish, const char* title, const char* aside,
    std::function<void(const Canvas&, const Box&)> draw) {
    if (!has_values) {
        return {[](const Canvas&, const Box&, Density) { return 0.0F; }};
    }
    return {
        [=](const Canvas& c, const Box& box, Density) {
            Box rest = box;
            cut_top(rest, heading(c, box, title, aside));
            draw(c, rest);
            return box.height;
        },
        true,
        {canvas.px(120.0F), canvas.px(110.0F), canvas.px(96.0F)},
        canvas.px(132.0F),
        canvas.px(wish)};
}

Block given_up_at(int level, Block block) {
    block.given_up = level;
    return block;
}

using Panel = float (*)(const Canvas&, const Box&, const View&, Density);

Block block_of(const View& view, Panel draw) {
    return {[&view, draw](const Canvas& c, const Box& box, Density density) {
        return draw(c, box, view, density);
    }};
}

float equations_of_step(const Canvas& canvas, const Box& box, const View& view, Density density) {
    return view.equations.empty() ? 0.0F : equations_panel(canvas, box, view.equations, density);
}

/// Equations of the step, if the question asked for a row: the rows that are kept are the answer.
float row_answer_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    const bool of_rows = view.question && view.question->kind == QuestionView::Kind::thing &&
                         view.question->thing == Thing::Kind::row;
    return of_rows ? equations_of_step(canvas, box, view, density) : 0.0F;
}

/// The equations with their values only, without the reasons for the choice of rows.
float values_panel(const Canvas& canvas, const Box& box, const View& view, Density /*density*/) {
    if (view.equations.empty()) { return 0.0F; }
    std::vector<EquationGroup> bare = view.equations;
    for (EquationGroup& group : bare) { group.choice.reset(); }
    return equations_panel(canvas, box, bare, Density::tight);
}

/// Equations with a choice of rows, or all equations if there are none; for the motion.
float choices_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    std::vector<EquationGroup> shown;
    std::ranges::copy_if(view.equations, std::back_inserter(shown), [](const EquationGroup& group) {
        return group.choice.has_value();
    });
    return shown.empty() ? equations_of_step(canvas, box, view, density)
                         : equations_panel(canvas, box, shown, density);
}

/// Why a joint cannot be closed, or why the motion ends: joint, row, residual, cause and remedy, in a box of
/// its own.
float failure_panel(const Canvas& canvas, const Box& box, const View& view, Density density) {
    if (view.failure.empty()) { return 0.0F; }
    const render::Fonts& fonts = canvas.fonts();
    const float margin = canvas.px(12.0F);
    const float title_height = canvas.line_height(fonts.bold) + canvas.px(4.0F);
    const ImFont* const font = density == Density::roomy ? fonts.normal : fonts.small;
    const Box inner{
        box.x + margin + canvas.px(4.0F), box.y + margin, box.width - 2.0F * margin - canvas.px(4.0F), 0.0F};
    const Box words{inner.x, inner.y + title_height, inner.width, 0.0F};
    const std::size_t most = density >= Density::tight ? 6 : 12;
    const float text = paragraph(canvas.measuring(), words, font, theme::kInk, view.failure, most);
    const Box frame{box.x, box.y, box.width, title_height + text + 2.0F * margin};

    canvas.fill(frame, theme::kFailureShade, canvas.px(4.0F));
    canvas.fill({frame.x, frame.y, canvas.px(4.0F), frame.height}, theme::kRedundant);
    const bool moves = view.kind == Step::Kind::motion;
    const char* const title = moves ? tr("The motion ends here") : tr("It cannot be closed");
    canvas.text({inner.x, inner.y}, fonts.bold, theme::kRedundant, title);
    paragraph(canvas, words, font, theme::kInk, view.failure, most);
    return frame.height;
}

Block singular_values_block(const Canvas& canvas, const View& view) {
    return plot_block(
        canvas, !view.rank.singular_values.empty(), 170.0F, tr("Singular values"), tr("of Φq in (r, ω′)"),
        [&view](const Canvas& c, const Box& box) { singular_values_plot(c, box, view.rank); });
}

Block convergence_block(const Canvas& canvas, const View& view) {
    return plot_block(
        canvas, !view.newton.empty(), 160.0F, "‖Φ‖", tr("from iteration to iteration"),
        [&view](const Canvas& c, const Box& box) { convergence_plot(c, box, view.newton); });
}

/// Heights at one density. Blocks that fill get their least height; blocks that are given up get none.
std::vector<float> heights_at(
    const Canvas& canvas, const Box& box, const std::vector<Block>& blocks, Density density, int given_up) {
    std::vector<float> heights;
    for (const Block& block : blocks) {
        const bool gone = block.given_up > 0 && block.given_up <= given_up;
        const float needed = block.fills
                                 ? block.least[static_cast<std::size_t>(std::min(density, Density::tight))]
                                 : std::ceil(block.draw(canvas.measuring(), box, density));
        heights.push_back(gone ? 0.0F : needed);
    }
    return heights;
}

float total_of(const std::vector<float>& heights, float gap) {
    float total = 0.0F;
    for (const float height : heights) {
        if (height > 0.0F) { total += height + (total > 0.0F ? gap : 0.0F); }
    }
    return total;
}

/// Leaves out the last panels when no more blocks can be given up; the first panel that shows something
/// stays.
void leave_out_last(std::vector<float>& heights, float gap, float room) {
    const auto shows = [](float height) { return height > 0.0F; };
    const auto first = std::ranges::find_if(heights, shows);
    for (auto last = heights.end(); last != first && total_of(heights, gap) > room;) {
        if (--last != first) { *last = 0.0F; }
    }
}

/// Distributes the height that is left to the blocks that fill, beginning with the first.
void share_out(
    std::vector<float>& heights, const std::vector<Block>& blocks, float Block::*goal, float& left) {
    for (std::size_t k = 0; k < blocks.size() && left > 0.0F; ++k) {
        if (!blocks[k].fills || heights[k] <= 0.0F) { continue; }
        const float more = std::floor(std::min(left, std::max(0.0F, blocks[k].*goal - heights[k])));
        heights[k] += more;
        left -= more;
    }
}

Box inside_column(const Canvas& canvas, const Box& box) {
    return shrunk(box, canvas.px(theme::kMargin), canvas.px(14.0F));
}

}  // namespace

Arrangement arrange(const Canvas& canvas, const Box& box, const std::vector<Block>& blocks) {
    constexpr int most_given_up = 6;
    const float gap = canvas.px(theme::kGap);
    Arrangement arrangement;
    std::vector<float> heights;
    for (int given_up = 0; given_up <= most_given_up; ++given_up) {
        for (const Density density : {Density::roomy, Density::compact, Density::tight}) {
            arrangement.density = density;
            heights = heights_at(canvas, box, blocks, density, given_up);
            if (total_of(heights, gap) <= box.height || given_up == 0) { break; }
        }
        if (total_of(heights, gap) <= box.height) { break; }
    }
    if (total_of(heights, gap) > box.height) {
        arrangement.density = Density::bare;
        heights = heights_at(canvas, box, blocks, Density::bare, most_given_up);
        leave_out_last(heights, gap, box.height);
    }
    float left = box.height - total_of(heights, gap);
    share_out(heights, blocks, &Block::good, left);
    share_out(heights, blocks, &Block::wish, left);
    float y = box.y;
    for (const float height : heights) {
        arrangement.boxes.push_back({box.x, y, box.width, height});
        if (height > 0.0F) { y += height + gap; }
    }
    return arrangement;
}

std::vector<Block> blocks_of(const Canvas& canvas, const View& view) {
    const auto panel = [&view](Panel draw, int given_up = 0) {
        return given_up_at(given_up, block_of(view, draw));
    };
    const Block matrix = given_up_at(5, matrix_block(canvas, view));
    const Block plot = given_up_at(2, singular_values_block(canvas, view));
    switch (view.kind) {
        case Step::Kind::bodies: return {panel(coordinates_panel), panel(rank_figures), matrix};
        case Step::Kind::equations:
            return {panel(equations_of_step), matrix, panel(rank_figures, 4), given_up_at(1, plot)};
        case Step::Kind::iteration:
            return {
                panel(values_panel, 4), panel(newton_panel), matrix,
                given_up_at(2, convergence_block(canvas, view))};
        case Step::Kind::question: return {panel(equations_of_step), panel(rank_figures), matrix, plot};
        case Step::Kind::answer:
            return {panel(row_answer_panel), panel(rank_figures), panel(rank_words), matrix, plot};
        case Step::Kind::assembled: return {panel(rank_figures), panel(rank_words), matrix, plot};
        case Step::Kind::failed: return {panel(failure_panel), panel(newton_panel, 4), matrix};
        case Step::Kind::motion: break;
    }
    return {
        panel(failure_panel),
        panel(choices_panel, 4),
        panel(quantities_panel, view.dynamics ? 6 : 0),
        panel(dynamics_panel),
        panel(bodies_motion_panel, view.dynamics ? 1 : 3),
        panel(rank_warnings),
        matrix,
        plot};
}

float column_height(const Canvas& canvas, const Box& box, const View& view) {
    const Box inner = inside_column(canvas, box);
    const std::vector<Block> blocks = blocks_of(canvas, view);
    const auto needed = [&](Density density, int given_up) {
        const float gap = canvas.px(theme::kGap);
        return std::ceil(total_of(heights_at(canvas, inner, blocks, density, given_up), gap));
    };
    // panels that are shown only if there is plenty of room are not a reason to scroll
    if (needed(Density::tight, 1) <= inner.height) { return box.height; }
    return needed(Density::roomy, 0) + 2.0F * canvas.px(14.0F);
}

void draw_column(const Canvas& canvas, const Box& box, const View& view) {
    // line between picture and column, unless the column has the whole width
    if (box.x > 0.0F) {
        canvas.fill({box.x, box.y, std::max(1.0F, canvas.px(1.0F)), box.height}, theme::kLine);
    }
    const Box inner = inside_column(canvas, box);
    const std::vector<Block> blocks = blocks_of(canvas, view);
    const Arrangement arrangement = arrange(canvas, inner, blocks);
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        if (arrangement.boxes[k].height > 0.0F) {
            blocks[k].draw(canvas, arrangement.boxes[k], arrangement.density);
        }
    }
}

}  // namespace jw::panels
