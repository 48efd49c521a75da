#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include "app/session/beside/worker.hpp"

namespace jw {

/// Work by a `Worker`, whatever its result. Destroyed, it waits for the worker: a work that nobody wants any
/// more is told to stop, and kept until it has.
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
    using Work = std::function<Result(const std::stop_token&)>;

    explicit Background(Work work)
        : worker_([this, work = std::move(work)](const std::stop_token& stop) { run(work, stop); }) {}

    bool is_done() const override {
        const std::scoped_lock lock(mutex_);
        return done_;
    }
    void stop() override { worker_.request_stop(); }
    void wait() override { worker_.wait(); }

    /// Result, once it is done.
    /// @throws what the work threw
    Result take() {
        wait();
        if (failure_) { std::rethrow_exception(failure_); }
        return std::move(*result_);
    }

private:
    void run(const Work& work, const std::stop_token& stop) {
        try {
            Result found = work(stop);
            result_ = std::move(found);
        } catch (...) { failure_ = std::current_exception(); }
        const std::scoped_lock lock(mutex_);
        done_ = true;
    }

    mutable std::mutex mutex_;
    bool done_ = false;
    std::optional<Result> result_;  ///< of the worker alone until it has ended
    std::exception_ptr failure_;
    Worker worker_;  ///< last: it ends before what it writes into
};

}  // namespace jw
