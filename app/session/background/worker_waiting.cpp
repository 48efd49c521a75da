#include <algorithm>
#include <chrono>
#include <deque>
#include <utility>

#include "app/session/background/worker.hpp"

namespace jw {

struct Worker::Running {
    Piece piece;  ///< nothing once all is done
    std::stop_source source;

    void advance();
};

namespace {

/// Workers with work left, the oldest first.
std::deque<Worker*>& waiting() {
    static std::deque<Worker*> all;
    return all;
}

}  // namespace

void Worker::Running::advance() {
    if (!piece(source.get_token())) { piece = {}; }
}

Worker::Worker(Piece piece) : running_(std::make_unique<Running>(Running{std::move(piece), {}})) {
    waiting().push_back(this);
}

Worker::~Worker() { std::erase(waiting(), this); }

void Worker::request_stop() { running_->source.request_stop(); }

void Worker::wait() {
    while (running_->piece) { running_->advance(); }
    std::erase(waiting(), this);
}

bool run_waiting_work(double seconds) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    bool is_any_done = false;
    while (!waiting().empty() && (!is_any_done || Clock::now() < end)) {
        Worker& first = *waiting().front();
        first.running_->advance();
        if (!first.running_->piece) { waiting().pop_front(); }
        is_any_done = true;
    }
    return is_any_done;
}

}  // namespace jw
