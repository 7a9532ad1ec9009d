// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/part_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A depth of one part, and how many planes that makes common.
struct Depth {
    double shift = 0.0;
    double gain = 0.0;
};

class Depths {
  public:
    Depths(const LineDrawing& drawing, const FaceLift& lift, const SolidPlanes& planes,
           double spread)
        : drawing_(drawing), lift_(lift), planes_(planes), spread_(spread) {}

    std::vector<PartDepths> run() {
        std::vector<double> area(at(lift_.parts), 0.0);
        for (std::size_t r = 0; r < drawing_.regions.size(); ++r) {
            area[at(lift_.part[r])] += drawing_.regions[r].areaPx;
        }
        std::vector<int> order(at(lift_.parts));
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
        std::stable_sort(order.begin(), order.end(),
                         [&](int a, int b) { return area[at(a)] > area[at(b)]; });
        shifts_.assign(at(lift_.parts), 0.0);
        placed_.assign(at(lift_.parts), false);
        placed_[at(order.front())] = true;
        struct Other {
            int part;
            double shift, less;
        };
        std::vector<Other> others;
        for (std::size_t i = 1; i < order.size(); ++i) {
            const std::vector<Depth> found = depthsOf(order[i]);
            for (std::size_t k = 1; k < found.size() && others.size() < kMostOthers; ++k) {
                others.push_back({order[i], found[k].shift, found.front().gain - found[k].gain});
            }
            if (!found.empty()) shifts_[at(order[i])] = found.front().shift;
            placed_[at(order[i])] = true;
        }
        std::vector<PartDepths> out{{shifts_, 0.0}};
        for (const Other& other : others) {
            out.push_back({shifts_, other.less});
            out.back().shifts[at(other.part)] = other.shift;
        }
        return out;
    }

  private:
    static constexpr std::size_t kMostOthers = 3;

    std::vector<Depth> depthsOf(int part) const {
        double low = -std::numeric_limits<double>::infinity();
        double high = -low;
        limits(part, low, high);
        std::vector<Depth> out;
        for (const SolidPlane& mine : planes_.planes) {
            if (mine.part != part) continue;
            const double z = planes_.directions[at(mine.direction)].z();
            constexpr double kEdgeOn = 0.05;
            if (std::abs(z) < kEdgeOn) continue;
            for (const SolidPlane& other : planes_.planes) {
                if (!placed_[at(other.part)] || other.direction != mine.direction) continue;
                const double shift = (other.offset + shifts_[at(other.part)] * z - mine.offset) / z;
                if (shift < low || shift > high) continue;
                out.push_back({shift, gain(part, shift)});
            }
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const Depth& a, const Depth& b) { return a.gain > b.gain; });
        std::vector<Depth> kept;
        for (const Depth& d : out) {
            const bool known = std::any_of(kept.begin(), kept.end(), [&](const Depth& k) {
                return std::abs(k.shift - d.shift) < 4.0 * spread_;
            });
            if (!known) kept.push_back(d);
            if (kept.size() == 3) break;
        }
        return kept;
    }

    /// What hides is nearer than what it hides.
    void limits(int part, double& low, double& high) const {
        for (std::size_t e = 0; e < lift_.lines.size(); ++e) {
            const LiftedLine& line = lift_.lines[e];
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            if (line.shared || a < 0 || b < 0 || line.front < 0) continue;
            const int back = line.front == a ? b : a;
            const int front = line.front;
            const int fp = lift_.part[at(front)];
            const int bp = lift_.part[at(back)];
            if (fp == bp || (fp != part && bp != part)) continue;
            if (!placed_[at(fp == part ? bp : fp)]) continue;
            const Vec2 p = 0.5 * (drawing_.nodes[at(drawing_.from[2 * e])].at +
                                  drawing_.nodes[at(drawing_.from[2 * e + 1])].at);
            // Depth of the one that is placed, and of the part without its shift.
            const double zf = lift_.faces[at(front)].depthAt(p);
            const double zb = lift_.faces[at(back)].depthAt(p);
            const double slack = 6.0 * spread_;
            if (fp == part) {
                high = std::min(high, zb + shifts_[at(bp)] - zf + slack);
            } else {
                low = std::max(low, zf + shifts_[at(fp)] - zb - slack);
            }
        }
    }

    /// The plane that a part stands on: the lowest one behind that looks down; nullptr where none
    /// is told.
    const SolidPlane* ground(int part) const {
        int upright = 0;
        for (int k = 1; k < 3; ++k) {
            const auto rise = [&](int axis) { return std::abs(planes_.directions[at(axis)].y()); };
            if (rise(k) > rise(upright)) upright = k;
        }
        const SolidPlane* lowest = nullptr;
        const double down = planes_.directions[at(upright)].y() > 0.0 ? 1.0 : -1.0;  // y is down
        for (const SolidPlane& p : planes_.planes) {
            const bool looksDown = p.away == (down < 0.0);
            if (p.part != part || p.region >= 0 || p.direction != upright || !looksDown) continue;
            if (lowest == nullptr || down * p.offset > down * lowest->offset) lowest = &p;
        }
        return lowest;
    }

    /// Do a part and one that is placed stand on the same ground?
    bool onOneGround(int part, double shift) const {
        const SolidPlane* mine = ground(part);
        if (mine == nullptr) return false;
        const double z = planes_.directions[at(mine->direction)].z();
        for (int other = 0; other < lift_.parts; ++other) {
            if (!placed_[at(other)]) continue;
            const SolidPlane* theirs = ground(other);
            if (theirs == nullptr) continue;
            const double off = theirs->offset + shifts_[at(other)] * z - (mine->offset + shift * z);
            if (std::abs(off) < 3.0 * spread_) return true;
        }
        return false;
    }

    /// Planes that face the same way and lie together weigh more than those that touch, and a
    /// common ground more than all.
    double gain(int part, double shift) const {
        constexpr double kGround = 6.0;
        double sum = onOneGround(part, shift) ? kGround : 0.0;
        for (const SolidPlane& mine : planes_.planes) {
            if (mine.part != part) continue;
            const double z = planes_.directions[at(mine.direction)].z();
            double best = 0.0;
            for (const SolidPlane& other : planes_.planes) {
                if (!placed_[at(other.part)] || other.direction != mine.direction) continue;
                const double off =
                    other.offset + shifts_[at(other.part)] * z - (mine.offset + shift * z);
                if (std::abs(off) > 3.0 * spread_) continue;
                double value = mine.away == other.away ? 1.0 : 0.6;
                if (mine.region >= 0 && other.region >= 0) value *= 1.5;
                best = std::max(best, value);
            }
            sum += best;
        }
        return sum;
    }

    const LineDrawing& drawing_;
    const FaceLift& lift_;
    const SolidPlanes& planes_;
    double spread_;
    std::vector<double> shifts_;
    std::vector<bool> placed_;
};

}  // namespace

std::vector<PartDepths> partDepths(const LineDrawing& drawing, const FaceLift& lift,
                                   const SolidPlanes& planes, double spreadPx) {
    return Depths(drawing, lift, planes, spreadPx).run();
}

}  // namespace ew
