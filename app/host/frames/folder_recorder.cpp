#include "app/host/frames/frame_files.hpp"
#include "app/host/frames/recorder.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

class FolderRecorder : public Recorder {
public:
    FolderRecorder(std::filesystem::path folder, int first, int last)
        : folder_(std::move(folder)), files_(folder_, first, last) {}

    void add(int number, const View& view, double seconds, render::Image image) override {
        files_.add(number, view, seconds, std::move(image));
        ++count_;
    }
    std::string finish(Json head) override {
        files_.finish(std::move(head));
        return tr_count(
            count_, "{0} picture and manifest.json in {1}", "{0} pictures and manifest.json in {1}",
            folder_.string());
    }

private:
    std::filesystem::path folder_;
    FrameFiles files_;
    int count_ = 0;
};

}  // namespace

std::unique_ptr<Recorder> make_recorder(const std::filesystem::path& path, int first, int last) {
    return std::make_unique<FolderRecorder>(path, first, last);
}

}  // namespace jw::host
