// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace ew {

/// A file that was opened or saved before.
struct RecentFile {
    QString path;           ///< absolute
    QDateTime used;         ///< when it was opened or saved last
    bool pinned = false;    ///< stays in the list, before all others
    std::string thumbnail;  ///< PNG, or nothing; it stays when the file is gone
    bool missing = false;   ///< there is no such file any more, or the disk it is on is away
};

/// The list of files that were worked on last, shared by all windows of a person: each call reads
/// the file anew and writes it whole, under a lock.
class RecentFiles {
  public:
    /// Most files that are kept without being pinned.
    static constexpr int kMost = 40;

    /// \param path  of the file that holds the list; made when something is first added.
    explicit RecentFiles(QString path) : path_(std::move(path)) {}
    /// `edgewright/recent.json` in the user's state folder ($XDG_STATE_HOME, ~/.local/state).
    static QString standardPath();

    /// The pinned ones first, then those used last. A list that cannot be read is empty.
    std::vector<RecentFile> list() const;
    /// Puts a file in front. Where it is there already it keeps its pin, and its thumbnail unless a
    /// new one is given.
    /// \param path  is made absolute. Errc::CannotWrite.
    Result<void> add(const QString& path, const std::string& thumbnail);
    /// Errc::CannotWrite. A file that is not in the list is left alone.
    Result<void> setPinned(const QString& path, bool pinned);
    /// The file itself stays. Errc::CannotWrite.
    Result<void> remove(const QString& path);

  private:
    template <class Change>
    Result<void> change(const Change& change);

    QString path_;
};

}  // namespace ew
