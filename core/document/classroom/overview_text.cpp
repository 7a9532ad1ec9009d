// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/overview_text.h"

#include <QByteArray>
#include <QDateTime>
#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/document/classroom/hint_words.h"

namespace ew {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMinute = 60.0;

std::string isoText(ClassTime time) {
    return QDateTime::fromSecsSinceEpoch(time, Qt::UTC).toString(Qt::ISODate).toStdString();
}

std::string timeText(ClassTime time, const OverviewWords& words) {
    if (time == 0) return {};
    if (words.time) return words.time(time);
    return QDateTime::fromSecsSinceEpoch(time)
        .toString(QStringLiteral("yyyy-MM-dd HH:mm"))
        .toStdString();
}

/// A text with what belongs in the places %1, %2 ... of it; what is put in may hold such a place
/// itself.
std::string filled(const std::string& text, const std::vector<std::string>& parts) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto part = i + 1 < text.size() ? static_cast<std::size_t>(text[i + 1] - '1') : 0U;
        if (text[i] == '%' && i + 1 < text.size() && part < parts.size()) {
            out += parts[part];
            ++i;
        } else {
            out += text[i];
        }
    }
    return out;
}

const ClassLesson* lessonOf(const ClassOverview& overview, const std::string& id) {
    const auto found = std::find_if(overview.lessons.begin(), overview.lessons.end(),
                                    [&](const ClassLesson& l) { return l.id == id; });
    return found == overview.lessons.end() ? nullptr : &*found;
}

std::string titleOf(const ClassOverview& overview, const std::string& id,
                    const OverviewWords& words) {
    const ClassLesson* lesson = lessonOf(overview, id);
    return lesson == nullptr ? id : textIn(lesson->title, words.language);
}

// CSV --------------------------------------------------------------------------------------------

std::string csvField(std::string text) {
    constexpr std::string_view kFormula = "=+-@\t\r";
    if (!text.empty() && kFormula.find(text.front()) != std::string_view::npos) {
        text.insert(0, "'");
    }
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

void addCsvRow(std::string& out, const std::vector<std::string>& fields) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (i > 0) out += ',';
        out += csvField(fields[i]);
    }
    out += "\r\n";
}

// HTML -------------------------------------------------------------------------------------------

std::string escaped(const std::string& text) {
    return QString::fromStdString(text).toHtmlEscaped().toStdString();
}

/// A cell that is sorted by a number, or by its text where there is none.
std::string cell(const std::string& content, const std::optional<double>& key = {},
                 const std::string& kind = {}) {
    std::string out = "<td";
    if (!kind.empty()) out += " class=\"" + kind + '"';
    if (key) out += " data-key=\"" + std::to_string(*key) + '"';
    return out + '>' + content + "</td>";
}

constexpr const char* kStyle = R"(
:root{color-scheme:light dark;--line:#8884;--soft:#8881;--muted:#767676;--warn:#b3470b;--ok:#1a7f4b}
@media(prefers-color-scheme:dark){:root{--muted:#a2a2a2;--warn:#ffab70;--ok:#5fd39a}}
body{font:15px/1.45 system-ui,sans-serif;margin:2rem}
h1{font-size:1.5rem;margin:0 0 .2rem}
p{margin:.2rem 0;color:var(--muted)}
.wide{overflow-x:auto;margin-top:1rem}
table{border-collapse:collapse}
th,td{padding:.45rem .7rem;text-align:left;vertical-align:top;border-bottom:1px solid var(--line)}
th{vertical-align:bottom;font-weight:600}
th button{all:unset;cursor:pointer}
th button:focus-visible{outline:2px solid}
th[aria-sort=ascending] button::after{content:" \25b2"}
th[aria-sort=descending] button::after{content:" \25bc"}
th.lesson,td.lesson{min-width:7.5rem}
tbody tr:hover{background:var(--soft)}
td:first-child{font-weight:600;max-width:14rem;overflow-wrap:anywhere}
.number{white-space:nowrap;font-variant-numeric:tabular-nums}
.note{color:var(--muted);font-weight:400;font-size:.87em}
.stuck{color:var(--warn)}
.done{color:var(--ok)}
img{display:block;width:7rem;height:auto;border:1px solid var(--line);border-radius:4px;background:#fff}
@media print{body{margin:0}.wide{overflow:visible}}
)";

constexpr const char* kScript = R"(
document.querySelectorAll("th button").forEach(function(button){
 button.addEventListener("click",function(){
  var head=button.parentNode,at=head.cellIndex,down=head.getAttribute("aria-sort")==="ascending";
  var body=head.closest("table").tBodies[0];
  var key=function(row){var c=row.cells[at];return c.dataset.key!==undefined?+c.dataset.key:c.textContent.trim()};
  var rows=Array.from(body.rows).sort(function(a,b){
   var x=key(a),y=key(b);
   var d=typeof x==="number"&&typeof y==="number"?x-y:String(x).localeCompare(String(y),undefined,{numeric:true});
   return down?-d:d});
  head.parentNode.querySelectorAll("th").forEach(function(h){h.removeAttribute("aria-sort")});
  head.setAttribute("aria-sort",down?"descending":"ascending");
  rows.forEach(function(r){body.appendChild(r)})})});
)";

class HtmlPage {
  public:
    HtmlPage(const ClassOverview& overview, const OverviewWords& words)
        : overview_(overview), words_(words) {}

    std::string page() {
        const std::string title = filled(words_.say("Class overview: %1"), {overview_.name});
        out_ = "<!DOCTYPE html>\n<html lang=\"" + escaped(words_.language.substr(0, 2)) +
               "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
               "content=\"width=device-width\">\n<title>" +
               escaped(title) + "</title>\n<style>" + kStyle + "</style>\n</head>\n<body>\n<h1>" +
               escaped(title) + "</h1>\n";
        addHead();
        addTable();
        addProblems();
        return out_ + "<script>" + kScript + "</script>\n</body>\n</html>\n";
    }

  private:
    void addHead() {
        const auto stuck = std::count_if(overview_.pupils.begin(), overview_.pupils.end(),
                                         [](const ClassPupil& p) { return p.stuck.has_value(); });
        out_ += "<p>" +
                escaped(filled(words_.say("Pupils: %1; stuck: %2; lessons: %3."),
                               {std::to_string(overview_.pupils.size()), std::to_string(stuck),
                                std::to_string(overview_.lessons.size())})) +
                "</p>\n";
    }

    void addTable() {
        out_ += "<div class=\"wide\"><table>\n<thead><tr>";
        for (const char* name : {"Pupil", "Stuck", "Steps", "Stars", "Time", "Last worked"}) {
            out_ += "<th><button type=\"button\">" + escaped(words_.say(name)) + "</button></th>";
        }
        for (const ClassLesson& lesson : overview_.lessons) {
            out_ += "<th class=\"lesson\"><button type=\"button\">" +
                    escaped(textIn(lesson.title, words_.language)) + "</button></th>";
        }
        out_ += "</tr></thead>\n<tbody>\n";
        std::vector<const ClassPupil*> rows;
        for (const ClassPupil& pupil : overview_.pupils) rows.push_back(&pupil);
        std::stable_sort(rows.begin(), rows.end(), [](const ClassPupil* a, const ClassPupil* b) {
            return stuckKey(*a) < stuckKey(*b);
        });
        for (const ClassPupil* pupil : rows) addRow(*pupil);
        out_ += "</tbody>\n</table></div>\n";
    }

    /// Who has been stuck longest comes first, whoever is not last.
    static double stuckKey(const ClassPupil& pupil) {
        constexpr double kNever = 1e15;
        return pupil.stuck ? static_cast<double>(pupil.stuck->since) : kNever;
    }

    void addRow(const ClassPupil& pupil) {
        std::string name = escaped(pupil.progress.name);
        if (!pupil.progress.apart.empty()) {
            name += "<div class=\"note\">" + escaped(words_.say("from another machine")) + "</div>";
        }
        out_ += "<tr>" + cell(name);
        std::string stuck;
        if (pupil.stuck) {
            stuck =
                escaped(stuckText(overview_, *pupil.stuck, words_)) + "<div class=\"note\">" +
                escaped(filled(words_.say("since %1"), {timeText(pupil.stuck->since, words_)})) +
                "</div>";
        }
        out_ += cell(stuck, stuckKey(pupil), "stuck");
        out_ += cell(starsText(pupil.done(), overview_.steps()), pupil.done(), "number");
        out_ +=
            cell(starsText(pupil.stars(), kMostStars * overview_.steps()), pupil.stars(), "number");
        out_ += cell(escaped(durationText(pupil.seconds())), pupil.seconds(), "number");
        out_ += cell(escaped(timeText(pupil.last(), words_)), static_cast<double>(pupil.last()),
                     "number");
        for (const ClassLesson& lesson : overview_.lessons) {
            const auto found = pupil.progress.lessons.find(lesson.id);
            if (found == pupil.progress.lessons.end()) {
                out_ += cell("", -1.0, "lesson");
            } else {
                addLesson(pupil, lesson, found->second);
            }
        }
        out_ += "</tr>\n";
    }

    void addLesson(const ClassPupil& pupil, const ClassLesson& lesson,
                   const LessonProgress& progress) {
        std::string content;
        if (!progress.thumbnail.empty()) {
            const QByteArray png = QByteArray::fromStdString(progress.thumbnail).toBase64();
            content = "<img loading=\"lazy\" alt=\"\" src=\"data:image/png;base64," +
                      png.toStdString() + "\">";
        }
        const bool isStuck = pupil.stuck && pupil.stuck->lesson == lesson.id;
        const std::string kind = progress.finished() ? "done" : isStuck ? "stuck" : "";
        content += "<div class=\"number " + kind + "\">" +
                   std::string(progress.finished() ? "\u2713 " : "") +
                   starsText(progress.done(), static_cast<int>(progress.steps.size())) +
                   " &nbsp;\u2605 " + starsText(progress.stars(), progress.mostStars()) +
                   "</div><div class=\"note\">" + escaped(durationText(progress.seconds())) +
                   "</div>";
        out_ += cell(content, progress.stars() + progress.done(), "lesson");
    }

    void addProblems() {
        if (overview_.problems.empty()) return;
        out_ += "<h2>" + escaped(words_.say("Files that could not be read")) + "</h2>\n<ul>\n";
        for (const FileFault& f : overview_.problems) {
            out_ += "<li>" + escaped(f.file + ": " + words_.say(f.message)) + "</li>\n";
        }
        out_ += "</ul>\n";
    }

    const ClassOverview& overview_;
    const OverviewWords& words_;
    std::string out_;
};

// JSON -------------------------------------------------------------------------------------------

Json lessonJson(const ClassPupil& pupil, const std::string& id, const LessonProgress& progress) {
    return {{"lesson", id},
            {"step", progress.step},
            {"done", progress.done()},
            {"steps", progress.steps.size()},
            {"finished", progress.finished()},
            {"stars", progress.stars()},
            {"most_stars", progress.mostStars()},
            {"strokes", progress.strokes()},
            {"failed", progress.failed()},
            {"seconds", std::round(progress.seconds())},
            {"last", isoText(progress.last)},
            {"document", pupil.document(id).toStdString()}};
}

Json pupilJson(const ClassPupil& pupil) {
    Json lessons = Json::array();
    for (const auto& [id, progress] : pupil.progress.lessons) {
        lessons.push_back(lessonJson(pupil, id, progress));
    }
    Json stuck;
    if (pupil.stuck) {
        stuck = {{"lesson", pupil.stuck->lesson},
                 {"step", pupil.stuck->step},
                 {"since", isoText(pupil.stuck->since)},
                 {"failed", pupil.stuck->failed},
                 {"hint", pupil.stuck->hint}};
    }
    return {{"name", pupil.progress.name},
            {"folder", pupil.folder.toStdString()},
            {"machine", pupil.progress.machine},
            {"apart", pupil.progress.apart},
            {"done", pupil.done()},
            {"stars", pupil.stars()},
            {"seconds", std::round(pupil.seconds())},
            {"last", pupil.last() == 0 ? Json() : Json(isoText(pupil.last()))},
            {"stuck", stuck},
            {"lessons", lessons}};
}

}  // namespace

std::string durationText(double seconds) {
    const auto minutes = static_cast<long>(std::round(seconds / kMinute));
    if (seconds <= 0.0) return "0 min";
    if (minutes < 1) return "< 1 min";
    if (minutes < 60) return std::to_string(minutes) + " min";
    const std::string rest = std::to_string(minutes % 60);
    return std::to_string(minutes / 60) + " h " + (rest.size() < 2 ? "0" : "") + rest + " min";
}

std::string starsText(int stars, int most) {
    return std::to_string(stars) + " / " + std::to_string(most);
}

std::string stuckText(const ClassOverview& overview, const StuckPlace& stuck,
                      const OverviewWords& words) {
    std::string out = filled(words.say("%1, step %2"), {titleOf(overview, stuck.lesson, words),
                                                        std::to_string(stuck.step + 1)});
    if (stuck.failed > 0) {
        out += ": " + filled(words.say("%1 attempts, the last one: %2"),
                             {std::to_string(stuck.failed), words.say(hintWords(stuck.hint))});
    }
    return out;
}

std::string overviewCsv(const ClassOverview& overview, const OverviewWords& words) {
    std::string out = "\xef\xbb\xbf";
    std::vector<std::string> head;
    for (const char* name : {"Pupil", "Lesson", "Title", "Steps done", "Steps", "Stars",
                             "Most stars", "Minutes", "Strokes", "Failed attempts", "Last worked",
                             "Stuck at step", "Stuck since", "Hint", "Folder"}) {
        head.push_back(words.say(name));
    }
    addCsvRow(out, head);
    for (const ClassPupil& pupil : overview.pupils) {
        const std::string folder = QFileInfo(pupil.folder).fileName().toStdString();
        if (pupil.progress.lessons.empty()) {
            std::vector<std::string> row(head.size());
            row.front() = pupil.progress.name;
            row.back() = folder;
            addCsvRow(out, row);
        }
        for (const auto& [id, p] : pupil.progress.lessons) {
            const bool stuck = pupil.stuck && pupil.stuck->lesson == id;
            const auto tenths = static_cast<int>(std::round(p.seconds() / kMinute * 10.0));
            addCsvRow(out, {pupil.progress.name, id, titleOf(overview, id, words),
                            std::to_string(p.done()), std::to_string(p.steps.size()),
                            std::to_string(p.stars()), std::to_string(p.mostStars()),
                            std::to_string(tenths / 10) + '.' + std::to_string(tenths % 10),
                            std::to_string(p.strokes()), std::to_string(p.failed()),
                            timeText(p.last, words),
                            stuck ? std::to_string(pupil.stuck->step + 1) : std::string(),
                            stuck ? timeText(pupil.stuck->since, words) : std::string(),
                            stuck ? pupil.stuck->hint : std::string(), folder});
        }
    }
    return out;
}

std::string overviewHtml(const ClassOverview& overview, const OverviewWords& words) {
    return HtmlPage(overview, words).page();
}

std::string overviewJson(const ClassOverview& overview) {
    Json lessons = Json::array();
    for (const ClassLesson& lesson : overview.lessons) {
        lessons.push_back({{"id", lesson.id},
                           {"title", lesson.title},
                           {"steps", lesson.steps},
                           {"path", lesson.path.toStdString()}});
    }
    Json pupils = Json::array();
    for (const ClassPupil& pupil : overview.pupils) pupils.push_back(pupilJson(pupil));
    Json problems = Json::array();
    for (const FileFault& f : overview.problems) {
        problems.push_back({{"file", f.file},
                            {"path", f.path},
                            {"code", errcName(f.code)},
                            {"message", f.message}});
    }
    const Json all{{"format", "edgewright-class-overview"},
                   {"version", 1},
                   {"class", overview.name},
                   {"folder", overview.folder.toStdString()},
                   {"lessons", lessons},
                   {"pupils", pupils},
                   {"problems", problems}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ew
