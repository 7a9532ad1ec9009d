// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/pupil_progress.h"

#include <QByteArray>
#include <QDateTime>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "core/document/json_text.h"
#include "core/document/lesson/lesson.h"
#include "core/document/practice/practice_json.h"

namespace ew {

using nlohmann::json;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "edgewright-pupil";
constexpr int kMostCount = 1'000'000'000;

template <class Value>
Value sumOf(const std::vector<StepProgress>& steps, Value StepProgress::*member) {
    return std::accumulate(steps.begin(), steps.end(), Value{},
                           [&](Value sum, const StepProgress& s) { return sum + s.*member; });
}

std::string timeText(ClassTime time) {
    return QDateTime::fromSecsSinceEpoch(time, Qt::UTC).toString(Qt::ISODate).toStdString();
}

ClassTime readTime(const json& value, const std::string& place) {
    const QDateTime time =
        QDateTime::fromString(QString::fromStdString(readString(value, place)), Qt::ISODate);
    if (!time.isValid())
        throwRead(Errc::BadValue, place + ": no time such as 2024-05-31T08:15:00Z");
    return time.toSecsSinceEpoch();
}

Json stepJson(const StepProgress& step) {
    Json tries = Json::array();
    for (const FailedTry& t : step.tries)
        tries.push_back({{"time", timeText(t.time)}, {"hint", t.hint}});
    return {{"stars", step.stars},
            {"strokes", step.strokes},
            {"failed", step.failed},
            {"seconds", std::round(step.seconds)},
            {"tries", std::move(tries)}};
}

Json lessonJson(const LessonProgress& lesson) {
    Json steps = Json::array();
    for (const StepProgress& step : lesson.steps) steps.push_back(stepJson(step));
    return {{"step", lesson.step},
            {"steps", std::move(steps)},
            {"begun", timeText(lesson.begun)},
            {"last", timeText(lesson.last)},
            {"thumbnail", QByteArray::fromStdString(lesson.thumbnail).toBase64().toStdString()}};
}

/// Keys that a later version may add are no reason to lose a pupil's work: they are passed over.
StepProgress readStep(const json& value, const std::string& place) {
    const ObjectReader in(value, place);
    const auto count = [&](const char* key, int most) {
        return readInt(in.require(key), place + "/" + key, 0, most);
    };
    StepProgress step;
    step.stars = count("stars", kMostStars);
    step.strokes = count("strokes", kMostCount);
    step.failed = count("failed", kMostCount);
    step.seconds = readNumber(in.require("seconds"), place + "/seconds");
    if (!(step.seconds >= 0.0 && step.seconds <= kMostCount)) {
        throwRead(Errc::BadValue, place + "/seconds: no number of seconds");
    }
    const json::array_t& tries = readArray(in.require("tries"), place + "/tries");
    for (std::size_t i = 0; i < tries.size() && i < kMostTries; ++i) {
        const std::string path = place + "/tries/" + std::to_string(i);
        const ObjectReader one(tries[i], path);
        step.tries.push_back({readTime(one.require("time"), path + "/time"),
                              readString(one.require("hint"), path + "/hint")});
    }
    return step;
}

LessonProgress readLessonProgress(const json& value, const std::string& place) {
    const ObjectReader in(value, place);
    LessonProgress lesson;
    const json::array_t& steps = readArray(in.require("steps"), place + "/steps");
    if (steps.empty() || steps.size() > kMaxLessonSteps) {
        throwRead(Errc::BadValue, place + "/steps: a lesson has 1 to " +
                                      std::to_string(kMaxLessonSteps) + " steps");
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        lesson.steps.push_back(readStep(steps[i], place + "/steps/" + std::to_string(i)));
    }
    lesson.step = static_cast<std::size_t>(
        readInt(in.require("step"), place + "/step", 0, static_cast<int>(steps.size()) - 1));
    lesson.begun = readTime(in.require("begun"), place + "/begun");
    lesson.last = readTime(in.require("last"), place + "/last");
    if (const json* picture = in.find("thumbnail")) {
        const std::string& text = readString(*picture, place + "/thumbnail");
        lesson.thumbnail = QByteArray::fromBase64(QByteArray::fromStdString(text)).toStdString();
    }
    return lesson;
}

LessonProgress& at(PupilProgress& pupil, const std::string& lesson, ClassTime now) {
    LessonProgress& out = pupil.lessons.at(lesson);
    const ClassTime passed = now - out.last;
    if (passed > 0 && passed <= kAwaySeconds) {
        out.steps[out.step].seconds += static_cast<double>(passed);
    }
    out.last = std::max(out.last, now);
    return out;
}

}  // namespace

int LessonProgress::done() const {
    return static_cast<int>(std::count_if(steps.begin(), steps.end(),
                                          [](const StepProgress& s) { return s.stars > 0; }));
}
int LessonProgress::stars() const { return sumOf(steps, &StepProgress::stars); }
int LessonProgress::mostStars() const { return kMostStars * static_cast<int>(steps.size()); }
int LessonProgress::strokes() const { return sumOf(steps, &StepProgress::strokes); }
int LessonProgress::failed() const { return sumOf(steps, &StepProgress::failed); }
double LessonProgress::seconds() const { return sumOf(steps, &StepProgress::seconds); }

void beginStep(PupilProgress& pupil, const std::string& lesson, std::size_t count, std::size_t step,
               ClassTime now) {
    const auto known = pupil.lessons.find(lesson);
    if (known == pupil.lessons.end() || known->second.steps.size() != count) {
        LessonProgress fresh;
        fresh.steps.resize(count);
        fresh.begun = fresh.last = now;
        pupil.lessons[lesson] = std::move(fresh);
    }
    LessonProgress& progress = at(pupil, lesson, now);
    progress.step = step;
    progress.steps[step].tries.clear();
}

void keepTime(PupilProgress& pupil, const std::string& lesson, ClassTime now) {
    at(pupil, lesson, now);
}

void failStep(PupilProgress& pupil, const std::string& lesson, const std::string& hint,
              ClassTime now) {
    LessonProgress& progress = at(pupil, lesson, now);
    StepProgress& step = progress.steps[progress.step];
    ++step.failed;
    step.tries.push_back({now, hint});
    if (step.tries.size() > kMostTries) step.tries.erase(step.tries.begin());
}

void finishStep(PupilProgress& pupil, const std::string& lesson, int stars, int strokes,
                ClassTime now) {
    LessonProgress& progress = at(pupil, lesson, now);
    StepProgress& step = progress.steps[progress.step];
    if (step.stars == 0 || strokes < step.strokes) step.strokes = strokes;
    step.stars = std::max(step.stars, stars);
    step.tries.clear();
}

std::optional<StuckPlace> stuckPlace(const PupilProgress& pupil) {
    const auto newest = std::max_element(
        pupil.lessons.begin(), pupil.lessons.end(),
        [](const auto& a, const auto& b) { return a.second.last < b.second.last; });
    if (newest == pupil.lessons.end()) return std::nullopt;
    const LessonProgress& lesson = newest->second;
    const StepProgress& step = lesson.steps[lesson.step];
    if (step.stars > 0) return std::nullopt;
    const int failed = static_cast<int>(step.tries.size());
    if (failed < kStuckTries && step.seconds < kStuckSeconds) return std::nullopt;
    StuckPlace out{newest->first, lesson.step, lesson.last, failed, {}};
    // One failure is no reason to call for the teacher, so it begins with the first of several.
    if (failed > 0) {
        out.since = step.tries.front().time;
        out.hint = step.tries.back().hint;
    } else {
        out.since = lesson.last - static_cast<ClassTime>(step.seconds - kStuckSeconds);
    }
    return out;
}

void mergeProgress(PupilProgress& into, const PupilProgress& other) {
    std::vector<PracticeResult> practice = std::exchange(into.practice, {});
    for (const PracticeResult& r : other.practice) {
        if (std::find(practice.begin(), practice.end(), r) == practice.end()) practice.push_back(r);
    }
    std::stable_sort(
        practice.begin(), practice.end(),
        [](const PracticeResult& a, const PracticeResult& b) { return a.time < b.time; });
    for (const PracticeResult& r : practice) addResult(into.practice, r);
    for (const auto& [id, theirs] : other.lessons) {
        const auto known = into.lessons.find(id);
        if (known == into.lessons.end()) {
            into.lessons[id] = theirs;
            continue;
        }
        LessonProgress& ours = known->second;
        LessonProgress older = theirs;
        if (theirs.last > ours.last) std::swap(ours, older);
        if (ours.steps.size() != older.steps.size()) continue;
        ours.begun = std::min(ours.begun, older.begun);
        for (std::size_t i = 0; i < ours.steps.size(); ++i) {
            StepProgress& step = ours.steps[i];
            const StepProgress& before = older.steps[i];
            if (before.stars > step.stars) {
                step.stars = before.stars;
                step.strokes = before.strokes;
            }
            step.failed = std::max(step.failed, before.failed);
            step.seconds = std::max(step.seconds, before.seconds);
        }
    }
}

std::string progressText(const PupilProgress& pupil) {
    Json lessons = Json::object();
    for (const auto& [id, lesson] : pupil.lessons) lessons[id] = lessonJson(lesson);
    const Json all{{"format", kFormat},
                   {"version", 1},
                   {"name", pupil.name},
                   {"machine", pupil.machine},
                   {"session", pupil.session},
                   {"apart", pupil.apart},
                   {"lessons", std::move(lessons)},
                   {"practice", practiceJson(pupil.practice)}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<PupilProgress> readProgress(const std::string& text) {
    auto tree = parseJson(text, {.maxBytes = kMaxProgressBytes});
    if (!tree) return fail(tree.error());
    try {
        const ObjectReader in(*tree, "/");
        if (in.require("format") != kFormat) {
            throwRead(Errc::WrongFormat, "/format: this is no pupil's progress");
        }
        if (in.require("version") != 1) {
            throwRead(Errc::WrongVersion, "/version: this program reads version 1");
        }
        PupilProgress pupil;
        pupil.name = readString(in.require("name"), "/name");
        pupil.machine = readString(in.require("machine"), "/machine");
        pupil.session = readString(in.require("session"), "/session");
        if (const json* apart = in.find("apart")) pupil.apart = readString(*apart, "/apart");
        const json& lessons = in.require("lessons");
        if (!lessons.is_object()) throwRead(Errc::WrongType, "/lessons: lessons are an object");
        for (const auto& [id, lesson] : lessons.items()) {
            pupil.lessons[id] = readLessonProgress(lesson, "/lessons/" + id);
        }
        if (const json* practice = in.find("practice")) {
            pupil.practice = practiceFromJson(*practice, "/practice");
        }
        return pupil;
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

}  // namespace ew
