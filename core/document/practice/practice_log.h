// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <cstdint>
#include <vector>

#include "core/base/result.h"

namespace ew {

/// One exercise that was done.
struct PracticeResult {
    std::int64_t time = 0;  ///< seconds since 1970, UTC
    int level = 1;
    std::uint32_t seed = 0;
    double accuracy = 0.0;  ///< 0 to 1
    double seconds = 0.0;   ///< the pen was down
    double wobblePx = 0.0;
    int strokes = 0;
    bool operator==(const PracticeResult&) const = default;
};

/// The newest that are kept of one person.
inline constexpr std::size_t kMostResults = 500;

/// Adds one at the end; the oldest go.
void addResult(std::vector<PracticeResult>& results, const PracticeResult& result);

/// What one person practised on this computer, in a file of hers.
class PracticeLog {
  public:
    /// \param path  of the file; made with the first result.
    explicit PracticeLog(QString path) : path_(std::move(path)) {}
    /// `edgewright/practice.json` in the user's state folder.
    static QString standardPath();

    /// The oldest first. Empty where there is no file. Errors: those of parseJson() and of what a
    /// value may not be.
    Result<std::vector<PracticeResult>> list() const;
    /// A file that cannot be read is left as it is. Errors: those of list(), CannotWrite.
    Result<void> add(const PracticeResult& result) const;

  private:
    QString path_;
};

}  // namespace ew
