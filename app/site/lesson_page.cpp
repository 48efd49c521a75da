#include "app/site/lesson_page.hpp"

#include "app/host/lesson/address.hpp"
#include "app/session/encoding/html_words.hpp"
#include "app/session/view/view.hpp"
#include "app/session/wording/messages.hpp"
#include "app/session/wording/numbers.hpp"
#include "app/site/index_page.hpp"

namespace jw::site {

namespace {

std::string item(const std::string& name, const std::string& value) {
    return "<div><dt>" + markup_text(name) + "</dt><dd>" + value + "</dd></div>";
}

/// Content that a click unfolds.
std::string details_html(const std::string& summary, const std::string& content) {
    return "<details><summary>" + markup_text(summary) + "</summary>\n" + content + "</details>\n";
}

/// A list of items, "ul" or "ol"; empty if there are none.
std::string list_html(const std::string& kind, const std::string& items) {
    return items.empty() ? items : "<" + kind + ">\n" + items + "</" + kind + ">\n";
}

/// The numbers of a rank, each with its name.
std::string rank_html(const RankView& rank) {
    const std::string before = rank.rank_before >= 0 && rank.rank_before != rank.rank
                                   ? std::to_string(rank.rank_before) + " → "
                                   : "";
    return "<dl class=\"numbers\">" + item(tr("equations"), std::to_string(rank.rows)) +
           item(tr("columns"), std::to_string(rank.columns)) +
           item(tr("rank"), before + std::to_string(rank.rank)) +
           item(tr("freedoms"), std::to_string(rank.dof)) +
           item(tr("redundant"), std::to_string(rank.redundant())) + "</dl>\n";
}

std::string combinations_html(const RankView& rank) {
    std::string items;
    for (const std::string& combination : rank.combinations) {
        items += "<li>" + words_html(combination) + "</li>\n";
    }
    return items.empty() ? items : details_html(tr("Redundant equations"), list_html("ul", items));
}

std::string equations_html(const std::vector<EquationGroup>& groups) {
    std::string html;
    for (const EquationGroup& group : groups) {
        html += "<div class=\"equation\">" + html_words("$$" + group.formula + "$$");
        if (group.choice && !group.choice->reason.empty()) {
            html += "<p>" + words_html(group.choice->reason) + "</p>";
        }
        html += "</div>\n";
    }
    return html;
}

std::string answers_html(const QuestionView& question) {
    std::string html;
    for (const std::string& choice : question.choices) { html += "<li>" + words_html(choice) + "</li>\n"; }
    return list_html("ol", html) +
           details_html(tr("Answer"), paragraphs_html(question.answer) + paragraphs_html(question.why));
}

/// Parts of the page of a lesson as HTML. A part for which the lesson has nothing is empty.
class LessonParts {
public:
    /// @param top  relative path to the top of the site; all must outlive this
    LessonParts(const SiteLesson& lesson, const Story& story, const std::string& top)
        : lesson_(lesson), story_(story), top_(top) {}

    std::string stations(const std::vector<Station>& stations) const {
        std::string html;
        for (const Station& one : stations) { html += station(one); }
        return part("steps", tr("Step by step"), html);
    }

    std::string questions() const {
        std::string html;
        for (const Step& step : story_.steps()) {
            if (step.kind != Step::Kind::answer) { continue; }
            const QuestionView question = question_view_of(story_, step);
            html += "<li>" + paragraphs_html(question.ask) + answers_html(question) + "</li>\n";
        }
        return part("questions", tr("Questions"), list_html("ol", html));
    }

    std::string summary() const {
        return part("summary", tr("To remember"), paragraphs_html(lesson_.lesson.summary));
    }

    std::string trials() const {
        std::string html;
        for (const Trial& trial : lesson_.lesson.trials) {
            host::Address address;
            address.lesson = lesson_.address;
            address.experiments = trial.actions;
            html += "<li>" + paragraphs_html(trial.text) + "<p>" +
                    go(fragment_of(address),
                       trial.breaks ? tr("Break it in the figure") : tr("Try it in the figure")) +
                    "</p></li>\n";
        }
        return part("trials", tr("To try"), list_html("ul", html));
    }

    std::string exercises() const {
        std::string html;
        for (const Exercise& one : lesson_.exercises) { html += exercise(one); }
        if (html.empty()) { return html; }
        return part(
            "exercises", tr("Exercises"),
            "<p>" +
                markup_text(tr("The figure chooses numbers of your own and says what is wrong with an "
                               "answer; nothing is sent anywhere.")) +
                "</p>\n" + html);
    }

    std::string claims() const {
        std::string rows;
        for (const ClaimResult& claim : lesson_.claims) {
            rows += "<tr><td>" + words_html(claim.moment) + "</td><td>" + words_html(claim.subject) +
                    "</td><td>" + words_html(claim.expected) + "</td></tr>\n";
        }
        if (rows.empty()) { return rows; }
        const auto count = static_cast<int>(lesson_.claims.size());
        return part(
            "claims", tr("Proved"),
            details_html(
                tr_count(
                    count, "{0} claim of this lesson was computed when this page was made, and holds",
                    "{0} claims of this lesson were computed when this page was made, and all hold"),
                "<div class=\"wide\"><table>\n<thead><tr><th>" + markup_text(tr("when")) + "</th><th>" +
                    markup_text(tr("what")) + "</th><th>" + markup_text(tr("value")) +
                    "</th></tr></thead>\n<tbody>\n" + rows + "</tbody>\n</table></div>\n"));
    }

private:
    std::string station(const Station& station) const {
        const View view = view_of(story_, station.told, ViewParts::without_matrix);
        host::Address address;
        address.lesson = lesson_.address;
        address.at = std::to_string(station.told + 1);
        std::string html =
            "<section class=\"station\" id=\"" + station.id + "\">\n<h3>" +
            words_html(station.moves ? tr("Motion, t = {0} s", number_text(view.t)) : view.title) + "</h3>\n";
        if (station.pictured) {
            html += "<img loading=\"lazy\" width=\"800\" height=\"500\" src=\"" + top_ +
                    path_in_address(path_of_picture(lesson_, station)) + "\" alt=\"" +
                    markup_text(words_plain(view.title)) + "\" />\n";
        }
        if (station.equations >= 0) {
            html += equations_html(view_of(story_, station.equations, ViewParts::without_matrix).equations);
        }
        // the text of the lesson is already at the top of the page
        const bool bodies = view.kind == Step::Kind::bodies;
        html += paragraphs_html(bodies ? lesson_.lesson.step_texts.bodies : view.author_text);
        if (!station.moves) { html += paragraphs_html(view.sentence); }
        if (!station.moves && !bodies) { html += rank_html(view.rank); }
        if (!view.failure.empty()) { html += "<p class=\"failure\">" + words_html(view.failure) + "</p>\n"; }
        return html + combinations_html(view.rank) + "<p>" +
               go(fragment_of(address), tr("Show it in the figure")) + "</p>\n</section>\n";
    }

    std::string exercise(const Exercise& exercise) const {
        host::Address address;
        address.lesson = lesson_.address;
        address.exercise = exercise.name;
        std::string hints;
        for (std::size_t k = 0; k < exercise.hints.size(); ++k) {
            hints += details_html(tr("Hint {0}", k + 1), paragraphs_html(exercise.hints[k]));
        }
        return "<section class=\"exercise\" id=\"exercise-" + exercise.name + "\">\n<h3>" +
               words_html(exercise.title) + "</h3>\n" +
               (exercise.source.empty()
                    ? std::string()
                    : "<p class=\"source\">" + source_html(exercise.source, top_) + "</p>\n") +
               paragraphs_html(exercise.ask) + hints + "<p>" +
               go(fragment_of(address), tr("Solve it in the figure")) + "</p>\n</section>\n";
    }

    /// Link that shows an address in the live figure.
    std::string go(const std::string& fragment, const char* words) const {
        return link_html(top_ + live_address(fragment), markup_text(words), "go");
    }

    std::string part(const char* id, const std::string& title, const std::string& content) const {
        if (content.empty()) { return {}; }
        return "<section class=\"" + std::string(id) + "\" id=\"" + id + "\">\n<h2>" + markup_text(title) +
               "</h2>\n" + content + "</section>\n";
    }

    const SiteLesson& lesson_;
    const Story& story_;
    const std::string& top_;
};

/// Place of a lesson in the chapter that it belongs to.
struct PlaceInCourse {
    const SiteChapter* chapter = nullptr;
    std::size_t number = 0;  ///< from 1
};

PlaceInCourse place_in_course(const SiteCourse& course, std::size_t index) {
    for (const SiteChapter& chapter : course.chapters) {
        for (std::size_t k = 0; k < chapter.lessons.size(); ++k) {
            if (chapter.lessons[k] == index) { return {&chapter, k + 1}; }
        }
    }
    return {};
}

std::string head_html(const SiteCourse& course, std::size_t index, const std::string& top) {
    const SiteLesson& lesson = course.lessons[index];
    const PlaceInCourse place = place_in_course(course, index);
    std::string html = "<header class=\"lesson\">\n";
    if (place.chapter != nullptr) {
        html += "<p class=\"chapter\">" +
                link_html(
                    top + "index.html#" + id_of_chapter(course, *place.chapter),
                    words_html(place.chapter->title)) +
                " · " + markup_text(tr("{0} of {1}", place.number, place.chapter->lessons.size())) + "</p>\n";
    }
    html += "<h1>" + words_html(lesson.lesson.title) + "</h1>\n";
    if (!lesson.lesson.source.empty()) {
        html += "<p class=\"source\">" + source_html(lesson.lesson.source, top) + "</p>\n";
    }
    return html + paragraphs_html(lesson.lesson.text) + "</header>\n";
}

/// The live figure; it is a picture until it comes into view, and where it cannot run.
std::string live_html(const SiteLesson& lesson, const Story& story, const std::string& top) {
    host::Address address;
    address.lesson = lesson.address;
    address.at = std::to_string(story.last_assembled() + 1);
    const std::string live = top + live_address(fragment_of(address));
    return "<figure class=\"live\" id=\"live\">\n<div class=\"screen\">" +
           link_html(
               live, "<img src=\"" + top + path_in_address(path_of_frame(lesson)) +
                         "\" width=\"1280\" height=\"720\" alt=\"" +
                         markup_text(tr("The lesson in the program: {0}", words_plain(lesson.lesson.title))) +
                         "\" />") +
           "</div>\n<figcaption><span class=\"state\">" +
           markup_text(tr("Picture of the program; it runs here once it is loaded.")) + "</span> " +
           link_html(live, markup_text(tr("Open in its own window")), "own") + "</figcaption>\n</figure>\n";
}

std::string neighbours_html(const SiteCourse& course, std::size_t index, const std::string& top) {
    const auto neighbour = [&](std::size_t other, const char* kind, const char* words) {
        const SiteLesson& lesson = course.lessons[other];
        return "<a class=\"" + std::string(kind) + "\" rel=\"" + kind + "\" href=\"" + top +
               path_in_address(path_of_page(lesson)) + "\"><span>" + markup_text(words) + "</span> " +
               words_html(lesson.lesson.title) + "</a>\n";
    };
    std::string html;
    if (index > 0) { html += neighbour(index - 1, "prev", tr("Previous lesson")); }
    if (index + 1 < course.lessons.size()) { html += neighbour(index + 1, "next", tr("Next lesson")); }
    return html.empty() ? html
                        : "<nav class=\"neighbours\" aria-label=\"" +
                              markup_text(tr("Previous and next lesson")) + "\">\n" + html + "</nav>\n";
}

std::string foot_html(const SiteCourse& course, const SiteLesson& lesson, const std::string& top) {
    return "<p class=\"file\">" +
           link_html(
               top + path_in_address(path_of_source(course, lesson)),
               markup_text(tr("The file of this lesson"))) +
           "</p>\n";
}

std::string name_of_folder(const SiteLesson& lesson) { return "pictures/" + lesson.name + '/'; }

}  // namespace

std::string path_of_page(const SiteLesson& lesson) { return "lessons/" + lesson.name + ".html"; }
std::string path_of_frame(const SiteLesson& lesson) { return name_of_folder(lesson) + "frame.png"; }
std::string path_of_card(const SiteLesson& lesson) { return name_of_folder(lesson) + "card.png"; }
std::string path_of_picture(const SiteLesson& lesson, const Station& station) {
    return name_of_folder(lesson) + station.id + ".png";
}
std::string path_of_source(const SiteCourse& course, const SiteLesson& lesson) {
    return "course/" + lessons_folder_of(course) + '/' + lesson.name + ".toml";
}

std::string live_address(const std::string& fragment) { return "live/index.html#" + fragment; }

std::string lesson_page(
    const SiteCourse& course, std::size_t index, const Story& story, const std::vector<Station>& stations) {
    const SiteLesson& lesson = course.lessons[index];
    PageFrame page;
    page.path = path_of_page(lesson);
    page.title = words_plain(lesson.lesson.title) + " – " + words_plain(course.title);
    page.description = words_plain(lesson.lesson.text);
    const std::string top = way_to_top(page.path);
    const LessonParts parts{lesson, story, top};
    const std::string content = "<div class=\"lesson\">\n" + head_html(course, index, top) +
                                live_html(lesson, story, top) + "<article>\n" + parts.stations(stations) +
                                parts.questions() + parts.summary() + parts.trials() + parts.exercises() +
                                parts.claims() + foot_html(course, lesson, top) + "</article>\n</div>\n" +
                                neighbours_html(course, index, top);
    return page_html(course, page, content);
}

}  // namespace jw::site
