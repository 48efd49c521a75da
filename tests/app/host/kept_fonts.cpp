#include "tests/app/host/kept_fonts.hpp"

#include <map>
#include <tuple>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

namespace jw::test {

namespace {

struct Kept {
    ~Kept() { atlas.Locked = false; }  // in case a frame ended in the middle

    ImFontAtlas atlas;
    render::Fonts fonts;
};

/// The context uses the atlas from now on, and leaves it when it goes.
void use(ImFontAtlas& atlas) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    if (std::exchange(context.FontAtlasOwnedByContext, false)) { IM_DELETE(context.IO.Fonts); }
    context.IO.Fonts = &atlas;
    atlas.Locked = false;
}

}  // namespace

render::Fonts kept_fonts(float scale, std::u32string_view others, render::AtlasSize size) {
    static std::map<std::tuple<float, std::u32string, render::AtlasSize>, Kept> all;
    Kept& kept = all[{scale, std::u32string(others), size}];
    use(kept.atlas);
    if (kept.fonts.normal == nullptr) { kept.fonts = render::load_fonts(scale, others, size); }
    ImGui::GetIO().FontDefault = kept.fonts.normal;
    return kept.fonts;
}

}  // namespace jw::test
