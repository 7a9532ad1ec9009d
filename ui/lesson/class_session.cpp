// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/class_session.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <utility>

#include "core/document/store.h"
#include "core/document/work_folder.h"
#include "ui/core_text.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/viewport/shape_picture.h"

namespace ew {

namespace {

constexpr int kSoonMs = 1'500;    // what follows at once is written together
constexpr int kAgainMs = 10'000;  // after a failure
constexpr int kTickMs = 30'000;
constexpr qint64 kAwayMs = 300'000;  // who looks at a drawing that long thinks; longer, she is away
constexpr QSize kPicture(160, 100);

ClassTime now() { return QDateTime::currentSecsSinceEpoch(); }

}  // namespace

ClassSession::ClassSession(const WindowContext& context, LessonGuide& guide, QString shelf,
                           QObject* parent)
    : QObject(parent), context_(context), guide_(guide), shelf_(std::move(shelf)) {
    pool_.setMaxThreadCount(1);
    soon_.setSingleShot(true);
    tick_.setInterval(kTickMs);
    sinceInput_.start();
    connect(&soon_, &QTimer::timeout, this, &ClassSession::begin);
    connect(&tick_, &QTimer::timeout, this, &ClassSession::tick);
    connect(&context_.document, &Document::changed, this, [this] { sinceInput_.restart(); });
    connect(&guide_, &LessonGuide::stepBegun, this, [this] {
        const std::size_t count = guide_.lesson().steps.size();
        const std::size_t step = guide_.step();
        lessonChanged([&](const std::string& id,
                          ClassTime time) { beginStep(progress_, id, count, step, time); },
                      false);
    });
    connect(&guide_, &LessonGuide::stepFailed, this, [this](const std::string& hint) {
        lessonChanged(
            [&](const std::string& id, ClassTime time) { failStep(progress_, id, hint, time); },
            true);
    });
    connect(&guide_, &LessonGuide::stepFinished, this, [this](int stars, int strokes) {
        lessonChanged([&](const std::string& id,
                          ClassTime time) { finishStep(progress_, id, stars, strokes, time); },
                      true);
    });
    connect(&guide_, &LessonGuide::stopping, this, [this] {
        lessonChanged([&](const std::string& id, ClassTime time) { keepTime(progress_, id, time); },
                      true);
    });
}

ClassSession::~ClassSession() { pool_.waitForDone(); }

QString ClassSession::standardShelf() {
    return QFileInfo(WorkFolder::standardPath()).absolutePath() + QStringLiteral("/class");
}

Result<void> ClassSession::join(const QString& classFolder, const QString& name) {
    // What the pupil before did is written before the new one's folder is taken: it may be the
    // same.
    if (joined()) {
        guide_.stop();
        settle();
    }
    auto files = PupilFiles::join(classFolder, name, ClassWriter::here());
    if (!files) return fail(files.error());
    Outcome told;
    told.notice = files->takeNotice();
    if (auto ok = files->unshelve(shelf_); !ok) return ok;
    if (const auto brought = files->takeNotice()) emit noticed(coreText(brought->message));
    forget();
    files_ = std::make_shared<PupilFiles>(*std::move(files));
    progress_ = files_->progress();
    folder_ = files_->classFolder();
    tick_.start();
    tell(told);
    emit changed();
    return {};
}

void ClassSession::leave() {
    if (!joined()) return;
    // Nobody goes on in her name.
    guide_.stop();
    settle();
    forget();
    emit changed();
}

void ClassSession::forget() {
    soon_.stop();
    tick_.stop();
    files_.reset();
    folder_.clear();
    progress_ = {};
    documents_.clear();
    dirty_ = failing_ = false;
}

QString ClassSession::pupil() const { return QString::fromStdString(progress_.name); }

const LessonProgress* ClassSession::progress(const std::string& lesson) const {
    const auto found = progress_.lessons.find(lesson);
    return found == progress_.lessons.end() ? nullptr : &found->second;
}

std::size_t ClassSession::stepOf(const Lesson& lesson) const {
    const LessonProgress* known = progress(lesson.id);
    if (known == nullptr || known->finished() || known->steps.size() != lesson.steps.size()) {
        return 0;
    }
    std::size_t step = known->step;
    // From one that is done she goes on to the next that is not.
    while (known->steps[step].stars > 0) step = (step + 1) % known->steps.size();
    return step;
}

/// \param change  of the progress; not done where nobody has joined, or the lesson was begun before
///     she did and has not come to a step since.
void ClassSession::lessonChanged(const std::function<void(const std::string&, ClassTime)>& change,
                                 bool withDocument) {
    if (!joined() || !guide_.running() || guide_.practice() != nullptr) return;
    const std::string& id = guide_.lesson().id;
    const LessonProgress* known = progress(id);
    if (withDocument && (known == nullptr || known->steps.size() != guide_.lesson().steps.size())) {
        beginStep(progress_, id, guide_.lesson().steps.size(), guide_.step(), now());
    }
    sinceInput_.restart();
    change(id, now());
    if (withDocument) takeDocument();
    writeSoon();
}

void ClassSession::tick() {
    if (!joined() || !guide_.running() || guide_.practice() != nullptr || guide_.stepDone() ||
        sinceInput_.elapsed() > kAwayMs) {
        return;
    }
    const std::string& id = guide_.lesson().id;
    if (progress(id) == nullptr) return;
    keepTime(progress_, id, now());
    writeSoon();
}

void ClassSession::keepPractice(const PracticeResult& result) {
    addResult(progress_.practice, result);
    writeSoon();
}

void ClassSession::takeDocument() {
    const Document& document = context_.document;
    const std::string& id = guide_.lesson().id;
    documents_[id] = std::make_shared<const DocumentFile>(document.contents());
    if (document.state().bodies.empty()) return;
    const QImage picture = shapePicture(document.state().bodies, *document.shape(),
                                        document.camera(), kPicture, 1.0, lightColours());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    if (picture.save(&buffer, "PNG")) {
        progress_.lessons.at(id).thumbnail = buffer.data().toStdString();
    }
}

void ClassSession::writeSoon() {
    dirty_ = true;
    if (!writing_ && !soon_.isActive()) soon_.start(kSoonMs);
}

ClassSession::Outcome ClassSession::write(PupilFiles& files, const PupilProgress& progress,
                                          const Documents& documents, const QString& shelf) {
    Outcome out;
    std::map<std::string, std::string> bytes;
    for (const auto& [lesson, document] : documents) {
        auto made = writeDocument(*document);
        if (made)
            bytes[lesson] = *std::move(made);
        else
            out.error = made.error();
    }
    for (const auto& [lesson, content] : bytes) {
        const auto ok = files.writeDocument(lesson, content);
        if (!ok) out.error = ok.error();
    }
    if (const auto ok = files.write(progress); !ok) out.error = ok.error();
    out.notice = files.takeNotice();
    if (!out.error) {
        files.clearShelf(shelf);
        return out;
    }
    // What fails here, too, is still in memory and tried again.
    static_cast<void>(files.shelve(shelf, progress, {}, {}));
    for (const auto& [lesson, content] : bytes) {
        static_cast<void>(files.shelve(shelf, progress, lesson, content));
    }
    return out;
}

void ClassSession::begin() {
    if (writing_ || !dirty_ || !joined()) return;
    writing_ = true;
    dirty_ = false;
    pool_.start([this, files = files_, progress = progress_, shelf = shelf_,
                 documents = std::exchange(documents_, {})] {
        const Outcome outcome = write(*files, progress, documents, shelf);
        QMetaObject::invokeMethod(
            this, [this, outcome, documents] { finished(outcome, documents); },
            Qt::QueuedConnection);
    });
}

void ClassSession::finished(const Outcome& outcome, Documents documents) {
    writing_ = false;
    if (outcome.error) {
        documents_.merge(documents);  // newer ones stay
        dirty_ = true;
    }
    tell(outcome);
    if (dirty_ && !soon_.isActive()) soon_.start(outcome.error ? kAgainMs : kSoonMs);
    emit changed();
}

void ClassSession::tell(const Outcome& outcome) {
    if (outcome.notice) emit failed(*outcome.notice);
    const bool was = std::exchange(failing_, outcome.error.has_value());
    if (outcome.error && !was) {
        emit failed({outcome.error->code,
                     tr("Not kept in the class folder: %1 It is kept on this computer, and tried "
                        "again.")
                         .arg(coreText(outcome.error->message))
                         .toStdString(),
                     {}});
    } else if (was && !outcome.error) {
        emit noticed(tr("Everything is kept in the class folder again."));
    }
}

bool ClassSession::settle() {
    soon_.stop();
    const auto wait = [this] {
        pool_.waitForDone();
        QCoreApplication::sendPostedEvents(this, QEvent::MetaCall);
    };
    wait();
    begin();
    wait();
    return !failing_;
}

}  // namespace ew
