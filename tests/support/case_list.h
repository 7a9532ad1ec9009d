// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "core/solid/boolean.h"
#include "tests/support/modification_cases.h"

namespace ew::test {

/// Makes cases of one target seen through one camera.
class CaseList {
  public:
    CaseList(std::string scene, const Solid& target, const Vec3& center, int view,
             const Pose& pose = {})
        : scene_(std::move(scene)),
          view_(view),
          target_{target, pose},
          camera_(modificationCamera(view, center, pose)) {}

    /// Lines empty: those that are new and visible. Where fewer than `least` are, they do not tell
    /// what is meant (the depth of a pocket whose bottom is hidden).
    void add(const std::string& name, Operation op, const std::string& templateId,
             const PolyhedronSpec& tool, Lines3 lines = {}, std::size_t least = 1) {
        ModificationCase c{scene_, name, view_, target_, camera_, op, templateId, std::move(lines)};
        const auto result = combine(target_.solid, solidOf(tool),
                                    op == Operation::Add ? BooleanKind::Add : BooleanKind::Cut);
        if (!result) throw std::runtime_error(name + ": " + result.error().message);
        if (c.lines.empty()) c.lines = newVisibleLines(target_, result->solid, camera_);
        c.told = c.lines.size() >= least;
        c.volume = result->solid.volume();
        c.vertices = static_cast<int>(result->solid.vertices().size());
        c.edges = static_cast<int>(result->solid.edges().size());
        c.faces = static_cast<int>(result->solid.faces().size());
        all_.push_back(std::move(c));
    }
    std::vector<ModificationCase> take() { return std::move(all_); }

  private:
    std::string scene_;
    int view_;
    Body target_;
    OrthographicCamera camera_;
    std::vector<ModificationCase> all_;
};

/// A solid changed by one tool after the other; throws std::runtime_error where one fails.
struct Step {
    BooleanKind kind;
    PolyhedronSpec tool;
};
inline Solid changed(Solid solid, const std::vector<Step>& steps) {
    for (const Step& s : steps) {
        auto next = combine(solid, solidOf(s.tool), s.kind);
        if (!next) throw std::runtime_error(next.error().message);
        solid = std::move(next->solid);
    }
    return solid;
}

}  // namespace ew::test
