#include "app/site/site.hpp"

#include "app/site/index_page.hpp"
#include "app/site/lesson_page.hpp"
#include "app/site/live_page.hpp"
#include "app/site/pictures.hpp"
#include "app/site/site_folder.hpp"
#include "app/site/site_parts.hpp"

namespace jw::site {

namespace {

void write_lesson(const SiteCourse& course, std::size_t index, const SiteFolder& folder) {
    const SiteLesson& lesson = course.lessons[index];
    const Story story(lesson.lesson);
    const std::vector<Station> stations = stations_of(story);
    folder.write(path_of_page(lesson), lesson_page(course, index, story, stations));
    draw_pictures(
        lesson, story, stations,
        [&](const std::string& path, const std::vector<std::uint8_t>& png) { folder.write(path, png); });
}

}  // namespace

void write_site(
    const SiteCourse& course, const SiteOutput& output, const std::function<void(double)>& progress) {
    SiteFolder folder(output.out);
    write_course_files(course, folder.draft() / "course");
    write_live_page(output.page, lessons_bundle(course), folder.draft() / "live");
    folder.write("index.html", index_page(course));
    folder.write("slides.html", slides_page(course));
    folder.write("search_data.js", search_data(course));
    folder.write("site.css", kStyle);
    folder.write("site.js", kScript);
    folder.write("service_worker.js", kWorker);
    folder.write("icon.svg", kIcon);
    if (!output.slides.empty()) { folder.write(course.slides, file_text(output.slides)); }
    for (std::size_t k = 0; k < course.lessons.size(); ++k) {
        progress(static_cast<double>(k) / static_cast<double>(course.lessons.size()));
        write_lesson(course, k, folder);
    }
    folder.finish();
}

}  // namespace jw::site
