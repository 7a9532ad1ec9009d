// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/template_editor.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/core_text.h"
#include "ui/number_box.h"
#include "ui/template_editor/aspect_list.h"
#include "ui/template_editor/confusion_page.h"
#include "ui/template_editor/confusion_run.h"
#include "ui/template_editor/fault_list.h"
#include "ui/template_editor/rule_list.h"
#include "ui/template_editor/shape_sources.h"
#include "ui/template_editor/shape_view.h"
#include "ui/template_editor/trial_page.h"
#include "ui/template_editor/words_form.h"
#include "ui/theme/appearance.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {

constexpr QSize kFirstSize(1180, 740);
constexpr QSize kFrame(8, 40);  // what the window's frame takes of the screen
constexpr double kMostMm = 1e6;
constexpr int kDecimals = 3;
constexpr int kViewsWidth = 250;

QLabel* mutedLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

}  // namespace

TemplateEditor::TemplateEditor(Document& document, Appearance& appearance, Template start,
                               bool replaces, QWidget* parent)
    : QDialog(parent, Qt::Window),
      document_(document),
      appearance_(appearance),
      replaces_(replaces) {
    setObjectName(QStringLiteral("templateEditor"));
    setWindowTitle((replaces ? tr("Edit template") : tr("New template")) + QStringLiteral("[*]"));
    const TemplateLibrary& library = document.state().library;
    TemplateLibrary others = replaces ? library.without(start.id) : library;
    model_ = new TemplateModel(draftOf(std::move(start)), this);
    checker_ = new TemplateChecker(*model_, std::move(others), this);
    trial_ = new TrialReading(*model_, *checker_, this);
    confusion_ = new ConfusionRun(*model_, *checker_, this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kMargin, metrics::kMargin,
                               metrics::kMargin);
    layout->setSpacing(metrics::kSpace);
    buildTop(layout);
    auto* parts = new QSplitter(this);
    parts->setChildrenCollapsible(false);
    left_ = new QTabWidget(parts);
    left_->setObjectName(QStringLiteral("editorPages"));
    left_->addTab(buildShapePage(), tr("&Shape"));
    trialPage_ = new TrialPage(*model_, *trial_, appearance_, left_);
    left_->addTab(trialPage_, tr("T&ry it"));
    left_->addTab(new ConfusionPage(*confusion_, *checker_, left_), tr("Mi&x-ups"));
    parts->addWidget(left_);
    parts->addWidget(buildViews());
    parts->addWidget(buildRight());
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 0);
    parts->setStretchFactor(2, 2);
    layout->addWidget(parts, 1);
    layout->addWidget(buildButtons());
    resize(kFirstSize.boundedTo(screen()->availableSize() - kFrame));
    parts->setSizes({width() * 45 / 100, kViewsWidth, width() / 3});
    connectParts();
    showPicked();
    showReport();
    showAspects();
    names_->name()->setFocus();
}

TemplateEditor::~TemplateEditor() = default;

void TemplateEditor::buildTop(QVBoxLayout* layout) {
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kSpace);
    names_ = new NameForm(*model_, checker_->others(), replaces_, this);
    row->addWidget(names_, 1);
    auto* sources = new QPushButton(tr("Shape &from"), this);
    sources->setObjectName(QStringLiteral("shapeSources"));
    sources->setAutoDefault(false);
    auto* menu = new QMenu(sources);
    fillSources(menu, document_.state(),
                [this](Result<Template> from) { takeShape(std::move(from)); });
    sources->setMenu(menu);
    row->addWidget(sources);
    for (const bool back : {true, false}) {
        QUndoStack& stack = model_->undoStack();
        QAction* action = back ? stack.createUndoAction(this, tr("Undo"))
                               : stack.createRedoAction(this, tr("Redo"));
        action->setShortcuts(back ? QKeySequence::Undo : QKeySequence::Redo);
        action->setIcon(themedIcon(back ? QStringLiteral("undo") : QStringLiteral("redo")));
        action->setObjectName(back ? QStringLiteral("editorUndo") : QStringLiteral("editorRedo"));
        addAction(action);
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setIconSize({metrics::kIcon, metrics::kIcon});
        row->addWidget(button);
    }
    layout->addLayout(row);
}

QWidget* TemplateEditor::buildShapePage() {
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(metrics::kSpace, metrics::kSpace, metrics::kSpace, metrics::kSpace);
    layout->setSpacing(metrics::kSpace);
    shape_ = new ShapeView(appearance_, page);
    shape_->setObjectName(QStringLiteral("shapeView"));
    shape_->setShape(model_->draft().tmpl.shape);
    layout->addWidget(shape_, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kSpace);
    pickedText_ = mutedLabel(page);
    row->addWidget(pickedText_, 1);
    for (std::size_t k = 0; k < 3; ++k) {
        const QString axis(QChar::fromLatin1("XYZ"[k]));
        auto* box = new NumberBox(page);
        box->setObjectName(QStringLiteral("vertex") + axis);
        box->setRange(-kMostMm, kMostMm);
        box->setDecimals(kDecimals);
        box->setPrefix(axis + QStringLiteral(" "));
        box->setKeyboardTracking(false);
        box->setAccessibleName(tr("%1 of the corner").arg(axis));
        box->setToolTip(tr("Where the corner is in the reference shape"));
        connect(box, &NumberBox::refused, this, [this](const QString& why) {
            refused_ = why;
            showReport();
        });
        connect(box, &NumberBox::valueChanged, this, [this, k](double value) {
            const int vertex = shape_->pickedVertex();
            if (vertex < 0) return;
            Vec3 to = model_->draft().tmpl.shape.vertices[static_cast<std::size_t>(vertex)];
            to[static_cast<Eigen::Index>(k)] = value;
            model_->moveVertex(vertex, to);
        });
        row->addWidget(box);
        place_[k] = box;
    }
    pickedText_->setMinimumHeight(place_[0]->sizeHint().height());
    layout->addLayout(row);
    return page;
}

QWidget* TemplateEditor::buildViews() {
    auto* views = new QWidget;
    auto* layout = new QVBoxLayout(views);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kGap);
    aspectText_ = mutedLabel(views);
    layout->addWidget(aspectText_);
    aspects_ = new AspectList(appearance_, views);
    aspects_->setObjectName(QStringLiteral("aspectList"));
    layout->addWidget(aspects_, 1);
    views->setMinimumWidth(kViewsWidth * 3 / 4);
    return views;
}

QWidget* TemplateEditor::buildRight() {
    auto* right = new QWidget;
    auto* layout = new QVBoxLayout(right);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(metrics::kSpace);
    auto* pages = new QTabWidget(right);
    auto* rules = new QWidget;
    auto* rulesLayout = new QVBoxLayout(rules);
    rulesLayout->setContentsMargins(metrics::kSpace, metrics::kSpace, metrics::kSpace,
                                    metrics::kSpace);
    auto* hint = mutedLabel(rules);
    hint->setText(tr("Found in this shape. Every instance keeps what is ticked."));
    rulesLayout->addWidget(hint);
    rules_ = new RuleList(*model_, rules);
    rulesLayout->addWidget(rules_, 1);
    freedoms_ = mutedLabel(rules);
    freedoms_->setObjectName(QStringLiteral("freedoms"));
    rulesLayout->addWidget(freedoms_);
    pages->addTab(rules, tr("R&ules"));
    pages->addTab(new WordsForm(*model_, checker_->others(), pages), tr("&About it"));
    layout->addWidget(pages, 1);
    faults_ = new FaultList(right);
    layout->addWidget(faults_);
    return right;
}

QWidget* TemplateEditor::buildButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    save_ = buttons->addButton(replaces_ ? tr("Sa&ve changes") : tr("A&dd to the document"),
                               QDialogButtonBox::AcceptRole);
    save_->setObjectName(QStringLiteral("saveTemplate"));
    // Enter ends what is typed into a field; a half-made template must not be saved by it.
    save_->setAutoDefault(false);
    buttons->button(QDialogButtonBox::Cancel)->setAutoDefault(false);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] { save(); });
    connect(buttons, &QDialogButtonBox::rejected, this, &TemplateEditor::reject);
    return buttons;
}

void TemplateEditor::connectParts() {
    connect(model_, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.shape) shape_->setShape(model_->draft().tmpl.shape);
        if (what.shape || what.rules) showPicked();
        setWindowModified(model_->isChanged());
        refused_.clear();
    });
    connect(checker_, &TemplateChecker::reportChanged, this, &TemplateEditor::showReport);
    connect(checker_, &TemplateChecker::aspectsChanged, this, &TemplateEditor::showAspects);
    connect(shape_, &ShapeView::picked, this, &TemplateEditor::showPicked);
    connect(rules_, &RuleList::pointedAt, this, &TemplateEditor::showRule);
    connect(faults_, &FaultList::mendWanted, this, &TemplateEditor::mend);
    connect(aspects_, &AspectList::lookedAt, this, [this](const Vec3& direction) {
        left_->setCurrentIndex(0);
        shape_->lookAlong(direction);
    });
    for (QLineEdit* line : findChildren<QLineEdit*>()) line->installEventFilter(this);
    for (NumberBox* box : place_) box->installEventFilter(this);
}

/// Undo is the editor's everywhere in it, also where a field would take back what is typed.
bool TemplateEditor::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

void TemplateEditor::takeShape(Result<Template> from) {
    if (from) {
        model_->takeShape(*std::move(from));
        return;
    }
    refused_ = coreText(from.error().message);
    showReport();
}

void TemplateEditor::showPicked() {
    const int vertex = shape_->pickedVertex();
    const auto edge = shape_->pickedEdge();
    const auto& vertices = model_->draft().tmpl.shape.vertices;
    for (std::size_t k = 0; k < 3; ++k) {
        place_[k]->setVisible(vertex >= 0);
        if (vertex < 0) continue;
        const QSignalBlocker quiet(place_[k]);
        place_[k]->setValue(
            vertices[static_cast<std::size_t>(vertex)][static_cast<Eigen::Index>(k)]);
    }
    if (vertex >= 0) {
        pickedText_->setText(tr("Corner %1").arg(vertex));
    } else if (edge) {
        const double length = (vertices[static_cast<std::size_t>((*edge)[1])] -
                               vertices[static_cast<std::size_t>((*edge)[0])])
                                  .norm();
        pickedText_->setText(tr("Edge %1, length %2; its rules are in bold.")
                                 .arg(edgesText({*edge}), QLocale().toString(length, 'f', 1)));
    } else {
        pickedText_->setText(tr("Drag to turn it; click a corner or an edge."));
    }
    rules_->setMarkedEdge(edge);
}

void TemplateEditor::showRule(int rule) {
    const auto& rules = model_->draft().rules;
    const bool there = rule >= 0 && static_cast<std::size_t>(rule) < rules.size();
    shape_->setLit(there ? rules[static_cast<std::size_t>(rule)].relation.edges
                         : std::vector<TemplateEdge>());
}

void TemplateEditor::showReport() {
    const DraftReport& report = checker_->report();
    rules_->setReport(report);
    names_->setFaults(report.faults);
    std::vector<DraftFault> all = report.faults;
    const auto& more = checker_->aspects().faults;
    all.insert(all.end(), more.begin(), more.end());
    if (!refused_.isEmpty()) {
        DraftFault fault;
        fault.text = refused_;
        all.insert(all.begin(), fault);
    }
    faults_->show(all);
    save_->setEnabled(report.usable());
    if (report.openFreedoms < 0) {
        freedoms_->clear();
    } else if (report.openFreedoms == 0) {
        freedoms_->setText(tr("All instances have the proportions of this shape."));
    } else {
        freedoms_->setText(
            tr("%n proportion(s) stay open; what a drawing does not tell is taken "
               "from this shape.",
               nullptr, report.openFreedoms));
    }
}

void TemplateEditor::showAspects() {
    const auto& aspects = checker_->aspects().aspects;
    aspects_->show(aspects, checker_->others());
    if (checker_->isLooking()) {
        aspectText_->setText(tr("Looking at it from all sides\u2026"));
    } else if (aspects.empty()) {
        aspectText_->setText(tr("No views: the shape has to be mended first."));
    } else {
        const auto whole = std::count_if(aspects.begin(), aspects.end(), [](const auto& f) {
            return f.aspect.kind == AspectKind::Explicit;
        });
        aspectText_->setText(
            tr("%n view(s) that it is read from", nullptr, static_cast<int>(whole)));
    }
    showReport();
}

void TemplateEditor::mend(const DraftFault& fault) {
    if (fault.mend == DraftFault::Mend::UseId) {
        model_->setWords(-1, tr("Set id"), [&](Template& t) { t.id = fault.id; });
    } else if (fault.mend == DraftFault::Mend::DropRule) {
        model_->setRule(fault.rule, false);
    }
}

bool TemplateEditor::save() {
    checker_->settle();
    if (!checker_->report().usable()) return false;
    const Template tmpl = templateOf(model_->draft());
    if (const auto done = document_.defineTemplate(tmpl, replaces_); !done) {
        refused_ = coreText(done.error().message);
        showReport();
        return false;
    }
    emit saved(QString::fromStdString(tmpl.name));
    accept();
    return true;
}

TemplateEditor::Answer TemplateEditor::ask() {
    if (question_) return question_();
    QMessageBox box(QMessageBox::Question, QStringLiteral("Edgewright"),
                    tr("The template was changed."), QMessageBox::NoButton, this);
    box.setInformativeText(tr("What you changed is lost when it is not saved."));
    const QAbstractButton* keep = nullptr;
    if (checker_->report().usable()) keep = box.addButton(save_->text(), QMessageBox::AcceptRole);
    const QAbstractButton* drop = box.addButton(tr("Dis&card"), QMessageBox::DestructiveRole);
    QPushButton* stay = box.addButton(tr("&Go on editing"), QMessageBox::RejectRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    if (keep != nullptr && box.clickedButton() == keep) return Answer::Save;
    return box.clickedButton() == drop ? Answer::Discard : Answer::Stay;
}

void TemplateEditor::reject() {
    if (!model_->isChanged()) {
        QDialog::reject();
        return;
    }
    checker_->settle();
    switch (ask()) {
        case Answer::Save:
            save();
            break;
        case Answer::Discard:
            QDialog::reject();
            break;
        case Answer::Stay:
            break;
    }
}

}  // namespace ew
