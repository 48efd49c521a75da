#include "tests/soak/runner.hpp"

#include <chrono>
#include <fstream>
#include <sstream>

#include "lessons/write/writer.hpp"
#include "tests/soak/arbitrary.hpp"
#include "tests/support/generators/as_lesson.hpp"

namespace jw::test {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

int parts(const Generated& generated) {
    return static_cast<int>(
        generated.mechanism.bodies.size() + generated.mechanism.joints.size() +
        generated.mechanism.drivers.size() + generated.loads.springs.size() +
        generated.loads.rotational_springs.size() + generated.loads.forces.size() +
        generated.loads.torques.size());
}

std::string text_of(const Recipe& recipe) {
    std::ostringstream out;
    out << recipe;
    return out.str();
}

/// Listener without rapidcheck's output about every case on standard error; the answer holds the results.
class Silent : public rc::detail::TestListener {
public:
    void onTestCaseFinished(const rc::detail::CaseDescription& /*description*/) override {}
    void onShrinkTried(const rc::detail::CaseDescription& /*shrink*/, bool /*accepted*/) override {}
    void onTestFinished(
        const rc::detail::TestMetadata& /*metadata*/, const rc::detail::TestResult& /*result*/) override {}
};

/// Verdict on one mechanism; an exception is a failure.
Verdict verdict_on(const Property& property, const Generated& generated) {
    try {
        return property.of(generated);
    } catch (const std::exception& error) { return fails(std::string("thrown: ") + error.what()); }
}

/// One property over many recipes; rapidcheck calls it again with smaller recipes once it has failed.
class Asking {
public:
    Asking(const Property& property, const Asked& asked, Answer& answer)
        : property_(property), asked_(asked), answer_(answer), start_(Clock::now()) {}

    void operator()(const Recipe& drawn) {
        const Recipe recipe = property_.kind ? property_.kind(drawn) : drawn;
        const bool shrinking = answer_.wrong.has_value();
        if (seconds_since(start_) > (shrinking ? asked_.shrink_seconds : asked_.seconds)) { return; }
        const std::optional<Generated> generated = mechanism_of(recipe);
        if (!generated) {
            count("no mechanism, or a singular start", shrinking);
            return;
        }
        const Verdict verdict = verdict_on(property_, *generated);
        if (verdict.kind == Verdict::Kind::not_asked) { count(verdict.why, shrinking); }
        if (verdict.kind == Verdict::Kind::holds && !shrinking) { ++answer_.held; }
        if (verdict.kind != Verdict::Kind::fails) { return; }
        if (!shrinking) { start_ = Clock::now(); }
        const int before = shrinking ? answer_.wrong->parts_before : parts(*generated);
        answer_.wrong = Counterexample{*generated, verdict.why, text_of(recipe), before};
        RC_FAIL(verdict.why);
    }

private:
    void count(const std::string& why, bool shrinking) {
        if (!shrinking) { ++answer_.not_asked[why]; }
    }

    const Property& property_;
    const Asked& asked_;
    Answer& answer_;
    Clock::time_point start_;
};

}  // namespace

Answer ask(const Property& property, const Asked& asked) {
    Answer answer;
    rc::detail::TestParams params;
    params.seed = asked.seed;
    params.maxSuccess = asked.count;
    // lists grow with the size, up to nine bodies at 100
    params.maxSize = std::max(10, 100 * property.most_bodies / 9);
    rc::detail::TestMetadata metadata;
    metadata.id = property.name;
    Asking asking(property, asked, answer);
    Silent silent;
    const auto one = [&](const Recipe& recipe) { asking(recipe); };
    rc::detail::checkTestable(one, metadata, params, silent);
    return answer;
}

WrittenDown read_counterexample(const std::filesystem::path& path) {
    const std::string mark = "Counterexample: ";
    std::ifstream file(path);
    WrittenDown out;
    for (std::string line; out.property.empty() && std::getline(file, line);) {
        const std::size_t found = line.find(mark);
        if (found == std::string::npos) { continue; }
        const std::string rest = line.substr(found + mark.size());
        out.property = rest.substr(0, rest.find('"'));
    }
    const std::optional<Recipe> recipe = recipe_in(file);
    if (!recipe) { throw std::runtime_error(path.string() + ": no counterexample with its recipe"); }
    out.recipe = *recipe;
    return out;
}

Verdict ask_of(const Property& property, const Recipe& recipe) {
    const std::optional<Generated> generated = mechanism_of(recipe);
    return generated ? verdict_on(property, *generated) : not_asked("no mechanism, or a singular start");
}

std::string lesson_text_of(const Property& property, const Asked& asked, const Counterexample& wrong) {
    const std::string text = property.says + "\nHere it does not: " + wrong.why + "\nSeed " +
                             std::to_string(asked.seed) + ".\n" + wrong.recipe;
    return lesson_text(lesson_of(wrong.generated, "Counterexample: " + property.name, text));
}

}  // namespace jw::test
