// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/shape_sources.h"

#include <QCoreApplication>
#include <QMenu>

#include "core/document/template_from_solid.h"
#include "ui/core_text.h"

namespace ew {

namespace {

struct Sources {
    Q_DECLARE_TR_FUNCTIONS(ShapeSources)
};

constexpr int kCornersInRow = 12;
constexpr int kMoreCorners[] = {16, 20, 24};

/// An ampersand in a name is no mnemonic.
QString plain(QString text) { return text.replace('&', QStringLiteral("&&")); }

}  // namespace

QString familyText(Family family) {
    switch (family) {
        case Family::Prism:
            return Sources::tr("Prism");
        case Family::Pyramid:
            return Sources::tr("Pyramid");
        case Family::Frustum:
            break;
    }
    return Sources::tr("Frustum");
}

void fillSources(QMenu* menu, const DocumentState& state,
                 const std::function<void(Result<Template>)>& take) {
    QMenu* solids = menu->addMenu(Sources::tr("&Solid"));
    for (std::size_t i = 0; i < state.bodies.size(); ++i) {
        const std::string name = bodyName(state.bodies, i);
        solids->addAction(plain(coreText(name)), menu, [take, body = state.bodies[i], name] {
            take(templateFromBodies({body}, "t", name));
        });
    }
    solids->setEnabled(!state.bodies.empty());
    QMenu* templates = menu->addMenu(Sources::tr("&Template"));
    for (std::size_t i = 0; i < state.library.size(); ++i) {
        templates->addAction(plain(coreText(state.library.at(i).name)), menu,
                             [take, tmpl = state.library.at(i)] { take(tmpl); });
    }
    menu->addSeparator();
    for (const Family family : {Family::Prism, Family::Pyramid, Family::Frustum}) {
        QMenu* corners = menu->addMenu(familyText(family));
        corners->setObjectName(QStringLiteral("family%1").arg(static_cast<int>(family)));
        const auto add = [&](int n) {
            corners->addAction(Sources::tr("over %n corner(s)", nullptr, n), menu,
                               [take, family, n] { take(familyTemplate(family, n)); });
        };
        for (int n = kFewestCorners; n <= kCornersInRow; ++n) add(n);
        for (const int n : kMoreCorners) add(n);
    }
}

}  // namespace ew
