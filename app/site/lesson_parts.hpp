#pragma once

#include <string>
#include <vector>

#include "app/site/site_course.hpp"
#include "app/site/stations.hpp"

namespace jw::site {

/// Parts of the page of a lesson as HTML. A part for which the lesson has nothing is empty.
class LessonParts {
public:
    /// @param top  relative path to the top of the site; all must outlive this
    LessonParts(const SiteLesson& lesson, const Story& story, const std::string& top)
        : lesson_(&lesson), story_(&story), top_(&top) {}

    std::string stations(const std::vector<Station>& stations) const;
    std::string questions() const;
    std::string summary() const;
    std::string trials() const;
    std::string exercises() const;
    std::string claims() const;

private:
    std::string station(const Station& station) const;
    std::string exercise(const Exercise& exercise) const;
    /// Link that shows an address in the live figure.
    std::string go(const std::string& fragment, const char* words) const;
    std::string part(const char* id, const std::string& title, const std::string& content) const;

    const SiteLesson* lesson_;
    const Story* story_;
    const std::string* top_;
};

/// Name of the folder of lessons below `course` of a site; the folder of exercises is beside it.
std::string lessons_folder_of(const SiteCourse& course);

}  // namespace jw::site
