#include <algorithm>
#include <deque>
#include <utility>

#include "app/session/beside/worker.hpp"

namespace jw {

struct Worker::Running {
    Work work;
    std::stop_source source;

    void run();
};

namespace {

/// The functions that wait, the oldest first.
std::deque<Worker*>& waiting() {
    static std::deque<Worker*> all;
    return all;
}

}  // namespace

void Worker::Running::run() {
    if (const Work ready = std::exchange(work, {})) { ready(source.get_token()); }
}

Worker::Worker(Work work) : running_(std::make_unique<Running>(Running{std::move(work), {}})) {
    waiting().push_back(this);
}

Worker::~Worker() { std::erase(waiting(), this); }

void Worker::request_stop() {
    running_->source.request_stop();
    running_->work = {};
}

void Worker::wait() {
    std::erase(waiting(), this);
    running_->run();
}

bool run_waiting_work() {
    if (waiting().empty()) { return false; }
    waiting().front()->wait();
    return true;
}

}  // namespace jw
