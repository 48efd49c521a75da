#include "app/host/host.hpp"
#include "app/session/output/describe.hpp"
#include "app/session/output/json.hpp"
#include "app/session/wording/messages.hpp"

namespace jw::host {

namespace {

// a screen reader reads line by line: lines must not be long
constexpr int kDescribedWidth = 100;

/// Words of the tab, and of the step unless the figure of an exercise is shown: the lesson must not give away
/// the answer.
std::string text_of(const Host& host) {
    std::string text;
    if (host.state().tab == Tab::exercises) { text = host.exercise_text() + '\n'; }
    return host.shows_figure() ? text : text + describe(host.session()->view(), kDescribedWidth);
}

}  // namespace

std::string state_text(const Host& host) {
    Json json;
    json["shows_lesson"] = host.shows_lesson();
    json["language"] = language();
    json["dark"] = host.state().dark;
    json["text_scale"] = host.state().text_scale;
    json["notice"] = host.is_telling() ? words_of_waiting() : host.notice().text();
    json["mistakes"] = host.notice().mistakes();
    if (host.is_telling()) { json["told_part"] = host.told_part(); }
    if (!host.shows_lesson()) { return json.dump(); }
    const Session& session = *host.session();
    json["title"] = session.lesson().title;
    json["file"] = session.lesson().file_name;
    json["changed"] = session.is_changed();
    json["in_hand"] = session.in_hand();
    json["tried"] = session.tried();
    json["step"] = session.index();
    json["tab"] = word_of(kTabs, host.state().tab);
    const render::Camera& camera = host.camera();
    json["camera"] = Json::array();
    for (const render::Vector3d& part : {camera.eye, camera.target, camera.up}) {
        for (int k = 0; k < 3; ++k) { json["camera"].push_back(part(k)); }
    }
    json["text"] = text_of(host);
    return json.dump();
}

}  // namespace jw::host
