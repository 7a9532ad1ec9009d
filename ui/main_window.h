// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QPixmap>
#include <memory>

#include "core/tlib/library.h"

class QDockWidget;
class QStackedWidget;
class QToolBar;

namespace ew {

class Appearance;
class ApplyController;
class BodySelection;
class Document;
class EditActions;
class FileActions;
class LiveReading;
class MessageBar;
class PointerPlace;
class LessonDock;
class PullController;
class RecentActions;
class SketchActions;
class StartPage;
class SurfaceActions;
class SurfaceController;
class ToolBox;
class ViewActions;
class ViewportWidget;
class WorkKeeper;

struct MainWindowOptions {
    bool remember = true;     ///< size, panels, theme and switches, over runs
    QString workFolder = {};  ///< where working copies are kept; empty: none are
    QString recentList = {};  ///< file with the list of recent files; empty: none is kept
    QSize available = {};     ///< of the screen, for the first size [logical px]; empty: asked for
};

/// The window: viewport and message bar in the middle, panels round it. It makes the parts and
/// puts them together; what they do is in their own files.
class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    /// \param library     the templates in use.
    /// \param appearance  outlives the window.
    MainWindow(TemplateLibrary library, Appearance& appearance, MainWindowOptions options = {},
               QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Ends what is typed or dragged and asks about work that is not saved; false where it stays.
    bool mayClose();
    /// Shows recent documents, examples and lost work in place of the drawing and its panels.
    void showStart();
    /// Shows the drawing again. So does whatever changes the document.
    void leaveStart();
    bool startShown() const;
    /// Does this person want to see it when the program starts? So they do until they say no.
    static bool wantsStart();
    /// The window as it is seen, without its frame.
    QPixmap picture();

    Document& document() { return *document_; }
    LiveReading& reading() { return *reading_; }
    ApplyController& applyController() { return *apply_; }
    ToolBox& tools() { return *tools_; }
    ViewportWidget& viewport() { return *viewport_; }
    MessageBar& messages() { return *messages_; }
    FileActions& files() { return *files_; }
    ViewActions& views() { return *views_; }
    /// Null where no list of recent files is kept.
    StartPage* startPage() { return start_; }
    SurfaceController& surface() { return *surface_; }
    LessonDock& lesson() { return *lesson_; }
    /// Begins a lesson, after asking about work that is not saved; false where it does not, which
    /// the message bar says.
    bool beginLesson(const QString& path);
    /// Null where no working copies are kept.
    WorkKeeper* workKeeper() { return work_; }

  signals:
    /// Files are to be opened in windows of their own; none: a new window is wanted.
    void windowsWanted(const QStringList& paths);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

  private:
    /// What is typed into a field counts.
    void endTyping();
    void buildCentre();
    void connectSurface();
    void markEdges();
    void buildStart();
    void buildActions();
    void buildPanels();
    void buildToolBar();
    /// The content where it needs more height than it gets.
    QWidget* scrolled(QWidget* content);
    QDockWidget* addPanel(const QString& title, const QString& name, QWidget* content,
                          Qt::DockWidgetArea area);
    /// Size and panels for a screen with so much room.
    void arrangeFor(const QSize& available);
    bool panelInUse() const;
    void refreshTitle();
    void restore();
    void remember() const;

    Appearance& appearance_;
    MainWindowOptions options_;
    std::unique_ptr<Document> document_;
    PointerPlace* pointer_ = nullptr;
    LiveReading* reading_ = nullptr;
    ApplyController* apply_ = nullptr;
    ViewportWidget* viewport_ = nullptr;
    MessageBar* messages_ = nullptr;
    BodySelection* bodies_ = nullptr;
    PullController* pull_ = nullptr;
    ToolBox* tools_ = nullptr;
    FileActions* files_ = nullptr;
    EditActions* edits_ = nullptr;
    ViewActions* views_ = nullptr;
    SketchActions* sketches_ = nullptr;
    SurfaceController* surface_ = nullptr;
    SurfaceActions* surfaces_ = nullptr;
    LessonDock* lesson_ = nullptr;
    WorkKeeper* work_ = nullptr;
    RecentActions* recent_ = nullptr;
    QStackedWidget* pages_ = nullptr;
    StartPage* start_ = nullptr;
    QByteArray panelsBeforeStart_;  ///< where panels were, while the start page hides them
    QToolBar* toolBar_ = nullptr;
    QList<QDockWidget*> panels_;
};

}  // namespace ew
