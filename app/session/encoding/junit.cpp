#include "app/session/encoding/junit.hpp"

#include "app/session/encoding/html_words.hpp"

namespace jw {

namespace {

std::string element(
    const std::string& tag, const std::string& type, const std::string& message, const std::string& text) {
    const std::string head =
        "<" + tag + " type=\"" + xml_attribute(type) + "\" message=\"" + xml_attribute(message) + "\"";
    return text.empty() ? head + "/>" : head + ">" + xml_text(text) + "</" + tag + ">";
}

}  // namespace

JunitSuite::JunitSuite(const std::string& name) : name_(xml_attribute(name)) {}

void JunitSuite::failed(
    const std::string& name, const std::string& type, const std::string& message, const std::string& text) {
    ++counts_.failures;
    add(name, element("failure", type, message, text));
}

void JunitSuite::error(
    const std::string& name, const std::string& type, const std::string& message, const std::string& text) {
    ++counts_.errors;
    add(name, element("error", type, message, text));
}

void JunitSuite::skipped(const std::string& name, const std::string& message) {
    ++counts_.skipped;
    add(name, "<skipped message=\"" + xml_attribute(message) + "\"/>");
}

void JunitSuite::add(const std::string& name, const std::string& verdict) {
    ++counts_.tests;
    cases_ += "    <testcase classname=\"" + name_ + "\" name=\"" + xml_attribute(name) + "\"" +
              (verdict.empty() ? "/>\n" : ">\n      " + verdict + "\n    </testcase>\n");
}

/// Attributes of one suite and of all suites together: the schema of Jenkins allows `skipped` only for one
/// suite.
std::string JunitSuite::Counts::attributes() const {
    return " tests=\"" + std::to_string(tests) + "\" failures=\"" + std::to_string(failures) +
           "\" errors=\"" + std::to_string(errors) + "\"";
}

std::string junit_report(const std::string& name, const std::vector<JunitSuite>& suites) {
    JunitSuite::Counts all;
    std::string text;
    for (const JunitSuite& suite : suites) {
        all.tests += suite.counts_.tests;
        all.failures += suite.counts_.failures;
        all.errors += suite.counts_.errors;
        text += "  <testsuite name=\"" + suite.name_ + "\"" + suite.counts_.attributes() + " skipped=\"" +
                std::to_string(suite.counts_.skipped) + "\">\n" + suite.cases_ + "  </testsuite>\n";
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" + xml_attribute(name) + "\"" +
           all.attributes() + ">\n" + text + "</testsuites>\n";
}

}  // namespace jw
