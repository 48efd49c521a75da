#pragma once

#include <string>
#include <vector>

/// Reports in the format of JUnit, which services for continuous integration read.
namespace jw {

/// The cases of one lesson, submission, ...
class JunitSuite {
public:
    /// @param name  of the suite, and of the class of its cases
    explicit JunitSuite(const std::string& name);

    // one case each; the texts are escaped here
    void passed(const std::string& name) { add(name, {}); }
    void failed(
        const std::string& name, const std::string& type, const std::string& message,
        const std::string& text = {});
    void error(
        const std::string& name, const std::string& type, const std::string& message,
        const std::string& text);
    void skipped(const std::string& name, const std::string& message);

private:
    friend std::string junit_report(const std::string& name, const std::vector<JunitSuite>& suites);

    struct Counts {
        int tests = 0;
        int failures = 0;
        int errors = 0;
        int skipped = 0;

        std::string attributes() const;
    };

    void add(const std::string& name, const std::string& verdict);

    std::string name_;  ///< escaped
    std::string cases_;
    Counts counts_;
};

/// The document. @param name  of all suites together
std::string junit_report(const std::string& name, const std::vector<JunitSuite>& suites);

}  // namespace jw
