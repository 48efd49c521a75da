#include "app/host/frames/recorder.hpp"
#include "app/session/wording/messages.hpp"
#include "render/animation/animation.hpp"
#include "render/files/atomic_file.hpp"

namespace jw::host {

namespace {

/// Records pictures as one film, because a page can offer files but not folders.
class FilmRecorder : public Recorder {
public:
    explicit FilmRecorder(std::filesystem::path file)
        : file_(std::move(file)), film_(render::make_apng(render::Repeat::once)) {}

    void add(int /*number*/, const View& /*view*/, double seconds, render::Image image) override {
        film_->add(std::move(image), seconds);
        ++count_;
    }
    std::string finish(Json /*head*/) override {
        render::write_file_atomically(file_, film_->finish());
        return tr_count(count_, "{0} picture in {1}", "{0} pictures in {1}", file_.filename().string());
    }

private:
    std::filesystem::path file_;
    std::unique_ptr<render::Animation> film_;
    int count_ = 0;
};

}  // namespace

std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& path, int /*first*/, int /*last*/) {
    return std::make_unique<FilmRecorder>(path.string() + ".apng");
}

}  // namespace jw::host
