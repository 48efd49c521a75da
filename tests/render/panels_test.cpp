#include <catch2/catch.hpp>

#include <imgui.h>

#include "render/fonts.hpp"
#include "render/imgui_backend.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 180;

/// The picture of what `panels` draws.
template <class Panels>
Image picture_of_panels(const Panels& panels) {
    Offscreen offscreen(kWidth, kHeight);
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {kWidth, kHeight};
    io.DeltaTime = 1.0F / 30.0F;
    const Fonts fonts = load_fonts(1.0F);
    Image image;
    {
        const ImguiBackend backend(offscreen.gl());
        offscreen.begin_3d();
        offscreen.begin_2d();
        ImGui::NewFrame();
        panels(*ImGui::GetForegroundDrawList(), fonts);
        ImGui::Render();
        backend.draw(*ImGui::GetDrawData(), offscreen.size());
        image = offscreen.read();
    }
    ImGui::DestroyContext();
    return image;
}

int dark_pixels(const Image& image, const Rect& where) {
    int count = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (where.contains(x + 0.5, y + 0.5) && image.at(x, y)[0] < 128) { ++count; }
        }
    }
    return count;
}

constexpr ImU32 kBlack = IM_COL32(0, 0, 0, 255);

}  // namespace

TEST_CASE("text is drawn where it was put, dark and nowhere else", "[render][panels]") {
    const Image image = picture_of_panels([](ImDrawList& list, const Fonts& fonts) {
        list.AddText(fonts.title, fonts.title->FontSize, {100.0F, 60.0F}, kBlack, "HHHH");
    });
    const Rect box{100.0, 60.0, 80.0, 23.0};
    CHECK(dark_pixels(image, box) > 200);
    CHECK(dark_pixels(image, {0.0, 0.0, kWidth, kHeight}) == dark_pixels(image, box));
}

TEST_CASE("a rectangle covers its pixels exactly and is clipped by the clip rectangle", "[render][panels]") {
    const Image image = picture_of_panels([](ImDrawList& list, const Fonts&) {
        list.PushClipRect({20.0F, 10.0F}, {60.0F, 40.0F});
        list.AddRectFilled({10.0F, 20.0F}, {300.0F, 30.0F}, kBlack);
        list.PopClipRect();
    });
    CHECK(dark_pixels(image, {20.0, 20.0, 40.0, 10.0}) == 400);
    CHECK(dark_pixels(image, {0.0, 0.0, kWidth, kHeight}) == 400);
}

TEST_CASE("more vertices than 16-bit indices reach are drawn", "[render][panels]") {
    const Image image = picture_of_panels([](ImDrawList& list, const Fonts&) {
        for (int n = 0; n < 40000; ++n) { list.AddRectFilled({0.0F, 0.0F}, {1.0F, 1.0F}, IM_COL32_WHITE); }
        list.AddRectFilled({50.0F, 50.0F}, {60.0F, 60.0F}, kBlack);
    });
    CHECK(dark_pixels(image, {50.0, 50.0, 10.0, 10.0}) == 100);
}

TEST_CASE("half transparent ink darkens the paper by half", "[render][panels]") {
    const Image image = picture_of_panels([](ImDrawList& list, const Fonts&) {
        list.AddRectFilled({0.0F, 0.0F}, {50.0F, 50.0F}, IM_COL32(0, 0, 0, 128));
    });
    const double paper = 255.0 * static_cast<double>(palette::kPaper.r);
    CHECK(image.at(25, 25)[0] == Approx(paper * (1.0 - 128.0 / 255.0)).margin(1.0));  // one step of 8 bits
}

TEST_CASE("panels of two runs are equal byte for byte", "[render][panels]") {
    const auto draw = [] {
        return picture_of_panels([](ImDrawList& list, const Fonts& fonts) {
            list.AddText(fonts.formula, fonts.formula->FontSize, {10.3F, 20.0F}, kBlack, "Φ ≡ θ × ω");
            list.AddText(fonts.small, fonts.small->FontSize, {10.0F, 60.0F}, kBlack, "rank 17 of 20");
        });
    };
    CHECK(draw() == draw());
}

}  // namespace jw::render::test
