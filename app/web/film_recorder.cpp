#include "app/host/frames/recorder.hpp"
#include "app/session/wording/messages.hpp"
#include "render/animation/animation.hpp"
#include "render/atomic_file.hpp"

namespace jw::host {

namespace {

/// Pictures as one film, since a page can give files and no folders.
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
        return tr("{0} pictures in {1}", count_, file_.filename().string());
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
