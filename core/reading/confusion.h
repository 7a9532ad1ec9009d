// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/hand/hand_model.h"
#include "core/tlib/library.h"

namespace ew {

/// What became of random drawings of one template.
struct ConfusionRow {
    std::string templateId;
    int drawings = 0;                   ///< that were made; fewer where few views are readable
    std::map<std::string, int> readAs;  ///< taken by themselves, by what they were taken for
    int asked = 0;    ///< refused or asked about, with the template among the candidates
    int refused = 0;  ///< without it
    int right() const;
    int wrong() const;  ///< taken for something else
};

struct ConfusionOptions {
    int drawings = 200;  ///< of each template, >= 1
    HandLevel hand = kLightHand;
    std::uint64_t seed = 1;
    int threads = 2;  ///< >= 1
    /// Share done, 0..1; false stops. Called from one thread at a time.
    std::function<bool(double)> progress;
};

/// Random drawings of each of these templates by a model of a hand, read against the whole library:
/// which template is taken for which. Deterministic in the seed, whatever the number of threads.
/// \param ids  of templates in the library; others give rows without drawings.
/// \return a row for each id; what was done until then where `progress` stopped it.
std::vector<ConfusionRow> confusion(const TemplateLibrary& library,
                                    const std::vector<std::string>& ids,
                                    const ConfusionOptions& options);

}  // namespace ew
