// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <vector>

#include "core/base/result.h"

namespace ew {

class Document;

/// The bodies that are chosen, by index; none that is not there.
class BodySelection : public QObject {
    Q_OBJECT

  public:
    explicit BodySelection(Document& document, QObject* parent = nullptr);

    /// Ascending.
    const std::vector<int>& chosen() const { return chosen_; }
    void choose(std::vector<int> bodies);
    /// Deletes the chosen ones, or all where none is chosen. Errors: those of
    /// Document::deleteBody().
    Result<void> remove();

  signals:
    void changed();

  private:
    Document& document_;
    std::vector<int> chosen_;
    std::size_t count_ = 0;  ///< of bodies when it was chosen
};

}  // namespace ew
