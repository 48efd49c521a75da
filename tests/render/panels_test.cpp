#include <catch2/catch.hpp>

#include <memory>

#include <imgui.h>

#include "render/fonts/fonts.hpp"
#include "render/passes/imgui_backend.hpp"
#include "tests/render/support.hpp"

namespace jw::render::test {
namespace {

constexpr int kPanelWidth = 320;
constexpr int kPanelHeight = 180;

/// ImGui with its fonts and our backend.
class PanelPainter {
public:
    explicit PanelPainter(float scale = 1.0F) : context_(ImGui::CreateContext()) {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {kPanelWidth, kPanelHeight};
        io.DeltaTime = 1.0F / 30.0F;
        fonts_ = load_fonts(scale);
        backend_ = std::make_unique<ImguiBackend>(offscreen_.gl());
    }
    ~PanelPainter() {
        backend_.reset();
        ImGui::DestroyContext(context_);
    }
    PanelPainter(const PanelPainter&) = delete;
    PanelPainter& operator=(const PanelPainter&) = delete;

    const GlFunctions& gl() const { return offscreen_.gl(); }

    void rescale(float scale) {
        fonts_ = load_fonts(scale);
        backend_->reload_fonts();
    }

    template <class Panels>
    Image paint(const Panels& panels) {
        offscreen_.begin_3d();
        offscreen_.begin_2d();
        ImGui::NewFrame();
        panels(*ImGui::GetForegroundDrawList(), fonts_);
        ImGui::Render();
        backend_->draw(*ImGui::GetDrawData(), offscreen_.size());
        return offscreen_.read();
    }

private:
    Offscreen offscreen_{kPanelWidth, kPanelHeight};
    ImGuiContext* context_;
    Fonts fonts_;
    std::unique_ptr<ImguiBackend> backend_;
};

/// The picture of what `panels` draws.
template <class Panels>
Image picture_of_panels(const Panels& panels) {
    return PanelPainter().paint(panels);
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
    CHECK(dark_pixels(image, {0.0, 0.0, kPanelWidth, kPanelHeight}) == dark_pixels(image, box));
}

TEST_CASE("a rectangle covers its pixels exactly and is clipped by the clip rectangle", "[render][panels]") {
    const Image image = picture_of_panels([](ImDrawList& list, const Fonts&) {
        list.PushClipRect({20.0F, 10.0F}, {60.0F, 40.0F});
        list.AddRectFilled({10.0F, 20.0F}, {300.0F, 30.0F}, kBlack);
        list.PopClipRect();
    });
    CHECK(dark_pixels(image, {20.0, 20.0, 40.0, 10.0}) == 400);
    CHECK(dark_pixels(image, {0.0, 0.0, kPanelWidth, kPanelHeight}) == 400);
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

TEST_CASE("fonts of another scale are drawn as in a program that began with it", "[render][panels]") {
    const auto text = [](ImDrawList& list, const Fonts& fonts) {
        list.AddText(fonts.normal, fonts.normal->FontSize, {20.0F, 20.0F}, kBlack, "rank 17 of 20");
        list.AddText(fonts.formula, fonts.formula->FontSize, {20.0F, 90.0F}, kBlack, "Φ ≡ θ × ω");
    };
    const Image large = PanelPainter(2.0F).paint(text);
    PanelPainter painter;
    CHECK_FALSE(painter.paint(text) == large);
    painter.rescale(2.0F);
    CHECK(painter.paint(text) == large);
}

TEST_CASE("a framebuffer scale other than 1 is refused", "[render][panels]") {
    PanelPainter painter;
    ImGui::GetIO().DisplayFramebufferScale = {2.0F, 2.0F};
    CHECK_THROWS_WITH(
        painter.paint([](ImDrawList&, const Fonts&) {}), Catch::Contains("the framebuffer scale is 1"));
}

namespace {

/// Three columns wide: rows that need padding in memory. Red grows to the right, green downwards.
Image chart() {
    Image image{3, 5, {}};
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 3; ++x) {
            for (const int c : {60 * x + 40, 40 * y + 20, 130}) {
                image.rgb.push_back(static_cast<std::uint8_t>(c));
            }
        }
    }
    return image;
}

std::array<int, 3> pixel(const Image& image, int x, int y) {
    const std::uint8_t* const p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

}  // namespace

TEST_CASE("a picture at its own size is drawn pixel for pixel", "[render][panels]") {
    PanelPainter painter;
    const PictureTexture texture(painter.gl(), chart());
    const Image drawn = painter.paint([&](ImDrawList& list, const Fonts&) {
        list.AddImage(texture.id(), {10.0F, 20.0F}, {13.0F, 25.0F});
        list.AddRectFilled({50.0F, 50.0F}, {60.0F, 60.0F}, kBlack);  // with the texture of the font again
    });
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 3; ++x) { CHECK(pixel(drawn, 10 + x, 20 + y) == pixel(chart(), x, y)); }
    }
    const std::array paper = pixel(drawn, 0, 0);
    for (const auto& [x, y] : {std::pair(9, 22), {13, 22}, {11, 19}, {11, 25}}) {
        CHECK(pixel(drawn, x, y) == paper);
    }
    CHECK(dark_pixels(drawn, {50.0, 50.0, 10.0, 10.0}) == 100);
}

TEST_CASE("a part of a picture is cut out by its uv", "[render][panels]") {
    PanelPainter painter;
    const PictureTexture texture(painter.gl(), chart());
    const Image drawn = painter.paint([&](ImDrawList& list, const Fonts&) {
        list.AddImage(
            texture.id(), {10.0F, 20.0F}, {12.0F, 22.0F}, {1.0F / 3.0F, 2.0F / 5.0F}, {1.0F, 4.0F / 5.0F});
    });
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 2; ++x) { CHECK(pixel(drawn, 10 + x, 20 + y) == pixel(chart(), 1 + x, 2 + y)); }
    }
}

TEST_CASE("an enlarged picture blends between its pixels and not across its edges", "[render][panels]") {
    PanelPainter painter;
    const PictureTexture texture(painter.gl(), {2, 1, {0, 0, 0, 200, 200, 200}});
    const Image drawn = painter.paint([&](ImDrawList& list, const Fonts&) {
        list.AddImage(texture.id(), {10.0F, 20.0F}, {50.0F, 40.0F});
    });
    CHECK(drawn.at(10, 30)[0] == 0);
    CHECK(drawn.at(49, 30)[0] == 200);
    // pixel centres at 29.5 and 30.5 lie 0.475 and 0.525 of the way; one step of 8 bits
    CHECK(drawn.at(29, 30)[0] == Approx(95.0).margin(1.0));
    CHECK(drawn.at(30, 30)[0] == Approx(105.0).margin(1.0));
}

TEST_CASE("a picture whose data do not fit its size is refused", "[render][panels]") {
    const Offscreen offscreen(16, 16);
    CHECK_THROWS_WITH(
        PictureTexture(offscreen.gl(), {2, 2, std::vector<std::uint8_t>(11)}),
        "a picture of 2 x 2 pixels cannot have 11 bytes");
    CHECK_THROWS_AS(PictureTexture(offscreen.gl(), Image{}), std::invalid_argument);
}

}  // namespace jw::render::test
