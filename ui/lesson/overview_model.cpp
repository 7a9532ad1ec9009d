// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/overview_model.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <limits>

#include "ui/core_text.h"
#include "ui/start/card_delegate.h"

namespace ew {

OverviewWords windowWords() {
    OverviewWords words;
    words.language = QLocale().name().toStdString();
    words.say = [](const std::string& text) {
        const QString known = QCoreApplication::translate("Core", text.c_str());
        const bool isWord = known.toStdString() != text;
        return (isWord ? known : coreText(text)).toStdString();
    };
    words.time = [](ClassTime time) {
        return QLocale()
            .toString(QDateTime::fromSecsSinceEpoch(time), QLocale::ShortFormat)
            .toStdString();
    };
    return words;
}

void OverviewModel::setOverview(ClassOverview overview) {
    beginResetModel();
    overview_ = std::move(overview);
    pictures_.clear();
    endResetModel();
}

const ClassLesson* OverviewModel::lesson(int column) const {
    const auto at = static_cast<std::size_t>(column - FirstLesson);
    return column < FirstLesson || at >= overview_.lessons.size() ? nullptr
                                                                  : &overview_.lessons[at];
}

const LessonProgress* OverviewModel::progress(int row, int column) const {
    const ClassLesson* of = lesson(column);
    if (of == nullptr) return nullptr;
    const auto& lessons = pupil(row).progress.lessons;
    const auto found = lessons.find(of->id);
    return found == lessons.end() ? nullptr : &found->second;
}

int OverviewModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(overview_.pupils.size());
}

int OverviewModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : FirstLesson + static_cast<int>(overview_.lessons.size());
}

QVariant OverviewModel::data(const QModelIndex& index, int role) const {
    const int row = index.row();
    const int column = index.column();
    const auto& stuck = pupil(row).stuck;
    switch (role) {
        case Qt::DisplayRole:
            return text(row, column);
        case Qt::DecorationRole:
            return picture(row, column);
        case SortRole:
            return sortKey(row, column);
        case StuckRole: {
            const ClassLesson* of = lesson(column);
            return stuck && (of == nullptr ? column == Stuck : of->id == stuck->lesson);
        }
        case FinishedRole: {
            const LessonProgress* done = progress(row, column);
            return done != nullptr && done->finished();
        }
        case TimeRole: {
            const LessonProgress* spent = progress(row, column);
            return spent == nullptr ? QString()
                                    : QString::fromStdString(durationText(spent->seconds()));
        }
        case Qt::ToolTipRole:
            return column == Name || column == Stuck ? text(row, column) : QVariant();
        default:
            return {};
    }
}

QVariant OverviewModel::text(int row, int column) const {
    const ClassPupil& of = pupil(row);
    switch (column) {
        case Name: {
            const QString name = QString::fromStdString(of.progress.name);
            return of.progress.apart.empty() ? name : tr("%1 (from another machine)").arg(name);
        }
        case Stuck: {
            if (!of.stuck) return QString();
            const OverviewWords words = windowWords();
            return tr("%1\nsince %2")
                .arg(QString::fromStdString(stuckText(overview_, *of.stuck, words)),
                     QString::fromStdString(words.time(of.stuck->since)));
        }
        case Steps:
            return QString::fromStdString(starsText(of.done(), overview_.steps()));
        case Stars:
            return QString::fromStdString(starsText(of.stars(), kMostStars * overview_.steps()));
        case Time:
            return QString::fromStdString(durationText(of.seconds()));
        case Last:
            return of.last() == 0 ? QString()
                                  : QString::fromStdString(windowWords().time(of.last()));
        default:
            break;
    }
    const LessonProgress* done = progress(row, column);
    if (done == nullptr) return QString();
    const int steps = static_cast<int>(done->steps.size());
    return QStringLiteral("%1   \u2605 %2")
        .arg(QString::fromStdString(starsText(done->done(), steps)),
             QString::fromStdString(starsText(done->stars(), done->mostStars())));
}

QVariant OverviewModel::sortKey(int row, int column) const {
    const ClassPupil& of = pupil(row);
    switch (column) {
        case Name:
            return row;  // they come by name
        case Stuck:
            // Who has waited longest is wanted first, whoever is not stuck last.
            return of.stuck ? qlonglong(of.stuck->since) : std::numeric_limits<qlonglong>::max();
        case Steps:
            return of.done();
        case Stars:
            return of.stars();
        case Time:
            return of.seconds();
        case Last:
            return qlonglong(of.last());
        default:
            break;
    }
    const LessonProgress* done = progress(row, column);
    constexpr int kStep = 1'000;
    return done == nullptr ? -1 : kStep * done->done() + done->stars();
}

QVariant OverviewModel::picture(int row, int column) const {
    const LessonProgress* done = progress(row, column);
    if (done == nullptr || done->thumbnail.empty()) return {};
    const auto [found, isNew] = pictures_.try_emplace({row, column});
    if (isNew) found->second = pictureOf(done->thumbnail);
    return found->second;
}

QVariant OverviewModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    constexpr const char* kHeads[] = {"Pupil", "Stuck", "Steps", "Stars", "Time", "Last worked"};
    if (section < FirstLesson) return QCoreApplication::translate("Core", kHeads[section]);
    const ClassLesson* of = lesson(section);
    if (of == nullptr) return {};
    return QString::fromStdString(textIn(of->title, QLocale().name().toStdString()));
}

}  // namespace ew
