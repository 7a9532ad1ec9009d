// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/document/recent_files.h"
#include "core/document/work_folder.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QListView;
class QListWidget;
class QSortFilterProxyModel;
class QStandardItem;
class QStandardItemModel;

namespace ew {

class Appearance;
class CardDelegate;

/// What a window shows before anything is opened in it: recent documents, examples, lessons, and
/// work that was not closed as one closes a document. It opens nothing by itself: its signals say
/// what is wanted.
class StartPage : public QWidget {
    Q_OBJECT

  public:
    enum class Section { Recent, Examples, Lessons, Recover };

    /// \param workFolder  of working copies; empty: none are kept.
    StartPage(RecentFiles recent, const QString& workFolder, Appearance& appearance,
              QWidget* parent = nullptr);

    /// Looks again what there is, and shows lost work first where there is some, else recent
    /// documents, else the examples.
    void refresh();
    void show(Section section);
    /// How many documents there are that were not closed as one closes them.
    int lostCount() const;

    bool shownAtStart() const;
    void setShownAtStart(bool shown);

  signals:
    void newWanted();
    void openWanted();
    void fileWanted(const QString& path, bool inNewWindow);
    void exampleWanted(const QString& path);
    void lessonWanted(const QString& path);
    void recoverWanted(const ew::WorkCopyEntry& entry);
    void putAwayWanted(const ew::WorkCopyEntry& entry);
    /// The page is to go away.
    void left();
    void failed(const ew::Error& error);

  protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    QWidget* buildSide();
    QWidget* buildMain();
    void buildCards(QWidget* main);
    void readAll();
    void fill();
    void fillRecent();
    void fillExamples();
    void fillLessons();
    void fillRecover();
    void showEmptyText();
    QStandardItem* addCard(const QString& name, const QString& detail, const QPixmap& picture);
    void open(const QModelIndex& index);
    void menuAt(const QPoint& place);
    void recentMenu(const QModelIndex& index, const QPoint& place);
    void recoverMenu(const QModelIndex& index, const QPoint& place);
    void setPinned(const QString& path, bool pinned);
    void forget(const QString& path);
    void report(const Result<void>& result);
    void refreshSections();

    RecentFiles recent_;
    QString workFolder_;
    Appearance& appearance_;
    Section section_ = Section::Recent;
    std::vector<RecentFile> files_;
    std::vector<WorkCopyEntry> lost_;
    QListWidget* sections_ = nullptr;
    QCheckBox* atStart_ = nullptr;
    QLabel* heading_ = nullptr;
    QLabel* about_ = nullptr;
    QLineEdit* search_ = nullptr;
    QListView* cards_ = nullptr;
    QLabel* empty_ = nullptr;
    QStandardItemModel* model_ = nullptr;
    QSortFilterProxyModel* found_ = nullptr;
    CardDelegate* delegate_ = nullptr;
};

}  // namespace ew
