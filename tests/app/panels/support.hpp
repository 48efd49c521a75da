#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include <imgui.h>

#include "app/panels/frame/frame.hpp"
#include "app/panels/parts/canvas.hpp"
#include "render/fonts/fonts.hpp"

/// Panels without a renderer: what they would draw is a list of vertices.
namespace jw::panels::test {

struct Size {
    int width;
    int height;
};

/// An ImGui context with the fonts of a frame of this size, and one draw list.
class Surface {
public:
    explicit Surface(Size size = {1280, 720}) : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DeltaTime = 1.0F / 30.0F;
        io.DisplaySize = {static_cast<float>(size.width), static_cast<float>(size.height)};
        fonts_ = render::load_fonts(scale_of(size.width, size.height));
        ImGui::NewFrame();  // prepares the data for round corners
        list_ = std::make_unique<ImDrawList>(ImGui::GetDrawListSharedData());
        clear();
    }
    ~Surface() {
        list_.reset();
        ImGui::EndFrame();
        ImGui::DestroyContext(context_);
    }
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    Canvas canvas() const { return {list_.get(), fonts_}; }
    const render::Fonts& fonts() const { return fonts_; }

    /// Empties the list. Nothing is clipped, so that drawing outside of its box is found.
    void clear() {
        constexpr float far = 1e5F;
        list_->_ResetForNewFrame();
        list_->PushTextureID(ImGui::GetIO().Fonts->TexID);
        list_->PushClipRect({-far, -far}, {far, far});
    }

    int vertices() const { return list_->VtxBuffer.Size; }

    /// Smallest box around everything drawn.
    Box drawn() const {
        float left = 1e9F;
        float top = 1e9F;
        float right = -1e9F;
        float bottom = -1e9F;
        for (const ImDrawVert& vertex : list_->VtxBuffer) {
            left = std::min(left, vertex.pos.x);
            top = std::min(top, vertex.pos.y);
            right = std::max(right, vertex.pos.x);
            bottom = std::max(bottom, vertex.pos.y);
        }
        return {left, top, right - left, bottom - top};
    }

private:
    ImGuiContext* context_;
    render::Fonts fonts_;
    std::unique_ptr<ImDrawList> list_;
};

/// Places for a panel: low, wide, tall, large.
inline constexpr std::array kPlaces{
    Box{10.0F, 20.0F, 480.0F, 260.0F}, Box{0.0F, 0.0F, 760.0F, 420.0F}, Box{5.0F, 5.0F, 480.0F, 520.0F},
    Box{0.0F, 0.0F, 1500.0F, 800.0F}};

/// Box that is one pixel larger on each side, because lines are smoothed over a pixel.
inline Box with_fringe(const Box& box) { return shrunk(box, -1.0F, -1.0F); }

}  // namespace jw::panels::test
