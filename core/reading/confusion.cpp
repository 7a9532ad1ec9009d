// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/confusion.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

#include "core/reading/interpret.h"
#include "core/reading/template_drawing.h"

namespace ew {
namespace {

void readOne(const TemplateLibrary& library, const LibraryEntry& entry, std::uint64_t row,
             int index, const ConfusionOptions& options, ConfusionRow& out, std::mutex& lock) {
    Random random(Random::mix(options.seed, row, static_cast<std::uint64_t>(index)));
    const auto drawn = randomDrawing(entry, random);
    if (!drawn) return;
    const std::vector<Stroke> strokes = drawByHand(drawn->lines, options.hand, random);
    InterpretOptions read;
    read.camera = drawn->camera;
    const Interpretation reading = interpret(strokes, library, read);
    const bool offered =
        std::any_of(reading.candidates.begin(), reading.candidates.end(),
                    [&](const Candidate& c) { return c.templateId == entry.tmpl.id; });
    const std::scoped_lock guard(lock);
    ++out.drawings;
    if (reading.accepted) {
        ++out.readAs[reading.candidates[static_cast<std::size_t>(*reading.accepted)].templateId];
    } else {
        ++(offered ? out.asked : out.refused);
    }
}

}  // namespace

int ConfusionRow::right() const {
    const auto it = readAs.find(templateId);
    return it == readAs.end() ? 0 : it->second;
}

int ConfusionRow::wrong() const {
    int sum = 0;
    for (const auto& [id, count] : readAs) sum += id == templateId ? 0 : count;
    return sum;
}

std::vector<ConfusionRow> confusion(const TemplateLibrary& library,
                                    const std::vector<std::string>& ids,
                                    const ConfusionOptions& options) {
    std::vector<ConfusionRow> rows(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) rows[i].templateId = ids[i];
    const LibraryIndex& index = library.index();
    const int each = std::max(1, options.drawings);
    const int all = each * static_cast<int>(ids.size());
    std::atomic<int> next{0};
    std::atomic<int> done{0};
    std::atomic<bool> stop{false};
    std::mutex lock;
    const auto work = [&] {
        for (int job = next++; job < all && !stop; job = next++) {
            const auto row = static_cast<std::size_t>(job / each);
            const auto known = index.byId.find(ids[row]);
            if (known != index.byId.end()) {
                readOne(library, *index.entries[static_cast<std::size_t>(known->second)], row,
                        job % each, options, rows[row], lock);
            }
            const double share = static_cast<double>(++done) / all;
            if (!options.progress) continue;
            const std::scoped_lock guard(lock);
            if (!options.progress(share)) stop = true;
        }
    };
    std::vector<std::thread> others;
    for (int t = 1; t < options.threads; ++t) others.emplace_back(work);
    work();
    for (std::thread& t : others) t.join();
    return rows;
}

}  // namespace ew
