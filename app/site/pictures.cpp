#include "app/site/pictures.hpp"

#include <array>
#include <utility>

#include "app/host/frames/frame_painter.hpp"
#include "render/files/png.hpp"

namespace jw::site {

namespace {

// size of the frame, as in the program
constexpr int kFrameWidth = 1280;
constexpr int kFrameHeight = 720;
// size of the picture of a station: twice the size on the page, for screens of high resolution
constexpr int kPictureWidth = 800;
constexpr int kPictureHeight = 500;

View view_at(const Story& story, int step) { return view_of(story, step, ViewParts::without_matrix); }

}  // namespace

render::Image halved(const render::Image& image) {
    render::Image half;
    half.width = image.width / 2;
    half.height = image.height / 2;
    const bool is_opaque = image.alpha.empty();
    for (int y = 0; y < half.height; ++y) {
        for (int x = 0; x < half.width; ++x) {
            // transparent pixels have no colour, so the mean is weighted by opacity
            std::array<unsigned, 3> sum{};
            unsigned weight = 0;
            for (const auto& [dx, dy] :
                 {std::pair{0, 0}, std::pair{1, 0}, std::pair{0, 1}, std::pair{1, 1}}) {
                const std::uint8_t* const pixel = image.at(2 * x + dx, 2 * y + dy);
                const unsigned alpha =
                    is_opaque ? 255U : image.alpha[static_cast<std::size_t>(pixel - image.rgb.data()) / 3];
                for (std::size_t c = 0; c < 3; ++c) { sum[c] += alpha * pixel[c]; }
                weight += alpha;
            }
            for (const unsigned of_channel : sum) {
                half.rgb.push_back(
                    static_cast<std::uint8_t>(weight == 0 ? 0 : (of_channel + weight / 2) / weight));
            }
            if (!is_opaque) { half.alpha.push_back(static_cast<std::uint8_t>((weight + 2) / 4)); }
        }
    }
    return half;
}

void draw_pictures(
    const SiteLesson& lesson, const Story& story, const std::vector<Station>& stations,
    const TakePicture& take) {
    {
        host::FramePainter frame(story, kFrameWidth, kFrameHeight);
        take(path_of_frame(lesson), render::encode_png(frame.paint(view_of(story, story.last_assembled()))));
    }
    host::FrameLook look;
    look.has_panels = false;
    look.is_opaque = false;
    host::FramePainter alone(story, kPictureWidth, kPictureHeight, look);
    for (const Station& station : stations) {
        if (!station.pictured) { continue; }
        take(path_of_picture(lesson, station), render::encode_png(alone.paint(view_at(story, station.told))));
    }
    take(
        path_of_card(lesson),
        render::encode_png(halved(alone.paint(view_at(story, story.last_assembled())))));
}

}  // namespace jw::site
