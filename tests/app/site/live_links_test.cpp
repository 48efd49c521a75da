#include <catch2/catch.hpp>

#include <regex>

#include "app/host/host.hpp"
#include "app/host/lesson/address.hpp"
#include "app/site/lesson_page.hpp"
#include "lessons/files/catalogue.hpp"

namespace jw::test {
namespace {

/// Parts behind # of all links of a page into the live figure, each once.
std::set<std::string> live_links_of(const std::string& page) {
    static const std::regex link("href=\"(?:\\.\\./)*live/index\\.html#([^\"]*)\"");
    std::set<std::string> found;
    for (auto at = std::sregex_iterator(page.begin(), page.end(), link); at != std::sregex_iterator(); ++at) {
        // as a browser reads an attribute
        found.insert(std::regex_replace((*at)[1].str(), std::regex("&amp;"), "&"));
    }
    return found;
}

}  // namespace

TEST_CASE("Every link of a lesson's page into the figure leads where it says", "[site]") {
    const site::SiteCourseRead read = site::read_site_course(catalogue_folder(), {}, [](double) {});
    REQUIRE(read.report.empty());
    REQUIRE(read.failed_claims.empty());
    const site::SiteCourse& course = read.course;
    REQUIRE(course.lessons.size() > 50);
    host::HostSetup setup;
    setup.catalogue = catalogue_folder();
    host::Host host(setup);
    int exercises = 0;
    int trials = 0;
    int stations = 0;
    for (std::size_t k = 0; k < course.lessons.size(); ++k) {
        const site::SiteLesson& lesson = course.lessons[k];
        const Story story(lesson.lesson);
        const std::string page = site::lesson_page(course, k, story, site::stations_of(story));
        for (const std::string& fragment : live_links_of(page)) {
            INFO(fragment);
            const host::Address address = host::read_address("#" + fragment);
            CHECK(address.lesson == lesson.address);
            const bool arrived = host.go_to(address);
            INFO(host.notice().mistakes());
            REQUIRE(arrived);
            if (address.exercise.empty()) {
                CHECK(fragment_of(host.address()).starts_with(lesson.address));
                address.experiments.empty() ? ++stations : ++trials;
                continue;
            }
            // its numbers take a while: the link only promises that the lesson has the exercise
            ++exercises;
            CHECK(
                std::ranges::find(lesson.exercises, address.exercise, &Exercise::name) !=
                lesson.exercises.end());
        }
    }
    INFO(stations << " places, " << trials << " experiments, " << exercises << " exercises");
    CHECK(stations > 250);
    CHECK(trials > 30);
    CHECK(exercises > 60);
}

}  // namespace jw::test
