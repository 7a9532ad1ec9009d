// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/overview_dialog.h"

#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QTime>
#include <QVBoxLayout>
#include <algorithm>

#include "core/document/file_bytes.h"
#include "core/document/file_names.h"
#include "ui/core_text.h"
#include "ui/lesson/overview_delegate.h"
#include "ui/lesson/overview_model.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {

constexpr int kWidth = 1180;
constexpr int kHeight = 680;
constexpr int kNameWidth = 150;
constexpr int kStuckWidth = 230;
constexpr int kNumberWidth = 84;
constexpr int kLastWidth = 118;
constexpr int kLessonWidth = 150;
const QString kCsv = QStringLiteral(".csv");
const QString kHtml = QStringLiteral(".html");

/// Those whose name has what is searched for and who, if that is wanted, are stuck.
class Chosen : public QSortFilterProxyModel {
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void choose(const QString& text, bool stuckOnly) {
        text_ = text;
        stuckOnly_ = stuckOnly;
        invalidateFilter();
    }

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        const QAbstractItemModel& all = *sourceModel();
        const QModelIndex name = all.index(row, OverviewModel::Name, parent);
        const QModelIndex stuck = all.index(row, OverviewModel::Stuck, parent);
        return name.data().toString().contains(text_, Qt::CaseInsensitive) &&
               (!stuckOnly_ || stuck.data(OverviewModel::StuckRole).toBool());
    }

  private:
    QString text_;
    bool stuckOnly_ = false;
};

}  // namespace

OverviewDialog::OverviewDialog(Appearance& appearance, const QString& shippedLessons,
                               QWidget* parent)
    : QDialog(parent),
      appearance_(appearance),
      shipped_(shippedLessons),
      model_(new OverviewModel(this)),
      shown_(new Chosen(this)) {
    setObjectName(QStringLiteral("overviewDialog"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    setWindowTitle(tr("Class overview"));
    shown_->setSourceModel(model_);
    shown_->setSortRole(OverviewModel::SortRole);
    build();
    resize(kWidth, kHeight);
    connect(&appearance_, &Appearance::changed, this, [this] {
        showProblems();
        table_->viewport()->update();
    });
}

void OverviewDialog::build() {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin,
                               metrics::kMargin);
    layout->setSpacing(metrics::kSpace);
    layout->addWidget(buildHead());
    table_ = new QTableView(this);
    table_->setObjectName(QStringLiteral("overviewTable"));
    table_->setAccessibleName(tr("Pupils and lessons"));
    table_->setModel(shown_);
    table_->setItemDelegate(new OverviewDelegate(appearance_, table_));
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setShowGrid(false);
    table_->setWordWrap(true);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(
        OverviewDelegate::rowHeight(table_->fontMetrics()));
    table_->horizontalHeader()->setHighlightSections(false);
    QHeaderView& head = *table_->horizontalHeader();
    head.setTextElideMode(Qt::ElideRight);
    // Titles of lessons take two lines.
    head.setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter |
                             static_cast<Qt::Alignment>(Qt::TextWordWrap));
    head.setFixedHeight(2 * table_->fontMetrics().height() + metrics::kSpace);
    table_->setSortingEnabled(true);
    layout->addWidget(table_, 1);
    problems_ = new QLabel(this);
    problems_->setObjectName(QStringLiteral("overviewProblems"));
    problems_->setWordWrap(true);
    problems_->setTextFormat(Qt::PlainText);
    problems_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(problems_);
    layout->addWidget(buildFoot());
    connect(table_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &OverviewDialog::currentChanged);
    connect(table_, &QTableView::doubleClicked, this, &OverviewDialog::openCurrent);
}

QWidget* OverviewDialog::buildHead() {
    auto* head = new QWidget(this);
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    auto* texts = new QVBoxLayout;
    texts->setSpacing(0);
    title_ = new QLabel(head);
    title_->setTextFormat(Qt::PlainText);
    QFont large = font();
    large.setBold(true);
    large.setPointSizeF(large.pointSizeF() * 1.25);
    title_->setFont(large);
    summary_ = new QLabel(head);
    summary_->setObjectName(QStringLiteral("overviewSummary"));
    summary_->setTextFormat(Qt::PlainText);
    texts->addWidget(title_);
    texts->addWidget(summary_);
    row->addLayout(texts, 1);
    search_ = new QLineEdit(head);
    search_->setObjectName(QStringLiteral("overviewSearch"));
    search_->setPlaceholderText(tr("Find a pupil"));
    search_->setClearButtonEnabled(true);
    stuckOnly_ = new QCheckBox(tr("Only who is &stuck"), head);
    stuckOnly_->setObjectName(QStringLiteral("overviewStuck"));
    row->addWidget(search_);
    row->addWidget(stuckOnly_);
    connect(search_, &QLineEdit::textChanged, this, &OverviewDialog::filter);
    connect(stuckOnly_, &QCheckBox::toggled, this, &OverviewDialog::filter);
    return head;
}

QWidget* OverviewDialog::buildFoot() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    said_ = new QLabel(foot);
    said_->setObjectName(QStringLiteral("overviewSaid"));
    said_->setTextFormat(Qt::PlainText);
    said_->setWordWrap(true);
    row->addWidget(said_, 1);
    const auto button = [&](const QString& text, const char* name) {
        auto* made = new QPushButton(text, foot);
        made->setObjectName(QLatin1String(name));
        made->setAutoDefault(false);
        row->addWidget(made);
        return made;
    };
    open_ = button(tr("&Open the work"), "overviewOpen");
    export_ = button(tr("&Export\u2026"), "overviewExport");
    auto* again = button(tr("&Refresh"), "overviewRefresh");
    auto* other = button(tr("Another &class\u2026"), "overviewChoose");
    auto* close = button(tr("Close"), "overviewClose");
    open_->setToolTip(tr("Shows the chosen work in the window. The pupil's file stays as it is."));
    export_->setToolTip(tr("Writes the page as CSV or HTML."));
    connect(open_, &QPushButton::clicked, this, &OverviewDialog::openCurrent);
    connect(export_, &QPushButton::clicked, this, &OverviewDialog::exportPage);
    connect(again, &QPushButton::clicked, this, &OverviewDialog::refresh);
    connect(other, &QPushButton::clicked, this, &OverviewDialog::choose);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    return foot;
}

Result<void> OverviewDialog::show(const QString& folder) {
    auto found = readClass(folder, shipped_);
    if (!found) return fail(found.error());
    const bool isOther = folder_ != found->folder;
    folder_ = found->folder;
    model_->setOverview(*std::move(found));
    if (isOther) {
        fitColumns();
        table_->sortByColumn(OverviewModel::Stuck, Qt::AscendingOrder);
    }
    showSummary();
    showProblems();
    currentChanged();
    QDialog::show();
    raise();
    return {};
}

void OverviewDialog::fitColumns() {
    table_->setColumnWidth(OverviewModel::Name, kNameWidth);
    table_->setColumnWidth(OverviewModel::Stuck, kStuckWidth);
    for (const int column : {OverviewModel::Steps, OverviewModel::Stars, OverviewModel::Time}) {
        table_->setColumnWidth(column, kNumberWidth);
    }
    table_->setColumnWidth(OverviewModel::Last, kLastWidth);
    for (int i = OverviewModel::FirstLesson; i < model_->columnCount(); ++i) {
        table_->setColumnWidth(i, kLessonWidth);
    }
}

void OverviewDialog::showSummary() {
    const ClassOverview& overview = model_->overview();
    title_->setText(QString::fromStdString(overview.name));
    const auto stuck = std::count_if(overview.pupils.begin(), overview.pupils.end(),
                                     [](const ClassPupil& p) { return p.stuck.has_value(); });
    const QString time = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
    QString text = overview.pupils.empty()
                       ? tr("Nobody has worked here yet.")
                       : tr("%n pupil(s)", "", static_cast<int>(overview.pupils.size()));
    if (stuck > 0) text += QStringLiteral(", ") + tr("%n stuck", "", static_cast<int>(stuck));
    summary_->setText(tr("%1, as of %2").arg(text, time));
    if (overview.pupils.empty()) summary_->setText(text);
    export_->setEnabled(!overview.pupils.empty());
    stuckOnly_->setEnabled(stuck > 0 || stuckOnly_->isChecked());
}

void OverviewDialog::showProblems() {
    const auto& problems = model_->overview().problems;
    problems_->setVisible(!problems.empty());
    if (problems.empty()) return;
    constexpr std::size_t kShown = 2;
    QStringList lines;
    for (std::size_t i = 0; i < problems.size() && i < kShown; ++i) {
        const QString file =
            QDir(folder_).relativeFilePath(QString::fromStdString(problems[i].file));
        const std::string whole = file.toStdString() + ": " + problems[i].message;
        const QString told = coreText(whole);
        lines << (told.toStdString() == whole ? file + ": " + coreText(problems[i].message) : told);
    }
    if (problems.size() > kShown) {
        lines << tr("%n more file(s) cannot be read.", "",
                    static_cast<int>(problems.size() - kShown));
    }
    problems_->setText(lines.join('\n'));
    QPalette palette = problems_->palette();
    palette.setColor(QPalette::WindowText, appearance_.colours().warning);
    problems_->setPalette(palette);
}

void OverviewDialog::filter() {
    static_cast<Chosen*>(shown_)->choose(search_->text().trimmed(), stuckOnly_->isChecked());
    currentChanged();
}

void OverviewDialog::say(const QString& text, bool isProblem) {
    said_->setText(text);
    QPalette palette = said_->palette();
    const ThemeColours& c = appearance_.colours();
    palette.setColor(QPalette::WindowText, isProblem ? c.warning : c.mutedText);
    said_->setPalette(palette);
}

namespace {

/// The document that a cell stands for: of its lesson, or of the lesson worked at last.
std::pair<QString, QString> workOf(const OverviewModel& model, const QModelIndex& index) {
    const ClassPupil& pupil = model.pupil(index.row());
    std::string id;
    if (const ClassLesson* lesson = model.lesson(index.column())) {
        id = lesson->id;
    } else {
        ClassTime newest = -1;
        for (const auto& [lessonId, progress] : pupil.progress.lessons) {
            if (progress.last <= newest) continue;
            newest = progress.last;
            id = lessonId;
        }
    }
    QString title = QString::fromStdString(id);
    for (const ClassLesson& lesson : model.overview().lessons) {
        if (lesson.id != id) continue;
        title = QString::fromStdString(textIn(lesson.title, QLocale().name().toStdString()));
    }
    return {pupil.document(id), title};
}

}  // namespace

void OverviewDialog::currentChanged() {
    const QModelIndex index = shown_->mapToSource(table_->currentIndex());
    open_->setEnabled(false);
    if (!index.isValid()) {
        say(QString(), false);
        return;
    }
    const auto [path, title] = workOf(*model_, index);
    const QString name = QString::fromStdString(model_->pupil(index.row()).progress.name);
    open_->setEnabled(!path.isEmpty());
    if (title.isEmpty()) {
        say(tr("%1 has begun no lesson yet.").arg(name), false);
    } else if (path.isEmpty()) {
        say(tr("%1 has no work in \u201c%2\u201d yet.").arg(name, title), false);
    } else {
        say(tr("%1, \u201c%2\u201d").arg(name, title), false);
    }
}

void OverviewDialog::openCurrent() {
    const QModelIndex index = shown_->mapToSource(table_->currentIndex());
    if (!index.isValid()) return;
    const auto [path, title] = workOf(*model_, index);
    if (path.isEmpty()) return;
    const QString name = QString::fromStdString(model_->pupil(index.row()).progress.name);
    emit workWanted(path, tr("%1, %2").arg(name, title));
}

void OverviewDialog::choose() {
    const QString chosen =
        QFileDialog::getExistingDirectory(this, tr("Class folder"), QFileInfo(folder_).path());
    if (chosen.isEmpty()) return;
    if (auto ok = show(chosen); !ok) say(coreText(ok.error().message), true);
}

void OverviewDialog::refresh() {
    if (auto ok = show(folder_); !ok) say(coreText(ok.error().message), true);
}

void OverviewDialog::exportPage() {
    QFileDialog dialog(this, tr("Export the overview"), QFileInfo(folder_).path(),
                       tr("Page for any browser (*.html);;Table for spreadsheets (*.csv)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    dialog.setDefaultSuffix(QStringLiteral("html"));
    connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& chosen) {
        dialog.setDefaultSuffix(chosen.contains(kCsv) ? QStringLiteral("csv")
                                                      : QStringLiteral("html"));
    });
    dialog.selectFile(QFileInfo(folder_).fileName() + kHtml);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
    const QString path = dialog.selectedFiles().front();
    if (auto ok = exportTo(path); !ok)
        say(coreText(ok.error().message), true);
    else
        say(tr("Written to %1.").arg(path), false);
}

Result<void> OverviewDialog::exportTo(const QString& path) {
    const ClassOverview& overview = model_->overview();
    const OverviewWords words = windowWords();
    return writeFileBytes(
        path, endsWith(path, kCsv) ? overviewCsv(overview, words) : overviewHtml(overview, words));
}

}  // namespace ew
