// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/body_selection.h"

#include <algorithm>

#include "core/document/document.h"

namespace ew {

BodySelection::BodySelection(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (what != DocumentChange::Bodies) return;
        // Where one came or went, places are others.
        if (document_.state().bodies.size() != count_) choose({});
    });
}

void BodySelection::choose(std::vector<int> bodies) {
    count_ = document_.state().bodies.size();
    std::sort(bodies.begin(), bodies.end());
    std::erase_if(bodies, [this](int b) { return b < 0 || static_cast<std::size_t>(b) >= count_; });
    if (bodies == chosen_) return;
    chosen_ = std::move(bodies);
    emit changed();
}

Result<void> BodySelection::remove() {
    std::vector<int> chosen = chosen_;
    const bool all = chosen.empty() || chosen.size() == document_.state().bodies.size();
    if (all) return document_.deleteBodies();
    // From the last one on, so that the others keep their places.
    std::reverse(chosen.begin(), chosen.end());
    for (const int body : chosen) {
        if (auto done = document_.deleteBody(body); !done) return done;
    }
    return {};
}

}  // namespace ew
