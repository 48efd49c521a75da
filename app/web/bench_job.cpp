#include "app/session/benchmark/bench_job.hpp"

#include <emscripten/emscripten.h>

#include <algorithm>
#include <map>

#include "app/session/output/json.hpp"
#include "app/web/browser.hpp"
#include "lessons/read/reader.hpp"
#include "lessons/write/writer.hpp"

/// A benchmark in another copy of the program: the page has no threads, and a reference may take a minute.
namespace jw {

struct BenchJob::Running {
    int number = 0;
};

namespace {

/// Results of a job so far.
struct Measured {
    BenchJob::News news;
    std::uint64_t version = 0;
};

/// Results of the jobs that are waited for, by their numbers.
std::map<int, Measured>& results() {
    static std::map<int, Measured> all;
    return all;
}

/// The data of a run from which prices are computed.
Json json_of_run(const BenchRun& run) {
    Json points = Json::array();
    for (const BenchPoint& point : run.points) {
        points.push_back({number(point.setting), number(point.cpu), number(point.position)});
    }
    return {{"method", std::string(entry_of(run.method).name)}, {"points", std::move(points)}};
}

double known(const Json& value) { return value.is_number() ? value.get<double>() : kNotKnown; }

BenchRun run_of_json(const Json& json) {
    BenchRun run;
    const std::string method = json.at("method");
    run.method = std::ranges::find(kMethods, method, &MethodName::name)->method;
    for (const Json& told : json.at("points")) {
        BenchPoint& point = run.points.emplace_back();
        point.setting = known(told.at(0));
        point.cpu = known(told.at(1));
        point.position = known(told.at(2));
    }
    return run;
}

std::string text_of_news(const BenchJob::News& news) {
    Json runs = Json::array();
    for (const BenchRun& run : news.runs) { runs.push_back(json_of_run(run)); }
    return json_document(
        Json{
            {"runs", std::move(runs)},
            {"origin", news.origin},
            {"failure", news.failure},
            {"done", news.done}},
        -1);
}

BenchJob::News news_of_text(const std::string& text) {
    const Json json = Json::parse(text);
    BenchJob::News news;
    for (const Json& run : json.at("runs")) { news.runs.push_back(run_of_json(run)); }
    news.origin = json.at("origin");
    news.failure = json.at("failure");
    news.done = json.at("done");
    return news;
}

}  // namespace

BenchJob::BenchJob(Lesson lesson, std::optional<Reference>, BenchPlan plan)
    : running_(std::make_unique<Running>()) {
    static int last = 0;
    running_->number = ++last;
    results()[running_->number] = {};
    web::begin_measuring(running_->number, lesson_text(lesson), std::string(entry_of(plan.treatment).name));
}

BenchJob::~BenchJob() {
    results().erase(running_->number);
    web::end_measuring(running_->number);
}

std::uint64_t BenchJob::version() const { return results().at(running_->number).version; }
BenchJob::News BenchJob::news() const { return results().at(running_->number).news; }

}  // namespace jw

extern "C" {

/// Stores the results that another copy of the program has measured.
EMSCRIPTEN_KEEPALIVE void jw_measured(int number, const char* news) {
    const auto found = jw::results().find(number);
    if (found == jw::results().end()) { return; }
    found->second.news = jw::news_of_text(news);
    ++found->second.version;
    if (found->second.news.done) { jw::web::end_measuring(number); }
}

/// Measures a lesson in this copy of the program, and reports to the page around it.
EMSCRIPTEN_KEEPALIVE void jw_measure(const char* lesson, const char* treatment) {
    const jw::ReadResult read = jw::read_lesson(lesson, "measured.toml");
    const auto tell = [](const jw::BenchJob::News& news) { jw::web::tell_measured(jw::text_of_news(news)); };
    if (!read.lesson) {
        jw::BenchJob::News news;
        news.failure = read.report();
        news.done = true;
        return tell(news);
    }
    jw::BenchPlan plan;
    plan.treatment =
        std::ranges::find(jw::kTreatments, std::string_view(treatment), &jw::TreatmentName::name)->treatment;
    jw::measure_prices(*read.lesson, {}, plan, tell, {});
}

}  // extern "C"
