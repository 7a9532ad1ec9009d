// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/help_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "ui/theme/colours.h"

namespace ew {

namespace {

struct Help {
    Q_DECLARE_TR_FUNCTIONS(Help)
};

void showText(QWidget* window, const QString& name, const QString& title, const QString& html,
              const QSize& size) {
    if (auto* open = window->findChild<QDialog*>(name)) {
        open->raise();
        open->activateWindow();
        return;
    }
    auto* dialog = new QDialog(window);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* layout = new QVBoxLayout(dialog);
    layout->setSpacing(metrics::kMargin);
    auto* text = new QTextBrowser(dialog);
    text->setFrameShape(QFrame::NoFrame);
    text->document()->setDocumentMargin(metrics::kMargin);
    text->setHtml(html);
    text->setAccessibleName(title);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
    layout->addWidget(text);
    layout->addWidget(buttons);
    dialog->resize(size);
    dialog->show();
}

QString rows(const QList<QPair<QString, QString>>& entries) {
    QString html = QStringLiteral("<table cellspacing='0' cellpadding='4'>");
    for (const auto& [what, how] : entries) {
        html += QStringLiteral("<tr><td><b>%1</b></td><td>%2</td></tr>")
                    .arg(what.toHtmlEscaped(), how.toHtmlEscaped());
    }
    return html + QStringLiteral("</table>");
}

void collect(const QMenu* menu, QList<QPair<QString, QString>>& entries) {
    for (const QAction* action : menu->actions()) {
        if (action->menu() != nullptr) {
            collect(action->menu(), entries);
        } else if (!action->shortcut().isEmpty()) {
            QString name = action->text();
            name.remove('&');
            QStringList keys;
            for (const QKeySequence& key : action->shortcuts()) {
                keys << key.toString(QKeySequence::NativeText);
            }
            entries.append({keys.join(QStringLiteral(", ")), name});
        }
    }
}

QString surfaceHelp() {
    return QStringLiteral("<h3>%1</h3>").arg(Help::tr("Smooth shapes (Surface panel)")) +
           rows({{Help::tr("Choose edges"),
                  Help::tr("all, convex, concave, or picked by a click (K): one edge, a loop or "
                           "all edges of a face; Shift adds")},
                 {Help::tr("Fillet"),
                  Help::tr("drag the radius to see it, let go to keep it; an edge without room "
                           "gets a smaller radius and is listed")},
                 {Help::tr("Change it later"),
                  Help::tr("fillets are settings: choose the edges again and drag; edges that "
                           "survive a cut or an addition keep theirs")},
                 {Help::tr("Smooth surface"),
                  Help::tr("S turns it on and off; levels, or a tolerance for as many triangles "
                           "as are needed; C shows the cage over it")},
                 {Help::tr("Pull a face"),
                  Help::tr("L: drag it, or click it and type a distance; a number typed after a "
                           "pull corrects it")},
                 {Help::tr("Numbers"),
                  Help::tr("sums and units count: 120/3 + 2, 2.5 cm, 1 1/2 in; a comma is a "
                           "decimal mark, too")},
                 {Help::tr("Several solids"),
                  Help::tr("the Solids panel shows, hides, names, moves, copies, joins and deletes "
                           "them")},
                 {Help::tr("Both sides at once"),
                  Help::tr("Sketch, Mirror plane: what you draw, pull and round is done on both "
                           "sides of it")},
                 {Help::tr("Draw on it"),
                  Help::tr("B: every stroke goes onto the surface; Ctrl+M maps what is drawn "
                           "already")}});
}

QString templateHelp() {
    return QStringLiteral("<h3>%1</h3>").arg(Help::tr("Templates of your own")) +
           rows({{Help::tr("Make one"),
                  Help::tr("Sketch, Template editor: it begins with the solid; a template, or a "
                           "prism, pyramid or frustum over any polygon, can take its place")},
                 {Help::tr("Rules"),
                  Help::tr("what is ticked holds for every drawing of it; point at a rule and its "
                           "edges light up")},
                 {Help::tr("Views"),
                  Help::tr("from where it can be drawn, and which other template looks the same "
                           "from there; a click turns the shape")},
                 {Help::tr("Try it"),
                  Help::tr("draw it on the sheet and see whether it is read, before it is added to "
                           "the document; Mix-ups counts how often it would be taken for another")},
                 {Help::tr("Change or copy one"),
                  Help::tr("right click in the T-LIB panel; templates of the document are edited, "
                           "all can be duplicated")}});
}

}  // namespace

void showQuickHelp(QWidget* window) {
    const QString tour =
        QStringLiteral(
            "<h3>%1</h3><ol><li>%2</li><li>%3</li><li>%4</li><li>%5</li><li>%6</li></ol>")
            .arg(
                Help::tr("In five lines"),
                Help::tr(
                    "Draw the edges that you would see of a box, in any order; one stroke may draw "
                    "several edges."),
                Help::tr("The Edge Graph panel shows lines and corners as they are read; the "
                         "drawing shows a "
                         "faint preview."),
                Help::tr("Lift the pen. When the reading is clear it becomes a solid; Enter does "
                         "it at once."),
                Help::tr("Draw on the solid to add to it (green) or to cut it (red). Keys 1 to 9 "
                         "take another reading, also afterwards."),
                Help::tr(
                    "If something does not meet, it is marked, with a button that repairs it."));
    const QString gestures =
        QStringLiteral("<h3>%1</h3>").arg(Help::tr("Pen and mouse")) +
        rows(
            {{Help::tr("Draw"), Help::tr("pen tip, or left button")},
             {Help::tr("Erase a stroke"),
              Help::tr("eraser end of the pen, or the eraser tool (E)")},
             {Help::tr("Cancel a stroke"), Help::tr("Escape while drawing")},
             {Help::tr("Orbit"),
              Help::tr("right or middle button, Alt with left, pen's side button")},
             {Help::tr("Move the view"), Help::tr("Shift with the middle button, Space with left")},
             {Help::tr("Zoom"), Help::tr("wheel, or two fingers")},
             {Help::tr("Undo"),
              Help::tr(
                  "Ctrl+Z: strokes and steps in the order in which they were made, and the stroke "
                  "under way; Ctrl+Shift+Z goes forward")}});
    showText(window, QStringLiteral("quickHelp"), Help::tr("Quick help"),
             tour + surfaceHelp() + templateHelp() + gestures, {560, 620});
}

void showShortcuts(QWidget* window, const QList<QAction*>& menus) {
    QString html;
    for (const QAction* top : menus) {
        if (top->menu() == nullptr) continue;
        QList<QPair<QString, QString>> entries;
        collect(top->menu(), entries);
        if (entries.isEmpty()) continue;
        QString name = top->text();
        html += QStringLiteral("<h3>%1</h3>").arg(name.remove('&').toHtmlEscaped()) + rows(entries);
    }
    showText(window, QStringLiteral("shortcuts"), Help::tr("Keyboard shortcuts"), html, {460, 600});
}

void showAbout(QWidget* window) {
    QMessageBox box(window);
    box.setWindowTitle(Help::tr("About Edgewright"));
    box.setIconPixmap(QIcon(QStringLiteral(":/icons/edgewright.svg")).pixmap(72, 72));
    box.setText(QStringLiteral("<h3>Edgewright %1</h3>").arg(QStringLiteral(EDGEWRIGHT_VERSION)));
    box.setInformativeText(Help::tr(
        "Turns pen strokes into solids, step by step, with a topology library.\n\n"
        "Free software under the GNU General Public License, version 3 or later, without any "
        "warranty. Uses Qt, VTK, OpenMesh, OpenSubdiv, CGAL and Eigen."));
    box.exec();
}

}  // namespace ew
