// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/aspect_facts.h"

#include <algorithm>
#include <map>

#include "core/tlib/aspect_view.h"
#include "core/tlib/symmetry.h"

namespace ew {

namespace {

constexpr int kViews = 400;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Counts from how many of the directions each explicit aspect is seen.
class ViewCount {
  public:
    explicit ViewCount(const LibraryEntry& entry) : entry_(entry), counts_(entry.aspects.size()) {
        for (std::size_t a = 0; a < entry.aspects.size(); ++a) {
            const Aspect& aspect = entry.aspects[a];
            if (aspect.kind != AspectKind::Explicit || aspect.edgeOn) continue;
            for (const std::vector<int>& symmetry : entry.symmetries) {
                known_.emplace(shownEdges(aspect, entry.analysis, symmetry), a);
            }
        }
    }

    void look(const Vec3& direction) {
        std::vector<bool> mask;
        for (const Vec3& n : entry_.analysis.faceNormals) mask.push_back(n.dot(direction) < 0.0);
        int& index = entry_.analysis.convex ? byMask_.try_emplace(mask, kUnknown).first->second
                                            : (fresh_ = kUnknown);
        if (index == kUnknown) {
            const Aspect seen = viewAspect(entry_.tmpl.shape, entry_.analysis, direction);
            if (seen.name.empty()) return;
            const auto it =
                known_.find(shownEdges(seen, entry_.analysis, entry_.symmetries.front()));
            index = it == known_.end() ? kNone : static_cast<int>(it->second);
        }
        if (index >= 0) ++counts_[at(index)];
    }

    double share(std::size_t aspect) const { return static_cast<double>(counts_[aspect]) / kViews; }

  private:
    static constexpr int kUnknown = -2;
    static constexpr int kNone = -1;
    const LibraryEntry& entry_;
    std::vector<int> counts_;
    std::map<ShownEdges, std::size_t> known_;
    std::map<std::vector<bool>, int> byMask_;  // which faces are seen settles a convex shape's view
    int fresh_ = kUnknown;
};

/// Share of the directions from which all faces of a mouth are seen.
double mouthShare(const LibraryEntry& entry, const Aspect& aspect,
                  const std::vector<Vec3>& directions) {
    const auto seen = std::count_if(directions.begin(), directions.end(), [&](const Vec3& d) {
        return std::all_of(aspect.mouth.begin(), aspect.mouth.end(),
                           [&](int f) { return entry.analysis.faceNormals[at(f)].dot(d) < 0.0; });
    });
    return static_cast<double>(seen) / static_cast<double>(directions.size());
}

/// Explicit aspects are compared with explicit ones, those of cuts with those of cuts.
std::vector<std::string> shownBy(const Aspect& aspect, const std::string& own,
                                 const LibraryIndex& others) {
    std::vector<std::string> ids;
    const auto refs = others.byCode.find(aspect.form.code);
    if (refs == others.byCode.end()) return ids;
    for (const AspectRef& ref : refs->second) {
        const LibraryEntry& other = *others.entries[at(ref.entry)];
        if (other.tmpl.id == own) continue;
        const bool cut = other.aspects[at(ref.aspect)].kind != AspectKind::Explicit;
        if (cut != (aspect.kind != AspectKind::Explicit)) continue;
        if (std::find(ids.begin(), ids.end(), other.tmpl.id) == ids.end()) {
            ids.push_back(other.tmpl.id);
        }
    }
    return ids;
}

}  // namespace

std::vector<AspectFacts> aspectFacts(const LibraryEntry& entry, const TemplateLibrary& others,
                                     bool implicit) {
    const std::vector<Vec3> directions = spreadDirections(kViews);
    ViewCount count(entry);
    for (const Vec3& d : directions) count.look(d);
    std::vector<AspectFacts> out;
    for (std::size_t a = 0; a < entry.aspects.size(); ++a) {
        AspectFacts facts;
        facts.aspect = entry.aspects[a];
        if (!facts.aspect.edgeOn) facts.share = count.share(a);
        facts.alsoShownBy = shownBy(facts.aspect, entry.tmpl.id, others.index());
        out.push_back(std::move(facts));
    }
    if (implicit) {
        const auto whole = entryOnSolid(entry);
        const LibraryIndex& onSolid = onSolidIndex(others.index());
        for (const Aspect& aspect : whole->aspects) {
            if (aspect.kind == AspectKind::Explicit) continue;
            AspectFacts facts;
            facts.aspect = aspect;
            if (aspect.kind == AspectKind::Mouth) {
                facts.share = mouthShare(entry, aspect, directions);
            }
            facts.alsoShownBy = shownBy(aspect, entry.tmpl.id, onSolid);
            out.push_back(std::move(facts));
        }
    }
    std::stable_sort(out.begin(), out.end(), [](const AspectFacts& x, const AspectFacts& y) {
        if (x.aspect.kind != y.aspect.kind) return x.aspect.kind < y.aspect.kind;
        return x.share.value_or(-1.0) > y.share.value_or(-1.0);
    });
    return out;
}

std::string sameTemplate(const LibraryEntry& entry, const TemplateLibrary& others) {
    for (const auto& other : others.index().entries) {
        if (other->tmpl.id == entry.tmpl.id) continue;
        if (areSame(entry.tmpl, entry.analysis, other->tmpl, other->analysis)) {
            return other->tmpl.id;
        }
    }
    return {};
}

}  // namespace ew
