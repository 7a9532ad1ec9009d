// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include <QCheckBox>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QUrl>
#include <QVBoxLayout>

#include "core/document/file_names.h"
#include "ui/core_text.h"
#include "ui/lesson/listed_lessons.h"
#include "ui/start/card_delegate.h"
#include "ui/start/examples.h"
#include "ui/theme/appearance.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {

constexpr int kSideWidth = 232;
constexpr int kSearchWidth = 260;
constexpr int kOuter = 28;
constexpr double kTitleScale = 1.7;
constexpr double kHeadingScale = 1.35;

void enlarge(QWidget& widget, double scale) {
    QFont font = widget.font();
    font.setPointSizeF(font.pointSizeF() * scale);
    font.setBold(true);
    widget.setFont(font);
}

QString shortTime(const QDateTime& time) {
    return QLocale().toString(time.toLocalTime(), QLocale::ShortFormat);
}

/// A folder as a person writes it.
QString shortFolder(const QString& path) {
    const QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    return folder == home || folder.startsWith(home + '/') ? '~' + folder.mid(home.size()) : folder;
}

QPushButton* bigButton(const QString& icon, const QString& text, QWidget* parent) {
    auto* button = new QPushButton(themedIcon(icon), text, parent);
    constexpr int kHeight = 36;
    button->setMinimumHeight(kHeight);
    button->setIconSize({metrics::kIcon, metrics::kIcon});
    return button;
}

}  // namespace

StartPage::StartPage(RecentFiles recent, const QString& workFolder, Appearance& appearance,
                     QWidget* parent)
    : QWidget(parent),
      recent_(std::move(recent)),
      workFolder_(workFolder),
      appearance_(appearance),
      model_(new QStandardItemModel(this)),
      found_(new QSortFilterProxyModel(this)),
      delegate_(new CardDelegate(appearance, this)) {
    setObjectName(QStringLiteral("startPage"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kOuter, kOuter, kOuter, metrics::kMargin);
    layout->setSpacing(kOuter);
    layout->addWidget(buildSide());
    layout->addWidget(buildMain(), 1);
    connect(&appearance, &Appearance::changed, this, [this] { cards_->viewport()->update(); });
    auto* find = new QShortcut(QKeySequence::Find, this);
    find->setContext(Qt::WidgetWithChildrenShortcut);
    connect(find, &QShortcut::activated, search_, [this] { search_->setFocus(); });
}

QWidget* StartPage::buildSide() {
    auto* side = new QWidget(this);
    side->setFixedWidth(kSideWidth);
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kSpace);
    auto* title = new QLabel(QStringLiteral("Edgewright"), side);
    enlarge(*title, kTitleScale);
    auto* fresh = bigButton(QStringLiteral("document-new"), tr("&New drawing"), side);
    auto* open = bigButton(QStringLiteral("document-open"), tr("&Open\u2026"), side);
    fresh->setObjectName(QStringLiteral("startNew"));
    open->setObjectName(QStringLiteral("startOpen"));
    sections_ = new QListWidget(side);
    sections_->setObjectName(QStringLiteral("startSections"));
    sections_->setAccessibleName(tr("What is listed"));
    sections_->setFrameShape(QFrame::NoFrame);
    sections_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    sections_->viewport()->setAutoFillBackground(false);
    layout->addWidget(title);
    layout->addSpacing(metrics::kSpace);
    layout->addWidget(fresh);
    layout->addWidget(open);
    layout->addSpacing(metrics::kMargin);
    layout->addWidget(sections_);
    layout->addStretch(1);
    atStart_ = new QCheckBox(tr("Show this page at start"), side);
    atStart_->setChecked(true);
    layout->addWidget(atStart_);
    connect(fresh, &QPushButton::clicked, this, &StartPage::newWanted);
    connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
    connect(sections_, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row < 0) return;
        section_ = static_cast<Section>(row);
        fill();
    });
    return side;
}

void StartPage::buildCards(QWidget* main) {
    cards_ = new QListView(main);
    cards_->setObjectName(QStringLiteral("startCards"));
    cards_->setViewMode(QListView::IconMode);
    cards_->setResizeMode(QListView::Adjust);
    cards_->setMovement(QListView::Static);
    cards_->setUniformItemSizes(true);
    cards_->setMouseTracking(true);
    cards_->setFrameShape(QFrame::NoFrame);
    cards_->setSpacing(0);
    cards_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    cards_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    cards_->setContextMenuPolicy(Qt::CustomContextMenu);
    cards_->setItemDelegate(delegate_);
    cards_->viewport()->setAutoFillBackground(false);
    found_->setSourceModel(model_);
    found_->setFilterRole(kSearchRole);
    found_->setFilterCaseSensitivity(Qt::CaseInsensitive);
    cards_->setModel(found_);
    cards_->installEventFilter(this);
}

QWidget* StartPage::buildMain() {
    auto* main = new QWidget(this);
    auto* layout = new QVBoxLayout(main);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kSpace);
    auto* top = new QHBoxLayout;
    heading_ = new QLabel(main);
    enlarge(*heading_, kHeadingScale);
    heading_->setIndent(metrics::kGap);  // as the cards have it
    search_ = new QLineEdit(main);
    search_->setObjectName(QStringLiteral("startSearch"));
    search_->setPlaceholderText(tr("Search name or folder"));
    search_->setClearButtonEnabled(true);
    search_->setFixedWidth(kSearchWidth);
    search_->installEventFilter(this);
    top->addWidget(heading_, 1);
    top->addWidget(search_);
    about_ = new QLabel(main);
    about_->setForegroundRole(QPalette::PlaceholderText);
    about_->setWordWrap(true);
    about_->setIndent(metrics::kGap);
    buildCards(main);
    empty_ = new QLabel(main);
    empty_->setObjectName(QStringLiteral("startEmpty"));
    empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setWordWrap(true);
    empty_->setIndent(metrics::kGap);
    layout->addLayout(top);
    layout->addWidget(about_);
    layout->addWidget(empty_, 1);
    layout->addWidget(cards_, 1);
    connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
        found_->setFilterFixedString(text);
        showEmptyText();
    });
    connect(cards_, &QListView::clicked, this, [this](const QModelIndex& index) {
        if (!delegate_->tookClick()) open(index);
    });
    connect(cards_, &QListView::customContextMenuRequested, this, &StartPage::menuAt);
    connect(delegate_, &CardDelegate::pinClicked, this, [this](const QModelIndex& index) {
        setPinned(index.data(kPathRole).toString(), !index.data(kPinnedRole).toBool());
    });
    return main;
}

void StartPage::readAll() {
    files_ = recent_.list();
    lost_.clear();
    if (workFolder_.isEmpty()) return;
    for (WorkCopyEntry& entry : WorkFolder(workFolder_).list()) {
        if (entry.lost()) lost_.push_back(std::move(entry));
    }
}

void StartPage::refresh() {
    readAll();
    show(!lost_.empty() ? Section::Recover : !files_.empty() ? Section::Recent : Section::Examples);
}

void StartPage::show(Section section) {
    section_ = section;
    search_->clear();
    refreshSections();
    fill();
    cards_->setFocus();
}

bool StartPage::shownAtStart() const { return atStart_->isChecked(); }
void StartPage::setShownAtStart(bool shown) { atStart_->setChecked(shown); }

int StartPage::lostCount() const { return static_cast<int>(lost_.size()); }

void StartPage::refreshSections() {
    const QSignalBlocker quiet(sections_);
    sections_->clear();
    sections_->addItem(tr("Recent documents"));
    sections_->addItem(tr("Examples"));
    sections_->addItem(tr("Lessons"));
    if (!lost_.empty()) sections_->addItem(tr("Recover (%1)").arg(lost_.size()));
    const int height = sections_->fontMetrics().height() + metrics::kMargin;
    for (int i = 0; i < sections_->count(); ++i) sections_->item(i)->setSizeHint({0, height});
    sections_->setFixedHeight(sections_->count() * height + metrics::kSpace);
    if (section_ == Section::Recover && lost_.empty()) section_ = Section::Recent;
    sections_->setCurrentRow(static_cast<int>(section_));
}

void StartPage::fill() {
    model_->clear();
    search_->setVisible(section_ != Section::Recover);
    switch (section_) {
        case Section::Recent:
            heading_->setText(tr("Recent documents"));
            about_->clear();
            fillRecent();
            break;
        case Section::Examples:
            heading_->setText(tr("Examples"));
            about_->setText(
                tr("Drawings that are replayed stroke by stroke; the history shows "
                   "how each was made."));
            fillExamples();
            break;
        case Section::Lessons:
            heading_->setText(tr("Lessons"));
            about_->setText(
                tr("Each leads through something that can be drawn, step by step, with "
                   "strokes to trace and hints."));
            fillLessons();
            break;
        case Section::Recover:
            heading_->setText(tr("Work that was not closed"));
            about_->setText(
                tr("The program ended while these were open. They are whole up to the "
                   "last finished stroke."));
            fillRecover();
            break;
    }
    about_->setVisible(!about_->text().isEmpty());
    if (found_->rowCount() > 0) cards_->setCurrentIndex(found_->index(0, 0));
    showEmptyText();
}

QStandardItem* StartPage::addCard(const QString& name, const QString& detail,
                                  const QPixmap& picture) {
    auto* item = new QStandardItem(name);
    item->setEditable(false);
    item->setData(detail, kDetailRole);
    if (!picture.isNull()) item->setData(picture, Qt::DecorationRole);
    item->setData(name, kSearchRole);
    item->setData(model_->rowCount(), kPlaceRole);
    item->setData(QStringLiteral("%1, %2").arg(name, detail), Qt::AccessibleTextRole);
    model_->appendRow(item);
    return item;
}

void StartPage::fillRecent() {
    for (const RecentFile& file : files_) {
        const QString name = QFileInfo(file.path).completeBaseName();
        const QString detail =
            file.missing ? tr("Not found: %1").arg(shortFolder(file.path)) : shortFolder(file.path);
        QStandardItem* item = addCard(name, detail, pictureOf(file.thumbnail));
        item->setData(file.missing, kMissingRole);
        item->setData(file.pinned, kPinnedRole);
        item->setData(file.path, kPathRole);
        item->setData(file.path, kSearchRole);
        item->setToolTip(file.path + '\n' + tr("Used last: %1").arg(shortTime(file.used)));
    }
}

void StartPage::fillExamples() {
    for (const Example& example : examples()) {
        QStandardItem* item =
            addCard(example.title, tr("%n step(s)", "", example.steps), QPixmap(example.picture));
        item->setData(example.path, kPathRole);
    }
}

void StartPage::fillLessons() {
    for (const ListedLesson& lesson : listedLessons()) {
        QString detail = tr("%1 min").arg(lesson.minutes);
        if (lesson.stars > 0) {
            detail +=
                QStringLiteral(" \u00b7 \u2605 %1 / %2").arg(lesson.stars).arg(lesson.mostStars);
        }
        QStandardItem* item = addCard(lesson.title, detail, pictureOf(lesson.picture));
        item->setData(lesson.path, kPathRole);
        item->setToolTip(lesson.summary);
    }
}

void StartPage::fillRecover() {
    for (const WorkCopyEntry& entry : lost_) {
        const QString path = entry.note.documentPath;
        QString name =
            path.isEmpty() ? coreText(entry.summary.title) : QFileInfo(path).completeBaseName();
        if (name.isEmpty()) name = tr("Untitled");
        const QString counts = tr("%n step(s)", "", entry.summary.steps);
        QStandardItem* item =
            addCard(name, QStringLiteral("%1 \u00b7 %2").arg(shortTime(entry.time), counts),
                    pictureOf(entry.summary.thumbnail));
        item->setToolTip((path.isEmpty() ? tr("It has no file yet.") : path) + '\n' +
                         tr("%n stroke(s) waiting", "", entry.summary.strokes));
    }
}

void StartPage::showEmptyText() {
    const bool any = found_->rowCount() > 0;
    if (!search_->text().isEmpty() && model_->rowCount() > 0) {
        empty_->setText(tr("Nothing here is called \u201c%1\u201d.").arg(search_->text()));
    } else if (section_ == Section::Recent) {
        empty_->setText(tr("What you open or save is listed here."));
    } else if (section_ == Section::Lessons) {
        empty_->setText(tr("There are no lessons"));
    } else {
        empty_->setText(tr("There are no examples"));
    }
    empty_->setVisible(!any);
    cards_->setVisible(any);
}

void StartPage::open(const QModelIndex& index) {
    if (!index.isValid()) return;
    const QString path = index.data(kPathRole).toString();
    switch (section_) {
        case Section::Recent:
            emit fileWanted(path, false);
            break;
        case Section::Examples:
            emit exampleWanted(path);
            break;
        case Section::Lessons:
            emit lessonWanted(path);
            break;
        case Section::Recover: {
            const auto place = static_cast<std::size_t>(index.data(kPlaceRole).toInt());
            // A copy: recovering it fills the list anew.
            const WorkCopyEntry entry = lost_[place];
            emit recoverWanted(entry);
            break;
        }
    }
}

void StartPage::menuAt(const QPoint& place) {
    const QModelIndex index = cards_->indexAt(place);
    if (!index.isValid()) return;
    const QPoint global = cards_->viewport()->mapToGlobal(place);
    if (section_ == Section::Recent) recentMenu(index, global);
    if (section_ == Section::Recover) recoverMenu(index, global);
}

void StartPage::recentMenu(const QModelIndex& index, const QPoint& place) {
    const QString path = index.data(kPathRole).toString();
    const bool pinned = index.data(kPinnedRole).toBool();
    const bool missing = index.data(kMissingRole).toBool();
    QMenu menu;
    menu.addAction(tr("&Open"), this, [this, path] { emit fileWanted(path, false); })
        ->setEnabled(!missing);
    menu.addAction(tr("Open in a new &window"), this, [this, path] { emit fileWanted(path, true); })
        ->setEnabled(!missing);
    menu.addAction(pinned ? tr("Un&pin") : tr("&Pin"), this,
                   [this, path, pinned] { setPinned(path, !pinned); });
    menu.addAction(
            tr("Open its &folder"), this,
            [path] {
                QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(path).absolutePath()));
            })
        ->setEnabled(QFileInfo(path).dir().exists());
    menu.addSeparator();
    menu.addAction(tr("&Remove from the list"), this, [this, path] { forget(path); });
    menu.exec(place);
}

void StartPage::recoverMenu(const QModelIndex& index, const QPoint& place) {
    const WorkCopyEntry entry = lost_[static_cast<std::size_t>(index.data(kPlaceRole).toInt())];
    QMenu menu;
    menu.addAction(tr("&Recover"), this, [this, entry] { emit recoverWanted(entry); });
    QAction* away =
        menu.addAction(tr("&Put away"), this, [this, entry] { emit putAwayWanted(entry); });
    away->setToolTip(tr("It stays for 30 days: File, Recover."));
    menu.setToolTipsVisible(true);
    menu.exec(place);
}

void StartPage::setPinned(const QString& path, bool pinned) {
    report(recent_.setPinned(path, pinned));
    readAll();
    fill();
}

void StartPage::forget(const QString& path) {
    report(recent_.remove(path));
    readAll();
    fill();
}

void StartPage::report(const Result<void>& result) {
    if (!result) emit failed(result.error());
}

bool StartPage::event(QEvent* event) {
    // Keys without a modifier are the drawing's shortcuts, and there is no drawing here.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() == Qt::NoModifier || key->modifiers() == Qt::KeypadModifier) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        emit left();
        return;
    }
    QWidget::keyPressEvent(event);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const auto* pressed = static_cast<QKeyEvent*>(event);
    const int key = pressed->key();
    if (watched == search_ && (key == Qt::Key_Down || key == Qt::Key_Return)) {
        cards_->setFocus();
        if (found_->rowCount() > 0) cards_->setCurrentIndex(found_->index(0, 0));
        return true;
    }
    if (watched == cards_) {
        const QModelIndex index = cards_->currentIndex();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            open(index);
            return true;
        }
        if (key == Qt::Key_Delete && section_ == Section::Recent && index.isValid()) {
            forget(index.data(kPathRole).toString());
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace ew
