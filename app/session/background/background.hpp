#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "app/session/background/worker.hpp"

namespace jw {

/// Work of a `Worker` with a result of any type. The destructor waits for the worker. Work that is not wanted
/// any more is told to stop, and is kept until it has stopped.
class BackgroundWork {
public:
    virtual ~BackgroundWork() = default;
    BackgroundWork() = default;
    BackgroundWork(const BackgroundWork&) = delete;
    BackgroundWork& operator=(const BackgroundWork&) = delete;

    virtual bool is_done() const = 0;
    virtual void stop() = 0;
    virtual void wait() = 0;
};

template <class Result>
class Background : public BackgroundWork {
public:
    /// Does a piece of the work, like `Worker::Piece`. @return nothing while there is more to do
    using Piece = std::function<std::optional<Result>(const std::stop_token&)>;

    explicit Background(Piece piece)
        : worker_(
              [this, piece = std::move(piece)](const std::stop_token& stop) { return go_on(piece, stop); }) {}

    bool is_done() const override {
        const std::scoped_lock lock(mutex_);
        return done_;
    }
    void stop() override { worker_.request_stop(); }
    void wait() override { worker_.wait(); }

    /// Waits for the work and returns its result.
    /// @throws what the work threw; std::bad_optional_access if it was stopped before
    Result take() {
        wait();
        if (failure_) { std::rethrow_exception(failure_); }
        return std::move(result_).value();
    }

private:
    /// @return true while there is more to do
    bool go_on(const Piece& piece, const std::stop_token& stop) {
        try {
            if (!stop.stop_requested()) { result_ = piece(stop); }
        } catch (...) { failure_ = std::current_exception(); }
        if (!result_ && !failure_ && !stop.stop_requested()) { return true; }
        const std::scoped_lock lock(mutex_);
        done_ = true;
        return false;
    }

    mutable std::mutex mutex_;
    bool done_ = false;
    std::optional<Result> result_;  ///< only the worker uses it until it has ended
    std::exception_ptr failure_;
    Worker worker_;  ///< last: it ends before the members that it writes to
};

}  // namespace jw
