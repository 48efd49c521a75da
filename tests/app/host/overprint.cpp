#include "tests/app/host/overprint.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <imgui.h>
#include <imgui_internal.h>

namespace jw::test {

namespace {

constexpr int kSolid = 230;  // alpha from which something hides what is below it
constexpr int kInk = 140;    // of a letter's pixel; its soft edge may touch a neighbour
// pixels of ink: a mark that leans over to the next letter is still read
constexpr int kFewPixels = 3;

int alpha_of(ImU32 colour) { return static_cast<int>((colour >> IM_COL32_A_SHIFT) & 0xFFU); }

/// A rectangle of two triangles: a letter, a picture or a filled rectangle.
struct Quad {
    ImVec2 low, high;
    ImVec2 uv_low, uv_high;
};

/// A letter of the frame, with counts of its pixels.
struct Letter {
    int layer = 0;  ///< of the draw lists, from the lowest
    Quad quad;
    int ink = 0;      ///< pixels drawn
    int covered = 0;  ///< of these, drawn over later by something solid of the same layer
    int printed = 0;  ///< of these, drawn over by another letter
    int cut = 0;      ///< pixels outside of the edge
};

/// Layer of a draw list: 0 for windows side by side; popups, tips and sheets lie above and may cover them.
int layer_of(const ImDrawList& list, int number) {
    const std::string name = list._OwnerName == nullptr ? "" : list._OwnerName;
    const bool above = (name.starts_with("##") && name != "##Background") || name.starts_with("keys");
    return above ? number + 1 : 0;
}

class Reader {
public:
    explicit Reader(const ImDrawData& data)
        : width_(static_cast<int>(data.DisplaySize.x)), height_(static_cast<int>(data.DisplaySize.y)) {
        owner_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), -1);
        ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&atlas_, &atlas_width_, &atlas_height_);
    }

    void read(const ImDrawList& list, int layer) {
        in_background_ = std::string("##Background") == list._OwnerName;
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const bool letters = command.TextureId == ImGui::GetIO().Fonts->TexID;
            for (unsigned k = 0; k + 2 < command.ElemCount;) {
                const ImDrawIdx* const index = list.IdxBuffer.Data + command.IdxOffset + k;
                const ImDrawVert* const vertices = list.VtxBuffer.Data + command.VtxOffset;
                const bool more = k + 5 < command.ElemCount;
                if (letters && more && is_letter(index, vertices)) {
                    add_letter(index, vertices, command.ClipRect, layer);
                    k += 6;
                    continue;
                }
                fill(index, vertices, command.ClipRect, layer);
                k += 3;
            }
        }
    }

    std::vector<std::string> faults() const {
        std::vector<std::string> found;
        for (const Letter& letter : letters_) {
            const char* what = nullptr;
            if (letter.printed > kFewPixels) { what = "is printed over"; }
            if (letter.covered > kFewPixels) { what = "is covered"; }
            if (letter.cut > kFewPixels) { what = "is cut"; }
            if (what == nullptr) { continue; }
            const auto at = [](float x) { return std::to_string(static_cast<int>(x)); };
            found.push_back(
                "a letter in layer " + std::to_string(letter.layer) + " at " + at(letter.quad.low.x) + ", " +
                at(letter.quad.low.y) + " " + what);
        }
        return found;
    }

private:
    /// True for two triangles over one rectangle whose texture is not the white pixel.
    bool is_letter(const ImDrawIdx* index, const ImDrawVert* v) const {
        const ImDrawVert& a = v[index[0]];
        const ImDrawVert& c = v[index[2]];
        const bool rectangle = index[3] == index[0] && index[4] == index[2] && a.pos.x < c.pos.x &&
                               a.pos.y < c.pos.y && v[index[1]].pos.y == a.pos.y;
        return rectangle && (a.uv.x != c.uv.x || a.uv.y != c.uv.y);
    }

    bool has_ink(const Quad& q, float x, float y) const {
        const float u = q.uv_low.x + (x - q.low.x) / (q.high.x - q.low.x) * (q.uv_high.x - q.uv_low.x);
        const float v = q.uv_low.y + (y - q.low.y) / (q.high.y - q.low.y) * (q.uv_high.y - q.uv_low.y);
        const int column =
            std::clamp(static_cast<int>(u * static_cast<float>(atlas_width_)), 0, atlas_width_ - 1);
        const int row =
            std::clamp(static_cast<int>(v * static_cast<float>(atlas_height_)), 0, atlas_height_ - 1);
        return atlas_[row * atlas_width_ + column] >= kInk;
    }

    int& owner(int x, int y) { return owner_[static_cast<std::size_t>(y * width_ + x)]; }

    void add_letter(const ImDrawIdx* index, const ImDrawVert* v, const ImVec4& clip, int layer) {
        const ImDrawVert& a = v[index[0]];
        const ImDrawVert& c = v[index[2]];
        // the light around letters over the picture does not count
        if (alpha_of(a.col) < kSolid) { return; }
        const auto self = static_cast<int>(letters_.size());
        letters_.push_back({layer, {a.pos, c.pos, a.uv, c.uv}});
        const bool scrolls = is_scrolled(clip);
        const Quad& q = letters_.back().quad;
        for (int y = static_cast<int>(std::floor(q.low.y)); y < static_cast<int>(std::ceil(q.high.y)); ++y) {
            for (int x = static_cast<int>(std::floor(q.low.x)); x < static_cast<int>(std::ceil(q.high.x));
                 ++x) {
                const float px = static_cast<float>(x) + 0.5F;
                const float py = static_cast<float>(y) + 0.5F;
                if (px < q.low.x || px >= q.high.x || py < q.low.y || py >= q.high.y) { continue; }
                if (has_ink(q, px, py)) { put(self, x, y, clip, scrolls); }
            }
        }
    }

    void put(int self, int x, int y, const ImVec4& clip, bool scrolls) {
        Letter& letter = letters_[static_cast<std::size_t>(self)];
        const float px = static_cast<float>(x) + 0.5F;
        const float py = static_cast<float>(y) + 0.5F;
        const bool beside = px < clip.x || px > clip.z || x < 0 || x >= width_;
        const bool above = py < clip.y || py > clip.w || y < 0 || y >= height_;
        if (beside || above) {
            letter.cut += beside || !scrolls ? 1 : 0;
            return;
        }
        int& now = owner(x, y);
        if (now >= 0 && now != self) {
            Letter& below = letters_[static_cast<std::size_t>(now)];
            if (below.layer == letter.layer) { ++below.printed; }
        }
        ++letter.ink;
        now = self;
    }

    /// True if the window that clips there scrolls: what is cut can be brought into sight.
    bool is_scrolled(const ImVec4& clip) const {
        // within the column or the caption, which scroll by themselves
        if (in_background_ && (clip.y > 0.0F || clip.w < static_cast<float>(height_))) { return true; }
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (!window->Active || window->ScrollMax.y <= 0.0F) { continue; }
            const ImRect& inner = window->InnerClipRect;
            if (std::abs(inner.Min.y - clip.y) < 2.0F || std::abs(inner.Max.y - clip.w) < 2.0F) {
                return true;
            }
        }
        return false;
    }

    void fill(const ImDrawIdx* index, const ImDrawVert* v, const ImVec4& clip, int layer) {
        const ImVec2 p[3] = {v[index[0]].pos, v[index[1]].pos, v[index[2]].pos};
        for (int k = 0; k < 3; ++k) {
            if (alpha_of(v[index[k]].col) < kSolid) { return; }
        }
        const float left = std::max({0.0F, clip.x, std::min({p[0].x, p[1].x, p[2].x})});
        const float right =
            std::min({static_cast<float>(width_), clip.z, std::max({p[0].x, p[1].x, p[2].x})});
        const float top = std::max({0.0F, clip.y, std::min({p[0].y, p[1].y, p[2].y})});
        const float bottom =
            std::min({static_cast<float>(height_), clip.w, std::max({p[0].y, p[1].y, p[2].y})});
        const auto side = [](const ImVec2& a, const ImVec2& b, float x, float y) {
            return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
        };
        const float turn = side(p[0], p[1], p[2].x, p[2].y) < 0.0F ? -1.0F : 1.0F;
        for (int y = static_cast<int>(top); static_cast<float>(y) < bottom; ++y) {
            for (int x = static_cast<int>(left); static_cast<float>(x) < right; ++x) {
                const float px = static_cast<float>(x) + 0.5F;
                const float py = static_cast<float>(y) + 0.5F;
                if (px < left || px > right || py < top || py > bottom) { continue; }
                bool inside = true;
                for (int k = 0; k < 3; ++k) {
                    inside = inside && turn * side(p[k], p[(k + 1) % 3], px, py) >= 0.0F;
                }
                if (inside) { cover(owner(x, y), layer); }
            }
        }
    }

    void cover(int& now, int layer) {
        if (now >= 0 && letters_[static_cast<std::size_t>(now)].layer == layer) {
            ++letters_[static_cast<std::size_t>(now)].covered;
        }
        now = -1;
    }

    int width_, height_;
    bool in_background_ = false;
    std::vector<int> owner_;  ///< index of the letter on every pixel, -1: none
    std::vector<Letter> letters_;
    unsigned char* atlas_ = nullptr;
    int atlas_width_ = 0;
    int atlas_height_ = 0;
};

}  // namespace

std::vector<std::string> unreadable_letters() {
    const ImDrawData* const data = ImGui::GetDrawData();
    if (data == nullptr || !data->Valid) { return {"nothing was drawn"}; }
    Reader reader(*data);
    for (int k = 0; k < data->CmdListsCount; ++k) {
        reader.read(*data->CmdLists[k], layer_of(*data->CmdLists[k], k));
    }
    return reader.faults();
}

}  // namespace jw::test
