// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/main_window.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMimeData>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStyle>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "core/document/document.h"
#include "ui/actions/edit_actions.h"
#include "ui/actions/file_actions.h"
#include "ui/actions/recent_actions.h"
#include "ui/actions/sketch_actions.h"
#include "ui/actions/surface_actions.h"
#include "ui/actions/view_actions.h"
#include "ui/apply_controller.h"
#include "ui/body_selection.h"
#include "ui/dialogs/help_dialog.h"
#include "ui/edge_selection.h"
#include "ui/lesson/lesson_dock.h"
#include "ui/live_reading.h"
#include "ui/number_box.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/candidate_panel.h"
#include "ui/panels/graph_panel.h"
#include "ui/panels/history_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/template_panel.h"
#include "ui/panels/threshold_panel.h"
#include "ui/pointer_place.h"
#include "ui/pull_bar.h"
#include "ui/pull_controller.h"
#include "ui/start/start_page.h"
#include "ui/surface_controller.h"
#include "ui/theme/appearance.h"
#include "ui/tools/tool_box.h"
#include "ui/viewport/viewport_widget.h"
#include "ui/work_keeper.h"

namespace ew {

namespace {
// Counts up when the panels are arranged in a new way, so that an old arrangement is not restored.
constexpr int kLayoutVersion = 4;
// The window's first size, and what its frame takes of the screen [logical px].
constexpr int kWidth = 1360;
constexpr int kHeight = 860;
constexpr int kFrameWidth = 8;
constexpr int kFrameHeight = 40;
// Less than this, and panels of one side share a place; less than that, and both sides do.
constexpr int kRoomForThree = 640;
constexpr int kRoomForTwoSides = 1100;
constexpr const char* kUnit = "export/unit";
constexpr const char* kLevel = "sketch/level";
constexpr const char* kShowStart = "window/startPage";
}  // namespace

MainWindow::MainWindow(TemplateLibrary library, Appearance& appearance, MainWindowOptions options,
                       QWidget* parent)
    : QMainWindow(parent),
      appearance_(appearance),
      options_(std::move(options)),
      document_(std::make_unique<Document>(std::move(library))) {
    setObjectName(QStringLiteral("mainWindow"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
    pointer_ = new PointerPlace(this);
    reading_ = new LiveReading(*document_, this);
    apply_ = new ApplyController(*document_, *reading_, this);
    apply_->setBusyTest([this] { return panelInUse(); });
    buildCentre();
    buildActions();
    buildPanels();
    buildToolBar();
    connect(document_.get(), &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::File) refreshTitle();
    });
    refreshTitle();
    arrangeFor(options_.available.isEmpty() ? screen()->availableSize() : options_.available);
    restore();
    viewport_->setFocus();
}

// The viewport releases its OpenGL context while the document still lives.
MainWindow::~MainWindow() {
    // A number that is half typed is told when the field loses the focus, while there is a
    // document.
    endTyping();
    hide();
    // A shape that is being made may still become a step, which the tools and their actions hear
    // of.
    surface_->settle();
    lesson_->leaveClass();
    delete tools_;
    delete work_;
    delete takeCentralWidget();
}

void MainWindow::buildCentre() {
    auto* centre = new QWidget(this);
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    viewport_ = new ViewportWidget(*document_, *reading_, appearance_, centre);
    messages_ = new MessageBar(*document_, *reading_, *apply_, appearance_, centre);
    pages_ = new QStackedWidget(centre);
    pages_->addWidget(viewport_);
    layout->addWidget(pages_, 1);
    layout->addWidget(messages_);
    setCentralWidget(centre);
    ToolContext context{*document_, *reading_, *viewport_,
                        [this](const Error& error) { messages_->showError(error); },
                        [this] { apply_->inkDone(); }};
    surface_ = new SurfaceController(*document_, *viewport_, this);
    bodies_ = new BodySelection(*document_, this);
    pull_ = new PullController(*document_, *viewport_, this);
    tools_ = new ToolBox(context, surface_->selection(), *pull_, this);
    auto* pullBar = new PullBar(*pull_, centre);
    pullBar->hide();
    layout->insertWidget(1, pullBar);
    connect(tools_, &ToolBox::activeChanged, pullBar,
            [pullBar](ToolBox::Kind kind) { pullBar->setVisible(kind == ToolBox::Kind::Pull); });
    connect(pull_, &PullController::failed, this,
            [this](const Error& error) { messages_->showError(error); });
    connectSurface();
}

void MainWindow::connectSurface() {
    connect(surface_, &SurfaceController::failed, this,
            [this](const Error& error) { messages_->showError(error); });
    connect(surface_, &SurfaceController::noticed, messages_, &MessageBar::showNotice);
    connect(&surface_->selection(), &EdgeSelection::changed, this, &MainWindow::markEdges);
    connect(pull_, &PullController::markedChanged, this, &MainWindow::markEdges);
    connect(bodies_, &BodySelection::changed, this, &MainWindow::markEdges);
}

/// Marked are edges while they are being picked or a clamped one is looked at, the face that would
/// be pulled, and chosen solids.
void MainWindow::markEdges() {
    const std::vector<Body>& bodies = document_->state().bodies;
    std::vector<EdgeRef> edges;
    if (pull_->marked()) {
        edges = edgesOfFace(bodies, *pull_->marked());
    } else if (surface_->selection().choice().which == EdgeChoice::Which::Picked &&
               !surface_->selection().choice().picked.empty()) {
        edges = surface_->selection().edges();
    } else {
        for (const int b : bodies_->chosen()) {
            const int count =
                static_cast<int>(bodies[static_cast<std::size_t>(b)].solid.edges().size());
            for (int e = 0; e < count; ++e) edges.push_back({b, e});
        }
    }
    viewport_->setChosenEdges(edges);
}

void MainWindow::buildActions() {
    const WindowContext context{*document_, *reading_,  *apply_,     *tools_,
                                *viewport_, *messages_, appearance_, *bodies_};
    if (!options_.workFolder.isEmpty()) {
        work_ = new WorkKeeper(context, WorkFolder(options_.workFolder), this);
    }
    files_ = new FileActions(context, work_, this);
    if (work_ != nullptr) work_->setQuestion([this] { return files_->mayDiscard(); });
    connect(files_, &FileActions::windowWanted, this, [this] { emit windowsWanted({}); });
    if (!options_.recentList.isEmpty()) {
        recent_ =
            new RecentActions(context, *files_, work_, RecentFiles(options_.recentList), this);
        buildStart();
    }
    edits_ = new EditActions(context, this);
    views_ = new ViewActions(context, this);
    sketches_ = new SketchActions(context, this);
    files_->fill(menuBar()->addMenu(tr("&File")), recent_);
    edits_->fill(menuBar()->addMenu(tr("&Edit")));
    QMenu* view = menuBar()->addMenu(tr("&View"));
    views_->fill(view);
    sketches_->fill(menuBar()->addMenu(tr("&Sketch")));
    surfaces_ = new SurfaceActions(context, *surface_, this);
    surfaces_->fill(menuBar()->addMenu(tr("S&urface")));
    QMenu* help = menuBar()->addMenu(tr("&Help"));
    QAction* quick = help->addAction(tr("&Quick help"), this, [this] { showQuickHelp(this); });
    quick->setShortcut(QKeySequence::HelpContents);
    lesson_ = new LessonDock(context, *files_, this);
    lesson_->fill(help);
    help->addAction(tr("&Keyboard shortcuts"), this,
                    [this] { showShortcuts(this, menuBar()->actions()); });
    help->addSeparator();
    help->addAction(tr("&About Edgewright"), this, [this] { showAbout(this); });
    QMenu* panels = new QMenu(tr("&Panels"), view);
    view->addMenu(panels);
    connect(panels, &QMenu::aboutToShow, this, [this, panels] {
        panels->clear();
        for (QDockWidget* panel : panels_) panels->addAction(panel->toggleViewAction());
    });
}

void MainWindow::buildStart() {
    start_ = new StartPage(recent_->recent(), options_.workFolder, appearance_, this);
    pages_->addWidget(start_);
    connect(files_, &FileActions::startPageWanted, this, &MainWindow::showStart);
    connect(start_, &StartPage::newWanted, this, [this] {
        files_->newDocument();
        leaveStart();
    });
    connect(start_, &StartPage::openWanted, files_, &FileActions::open);
    connect(start_, &StartPage::fileWanted, this, [this](const QString& path, bool inNewWindow) {
        inNewWindow ? emit windowsWanted({path}) : files_->openAsked(path);
    });
    connect(start_, &StartPage::exampleWanted, files_, &FileActions::openExample);
    connect(start_, &StartPage::lessonWanted, this, &MainWindow::beginLesson);
    connect(start_, &StartPage::left, this, &MainWindow::leaveStart);
    connect(start_, &StartPage::failed, messages_, &MessageBar::showError);
    if (work_ != nullptr) {
        connect(start_, &StartPage::recoverWanted, work_, [this](const WorkCopyEntry& entry) {
            if (files_->mayDiscard()) work_->restore(entry);
        });
        connect(start_, &StartPage::putAwayWanted, work_, [this](const WorkCopyEntry& entry) {
            work_->putAway(entry);
            start_->refresh();
        });
    }
    connect(document_.get(), &Document::changed, this, [this](DocumentChange what) {
        if (what != DocumentChange::Camera) leaveStart();
    });
}

bool MainWindow::beginLesson(const QString& path) { return lesson_->begin(path); }

bool MainWindow::wantsStart() { return QSettings().value(kShowStart, true).toBool(); }

bool MainWindow::startShown() const {
    return start_ != nullptr && pages_->currentWidget() == start_;
}

void MainWindow::showStart() {
    if (start_ == nullptr || startShown()) return;
    panelsBeforeStart_ = saveState(kLayoutVersion);
    for (QDockWidget* panel : panels_) panel->hide();
    toolBar_->hide();
    messages_->hide();
    start_->refresh();
    pages_->setCurrentWidget(start_);
    refreshTitle();
}

void MainWindow::leaveStart() {
    if (!startShown()) return;
    pages_->setCurrentWidget(viewport_);
    messages_->show();
    toolBar_->show();
    restoreState(panelsBeforeStart_, kLayoutVersion);
    viewport_->setFocus();
    refreshTitle();
}

QWidget* MainWindow::scrolled(QWidget* content) {
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    // Its rows are never cut off: they scroll up and down only.
    scroll->setMinimumWidth(content->minimumSizeHint().width() +
                            style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    return scroll;
}

QDockWidget* MainWindow::addPanel(const QString& title, const QString& name, QWidget* content,
                                  Qt::DockWidgetArea area) {
    auto* panel = new QDockWidget(title, this);
    panel->setObjectName(name);
    panel->setWidget(content);
    addDockWidget(area, panel);
    panels_.append(panel);
    return panel;
}

void MainWindow::buildPanels() {
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    addPanel(tr("Edge Graph"), QStringLiteral("graphPanel"),
             new GraphPanel(*reading_, appearance_, this), Qt::RightDockWidgetArea);
    addPanel(tr("Readings"), QStringLiteral("candidatePanel"),
             new CandidatePanel(*document_, *reading_, *apply_, appearance_, this),
             Qt::RightDockWidgetArea);
    addPanel(tr("Thresholds"), QStringLiteral("thresholdPanel"),
             new ThresholdPanel(*document_, this), Qt::RightDockWidgetArea);
    auto* templates = new TemplatePanel(*document_, appearance_, this);
    connect(templates, &TemplatePanel::editorWanted, sketches_, &SketchActions::editTemplate);
    addPanel(tr("T-LIB"), QStringLiteral("templatePanel"), scrolled(templates),
             Qt::LeftDockWidgetArea);
    auto* history = new HistoryPanel(*document_, appearance_, this);
    connect(history, &HistoryPanel::failed, messages_, &MessageBar::showError);
    connect(history, &HistoryPanel::noticed, messages_, &MessageBar::showNotice);
    addPanel(tr("History"), QStringLiteral("historyPanel"), history, Qt::LeftDockWidgetArea);
    addPanel(tr("Surface"), QStringLiteral("surfacePanel"),
             scrolled(new SurfacePanel(*document_, *surface_, *surfaces_, *tools_, this)),
             Qt::LeftDockWidgetArea);
    auto* bodies = new BodyPanel(*document_, *bodies_, this);
    connect(bodies, &BodyPanel::failed, messages_, &MessageBar::showError);
    addPanel(tr("Solids"), QStringLiteral("bodyPanel"), bodies, Qt::LeftDockWidgetArea);
    // Enter ends what is typed, and the keys are the drawing's again.
    for (QAbstractSpinBox* number : findChildren<QAbstractSpinBox*>()) {
        connect(number, &QAbstractSpinBox::editingFinished, this, [this, number] {
            if (number->hasFocus()) viewport_->setFocus();
        });
        const auto tell = [this](const QString& why) {
            messages_->showError({Errc::BadValue, why.toStdString(), {}});
        };
        if (auto* box = qobject_cast<NumberBox*>(number)) {
            connect(box, &NumberBox::refused, this, tell);
        } else if (auto* whole = qobject_cast<WholeNumberBox*>(number)) {
            connect(whole, &WholeNumberBox::refused, this, tell);
        }
    }
    tabifyDockWidget(panels_[3], panels_[5]);
    tabifyDockWidget(panels_[4], panels_[6]);
    panels_[3]->raise();
    panels_[4]->raise();
}

void MainWindow::arrangeFor(const QSize& available) {
    // Where there is little room, panels share a place, each behind its tab.
    if (available.height() < kRoomForThree) tabifyDockWidget(panels_[0], panels_[1]);
    if (available.width() < kRoomForTwoSides) {
        for (const int panel : {3, 4, 5, 6}) tabifyDockWidget(panels_[0], panels_[panel]);
    }
    layout()->activate();  // else it is no smaller than with its panels side by side
    resize(QSize(kWidth, kHeight).boundedTo(available - QSize(kFrameWidth, kFrameHeight)));
    resizeDocks({panels_[0], panels_[1], panels_[2]}, {240, 380, 110}, Qt::Vertical);
    resizeDocks({panels_[0]}, {308}, Qt::Horizontal);
    if (available.width() >= kRoomForTwoSides) {
        resizeDocks({panels_[3], panels_[4]}, {380, 340}, Qt::Vertical);
        resizeDocks({panels_[3]}, {264}, Qt::Horizontal);
    }
    panels_[available.height() < kRoomForThree ? 1 : 0]->raise();
}

void MainWindow::buildToolBar() {
    toolBar_ = addToolBar(tr("Tools"));
    toolBar_->setObjectName(QStringLiteral("toolBar"));
    toolBar_->setMovable(false);
    toolBar_->setIconSize({22, 22});
    toolBar_->addActions(
        {files_->newAction, files_->openAction, files_->saveAction, files_->exportAction});
    toolBar_->addSeparator();
    toolBar_->addActions({edits_->undoAction, edits_->redoAction});
    toolBar_->addSeparator();
    toolBar_->addActions(edits_->toolActions);
    toolBar_->addSeparator();
    toolBar_->addActions({sketches_->applyAction, sketches_->automaticAction, edits_->clearAction});
    toolBar_->addSeparator();
    toolBar_->addActions({surfaces_->filletAction, surfaces_->smoothAction, surfaces_->mapAction});
    toolBar_->addSeparator();
    const auto view = [this](StandardView v) {
        return views_->viewActions[static_cast<std::size_t>(v)];
    };
    toolBar_->addActions({view(StandardView::Home), view(StandardView::Front),
                          view(StandardView::Right), view(StandardView::Top), views_->fitAction});
    toolBar_->addSeparator();
    toolBar_->addActions({views_->gridAction, views_->hiddenAction, views_->readingAction});
}

bool MainWindow::panelInUse() const {
    if (QApplication::activePopupWidget() != nullptr ||
        QApplication::activeModalWidget() != nullptr) {
        return true;
    }
    if (QApplication::mouseButtons() != Qt::NoButton) return true;
    return std::any_of(panels_.begin(), panels_.end(),
                       [this](const QDockWidget* panel) { return pointer_->isOver(*panel); });
}

void MainWindow::refreshTitle() {
    const QString path = document_->filePath();
    const QString name =
        path.isEmpty() ? files_->untitledName() : QFileInfo(path).completeBaseName();
    if (startShown() && path.isEmpty() && !document_->isModified()) {
        setWindowTitle(QStringLiteral("Edgewright"));
        return;
    }
    const QString shown = document_->isReadOnly() ? tr("%1 (read-only)").arg(name) : name;
    setWindowTitle(tr("%1[*] \u2013 Edgewright").arg(shown));
    setWindowModified(document_->isModified());
}

void MainWindow::restore() {
    if (!options_.remember) return;
    const QSettings settings;
    restoreGeometry(settings.value(QStringLiteral("window/geometry")).toByteArray());
    restoreState(settings.value(QStringLiteral("window/state")).toByteArray(), kLayoutVersion);
    files_->setExportUnit(exportUnitFromName(settings.value(kUnit).toString().toStdString()));
    if (start_ != nullptr) start_->setShownAtStart(settings.value(kShowStart, true).toBool());
    apply_->setAutomatic(settings.value(QStringLiteral("sketch/automatic"), true).toBool());
    sketches_->levelAction->setChecked(settings.value(kLevel, true).toBool());
    views_->gridAction->setChecked(settings.value(QStringLiteral("view/grid"), true).toBool());
    views_->hiddenAction->setChecked(settings.value(QStringLiteral("view/hidden"), false).toBool());
    views_->occlusionAction->setChecked(
        settings.value(QStringLiteral("view/occlusion"), false).toBool());
    views_->readingAction->setChecked(
        settings.value(QStringLiteral("view/reading"), true).toBool());
}

void MainWindow::remember() const {
    if (!options_.remember) return;
    QSettings settings;
    settings.setValue(QStringLiteral("window/geometry"), saveGeometry());
    settings.setValue(QStringLiteral("window/state"),
                      startShown() ? panelsBeforeStart_ : saveState(kLayoutVersion));
    settings.setValue(QStringLiteral("window/theme"), Appearance::modeName(appearance_.mode()));
    if (start_ != nullptr) settings.setValue(kShowStart, start_->shownAtStart());
    settings.setValue(QStringLiteral("sketch/automatic"), apply_->automatic());
    settings.setValue(kLevel, apply_->level());
    if (const auto unit = files_->exportUnit()) {
        const std::string_view name = exportUnitName(*unit);
        settings.setValue(kUnit, QString::fromLatin1(name.data(), qsizetype(name.size())));
    }
    settings.setValue(QStringLiteral("view/grid"), views_->gridAction->isChecked());
    settings.setValue(QStringLiteral("view/hidden"), views_->hiddenAction->isChecked());
    settings.setValue(QStringLiteral("view/occlusion"), views_->occlusionAction->isChecked());
    settings.setValue(QStringLiteral("view/reading"), views_->readingAction->isChecked());
}

QPixmap MainWindow::picture() {
    QPixmap picture = grab();
    if (startShown()) return picture;
    // While a widget is grabbed, a painter on an OpenGL widget inside it paints nowhere.
    const QImage drawing = viewport_->grabFramebuffer();
    QPainter painter(&picture);
    painter.drawImage(QRect(viewport_->mapTo(this, QPoint(0, 0)), viewport_->size()), drawing);
    return picture;
}

void MainWindow::endTyping() {
    if (QWidget* field = focusWidget()) field->clearFocus();
}

bool MainWindow::mayClose() {
    endTyping();
    surface_->settle();
    return files_->mayDiscard();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose()) {
        event->ignore();
        return;
    }
    remember();
    event->accept();
}

namespace {

/// The files that are dragged, or nothing where there is anything else among them.
QStringList draggedFiles(const QMimeData& data) {
    QStringList paths;
    for (const QUrl& url : data.urls()) {
        if (!url.isLocalFile()) return {};
        paths << url.toLocalFile();
    }
    return paths;
}

}  // namespace

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (!draggedFiles(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QStringList paths = draggedFiles(*event->mimeData());
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    // One takes the place of what is here; several have windows of their own.
    if (paths.size() > 1)
        emit windowsWanted(paths);
    else
        files_->openAsked(paths.front());
}

}  // namespace ew
