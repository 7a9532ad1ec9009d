// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/face_lift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Depth of a face in the picture: z = gradient . p + level.
struct Slope {
    Vec2 gradient = Vec2::Zero();
    bool known = false;
};

class Lifting {
  public:
    Lifting(const LineDrawing& drawing, const AxisFrame& frame, double spread)
        : drawing_(drawing), frame_(frame), spread_(spread) {}

    std::vector<FaceLift> run() {
        std::vector<FaceLift> out;
        if (drawing_.regions.empty()) return out;
        findOwners();
        findAxes();
        auto best = bestAxes();
        // With every line an edge of both faces, slanted ones may lie flat in the face behind them.
        if (best && isFlat(*best) && standUp()) best = bestAxes();
        if (!best) return out;
        out.push_back(*std::move(best));
        if (release(out.front())) {
            if (auto apart = lifted()) out.push_back(*std::move(apart));
        }
        return out;
    }

  private:
    /// Lines of one region, holes included.
    template <class Visit>
    void forLines(int region, const Visit& visit) const {
        const LineDrawing::Region& r = drawing_.regions[at(region)];
        for (const int d : r.loop) visit(d);
        for (const auto& hole : r.holes) {
            for (const int d : hole) visit(d);
        }
    }

    double length(int d) const { return drawing_.vector(d).norm(); }

    /// Bars of T junctions belong to what is on their other side, the outline to what is inside.
    void findOwners() {
        owner_.assign(drawing_.from.size() / 2, -1);
        for (std::size_t e = 0; e < owner_.size(); ++e) {
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            if (a < 0 || b < 0) owner_[e] = std::max(a, b);
        }
        for (const LineDrawing::Node& node : drawing_.nodes) {
            if (node.stem < 0) continue;
            const auto k = static_cast<std::size_t>(
                std::find(node.out.begin(), node.out.end(), node.stem) - node.out.begin());
            const int first = node.out[(k + 1) % 3];
            const int second = node.out[(k + 2) % 3];
            const int opposite = drawing_.left[at(first)];
            if (opposite < 0) continue;  // nothing is there that could hide
            for (const int d : {first, second}) {
                int& owner = owner_[at(d / 2)];
                if (owner < 0) owner = opposite;
            }
        }
    }

    /// Lines of what hides a face border it, too, and may point to another axis. The axes are right
    /// where most lines are edges of both their faces.
    std::optional<FaceLift> bestAxes() {
        auto best = lifted();
        for (bool better = true; better && best;) {
            better = false;
            for (std::size_t r = 0; r < choices_.size(); ++r) {
                for (const int axis : choices_[r]) {
                    const int before = axis_[r];
                    if (axis == before) continue;
                    axis_[r] = axis;
                    auto other = lifted();
                    if (other && sharedPx(*other) > sharedPx(*best) + spread_) {
                        best = std::move(other);
                        better = true;
                    } else {
                        axis_[r] = before;
                    }
                }
            }
        }
        return best;
    }

    /// Two bodies, one before the other, may look joined along one line of two faces. Where that is
    /// all that holds two groups of faces together, the line becomes an edge of the group that
    /// reaches farther down in the picture: it stands nearer to the eye.
    /// \return whether there is such a place.
    bool release(const FaceLift& lift) {
        bool any = false;
        for (std::size_t e = 0; e < owner_.size(); ++e) {
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            if (!lift.lines[e].shared) continue;
            const std::vector<int> mine = reached(lift, a, b);
            if (std::find(mine.begin(), mine.end(), b) != mine.end()) continue;
            const std::vector<int> theirs = reached(lift, b, a);
            if (mine.size() < 2 || theirs.size() < 2) continue;
            owner_[e] = lowest(mine) > lowest(theirs) ? a : b;
            any = true;
        }
        return any;
    }

    /// The faces that shared lines join to one, without those between two faces.
    std::vector<int> reached(const FaceLift& lift, int from, int without) const {
        std::vector<int> out{from};
        for (std::size_t i = 0; i < out.size(); ++i) {
            for (std::size_t e = 0; e < owner_.size(); ++e) {
                if (!lift.lines[e].shared) continue;
                int a = drawing_.left[2 * e];
                int b = drawing_.left[2 * e + 1];
                if (a != out[i]) std::swap(a, b);
                if (a != out[i] || (a == from && b == without)) continue;
                if (std::find(out.begin(), out.end(), b) == out.end()) out.push_back(b);
            }
        }
        return out;
    }

    /// How far faces reach down in the picture [px].
    double lowest(const std::vector<int>& regions) const {
        double y = -std::numeric_limits<double>::infinity();
        for (const int r : regions) {
            for (const int d : drawing_.regions[at(r)].loop) {
                y = std::max(y, drawing_.nodes[at(drawing_.from[at(d)])].at.y());
            }
        }
        return y;
    }

    /// Does some slanted face lie in the plane of a neighbour?
    bool isFlat(const FaceLift& lift) const {
        constexpr double kFlatCosine = 0.9998;  // 1 degree
        for (std::size_t e = 0; e < owner_.size(); ++e) {
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            if (a < 0 || b < 0 || a == b || (axis_[at(a)] >= 0 && axis_[at(b)] >= 0)) continue;
            if (lift.faces[at(a)].normal.dot(lift.faces[at(b)].normal) > kFlatCosine) return true;
        }
        return false;
    }

    /// Slanted lines between a slanted face and one across an axis are edges of the first alone.
    /// \return whether there are any.
    bool standUp() {
        bool any = false;
        for (std::size_t e = 0; e < owner_.size(); ++e) {
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            if (a < 0 || b < 0 || owner_[e] >= 0 || frame_.axisOf[e] >= 0) continue;
            if ((axis_[at(a)] < 0) == (axis_[at(b)] < 0)) continue;
            owner_[e] = axis_[at(a)] < 0 ? a : b;
            any = true;
        }
        return any;
    }

    std::optional<FaceLift> lifted() {
        findSlopes();
        number();
        if (!solve()) return std::nullopt;
        return result();
    }

    double sharedPx(const FaceLift& lift) const {
        double sum = 0.0;
        for (std::size_t e = 0; e < lift.lines.size(); ++e) {
            if (lift.lines[e].shared) sum += length(static_cast<int>(2 * e));
        }
        return sum;
    }

    /// Which axis a face is across: the one that its own lines do not run along, and others where
    /// lines run along all three.
    void findAxes() {
        axis_.assign(drawing_.regions.size(), -1);
        choices_.assign(drawing_.regions.size(), {});
        for (std::size_t r = 0; r < axis_.size(); ++r) {
            const int region = static_cast<int>(r);
            std::array<double, 3> along{0.0, 0.0, 0.0};
            forLines(region, [&](int d) {
                const int axis = frame_.axisOf[at(d / 2)];
                const int owner = owner_[at(d / 2)];
                if (axis < 0 || (owner >= 0 && owner != region)) return;
                along[at(axis)] += length(d) * (owner == region ? 3.0 : 1.0);
            });
            const auto least =
                static_cast<int>(std::min_element(along.begin(), along.end()) - along.begin());
            const int present = static_cast<int>(std::count_if(
                along.begin(), along.end(), [](double length) { return length > 0.0; }));
            if (present < 2) continue;
            axis_[r] = least;
            if (present == 3) choices_[r] = {0, 1, 2};
        }
    }

    void findSlopes() {
        slopes_.assign(drawing_.regions.size(), {});
        for (std::size_t r = 0; r < slopes_.size(); ++r) {
            if (axis_[r] < 0) continue;
            const Vec3 n = frame_.axes.col(axis_[r]);
            constexpr double kEdgeOn = 0.02;
            if (std::abs(n.z()) < kEdgeOn) continue;
            slopes_[r].gradient = -n.head<2>() / n.z();
            slopes_[r].known = true;
        }
    }

    /// Unknowns: a level for each region, two more where its slope is not known.
    void number() {
        start_.clear();
        unknowns_ = 0;
        for (const Slope& s : slopes_) {
            start_.push_back(unknowns_);
            unknowns_ += s.known ? 1 : 3;
        }
    }

    /// A row: factor * depth of a region at a point, added; the right side takes what is known.
    struct Row {
        std::vector<std::pair<int, double>> terms;
        double right = 0.0;
        double weight = 1.0;
    };

    void addDepth(Row& row, int region, const Vec2& p, double factor) const {
        const int k = start_[at(region)];
        const Vec2 q = p - middle_;
        row.terms.emplace_back(k, factor);
        if (slopes_[at(region)].known) {
            row.right -= factor * slopes_[at(region)].gradient.dot(q);
        } else {
            row.terms.emplace_back(k + 1, factor * q.x() / kGradientPx);
            row.terms.emplace_back(k + 2, factor * q.y() / kGradientPx);
        }
    }

    std::vector<Row> rows() const {
        std::vector<Row> out;
        for (std::size_t e = 0; e < owner_.size(); ++e) {
            const int d = static_cast<int>(2 * e);
            const int a = drawing_.left[2 * e];
            const int b = drawing_.left[2 * e + 1];
            const Vec2 p = drawing_.nodes[at(drawing_.from[at(d)])].at;
            const Vec2 q = drawing_.nodes[at(drawing_.to(d))].at;
            if (a >= 0 && b >= 0 && a != b && owner_[e] < 0 && mayMeet(a, b)) {
                for (const Vec2& end : {p, q}) {
                    Row row;
                    addDepth(row, a, end, 1.0);
                    addDepth(row, b, end, -1.0);
                    out.push_back(std::move(row));
                }
            }
            const int axis = frame_.axisOf[e];
            if (axis < 0) continue;
            addMirrorRow(d, a, out);
            addMirrorRow(LineDrawing::twin(d), b, out);
            const Vec3 n = frame_.axes.col(axis);
            const double rise = n.z() / n.head<2>().squaredNorm() * n.head<2>().dot(q - p);
            for (const int region : {a, b}) {
                if (region < 0 || slopes_[at(region)].known) continue;
                if (owner_[e] >= 0 && owner_[e] != region) continue;
                Row row;
                addDepth(row, region, q, 1.0);
                addDepth(row, region, p, -1.0);
                row.right += rise;
                out.push_back(std::move(row));
            }
        }
        return out;
    }

    /// What nothing else tells: a slanted triangle has two equal sides, and a slanted face of four
    /// corners with two edges along an axis looks the same in a mirror across that axis.
    void addMirrorRow(int d, int region, std::vector<Row>& out) const {
        if (region < 0 || slopes_[at(region)].known) return;
        const LineDrawing::Region& r = drawing_.regions[at(region)];
        const std::size_t n = r.corners.size();
        const bool whole = !r.partly && r.loop.size() == n && r.holes.empty();
        if (!whole || n < 3 || n > 4) return;
        const auto k =
            static_cast<std::size_t>(std::find(r.loop.begin(), r.loop.end(), d) - r.loop.begin());
        if (k == n) return;
        const int across = r.loop[(k + 2) % n];
        const int axis = frame_.axisOf[at(d / 2)];
        if (n == 4 && frame_.axisOf[at(across / 2)] != axis) return;
        const auto node = [&](int v) { return drawing_.nodes[at(v)].at; };
        const Vec2 base = 0.5 * (node(drawing_.from[at(d)]) + node(drawing_.to(d)));
        const Vec2 top =
            n == 3 ? node(drawing_.from[at(across)])
                   : Vec2(0.5 * (node(drawing_.from[at(across)]) + node(drawing_.to(across))));
        // (top - base) . axis = 0, its depth the only unknown.
        const Vec3 along = frame_.axes.col(axis);
        constexpr double kEdgeOn = 0.1;
        if (std::abs(along.z()) < kEdgeOn) return;
        Row row;
        addDepth(row, region, top, 1.0);
        addDepth(row, region, base, -1.0);
        row.right -= along.head<2>().dot(top - base) / along.z();
        row.weight = kWeakRow;
        out.push_back(std::move(row));
    }

    /// Two faces across one axis have no edge in common.
    bool mayMeet(int a, int b) const {
        return !slopes_[at(a)].known || !slopes_[at(b)].known || axis_[at(a)] != axis_[at(b)];
    }

    /// Least absolute deviations by least squares with weights.
    bool solve() {
        middle_ = Vec2::Zero();
        for (const LineDrawing::Node& n : drawing_.nodes) {
            middle_ += n.at / static_cast<double>(drawing_.nodes.size());
        }
        const std::vector<Row> all = rows();
        std::vector<double> weights;
        for (const Row& row : all) weights.push_back(row.weight);
        Eigen::VectorXd x;
        constexpr int kRounds = 12;
        for (int round = 0; round < kRounds; ++round) {
            Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns_, unknowns_);
            Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns_);
            for (std::size_t i = 0; i < all.size(); ++i) {
                for (const auto& [k, f] : all[i].terms) {
                    right[k] += weights[i] * f * all[i].right;
                    for (const auto& [l, g] : all[i].terms) normal(k, l) += weights[i] * f * g;
                }
            }
            // What nothing tells stays level and in the picture plane.
            constexpr double kTold = 1e-9;
            normal.diagonal().array() += kTold * std::max(1.0, normal.diagonal().maxCoeff());
            x = normal.ldlt().solve(right);
            if (!x.allFinite()) return false;
            for (std::size_t i = 0; i < all.size(); ++i) {
                double off = -all[i].right;
                for (const auto& [k, f] : all[i].terms) off += f * x[k];
                weights[i] = all[i].weight * spread_ / std::max(std::abs(off), 0.1 * spread_);
            }
        }
        levels_.clear();
        for (std::size_t r = 0; r < slopes_.size(); ++r) {
            const int k = start_[r];
            if (!slopes_[r].known) {
                slopes_[r].gradient = Vec2(x[k + 1], x[k + 2]) / kGradientPx;
            }
            levels_.push_back(x[k] - slopes_[r].gradient.dot(middle_));
        }
        return true;
    }

    double depthAt(int region, const Vec2& p) const {
        return slopes_[at(region)].gradient.dot(p) + levels_[at(region)];
    }

    FaceLift result() const {
        FaceLift out;
        out.axis = axis_;
        for (std::size_t r = 0; r < slopes_.size(); ++r) {
            const Vec2& g = slopes_[r].gradient;
            const double norm = std::sqrt(1.0 + g.squaredNorm());
            // z = g . p + level, and a face that is seen looks at the eye.
            out.faces.push_back({Vec3(g.x(), g.y(), -1.0) / norm, -levels_[r] / norm});
        }
        out.part.resize(slopes_.size());
        std::iota(out.part.begin(), out.part.end(), 0);
        for (std::size_t e = 0; e < owner_.size(); ++e) out.lines.push_back(line(e, out));
        // Numbers from 0 in the order of the regions.
        const std::vector<int> parent = out.part;
        std::vector<int> number(slopes_.size(), -1);
        for (std::size_t r = 0; r < parent.size(); ++r) {
            int root = static_cast<int>(r);
            while (parent[at(root)] != root) root = parent[at(root)];
            if (number[at(root)] < 0) number[at(root)] = out.parts++;
            out.part[r] = number[at(root)];
        }
        return out;
    }

    LiftedLine line(std::size_t e, FaceLift& out) const {
        LiftedLine line;
        line.front = owner_[e];
        const int a = drawing_.left[2 * e];
        const int b = drawing_.left[2 * e + 1];
        if (line.front >= 0 || a < 0 || b < 0 || a == b) return line;
        const Vec2 p = drawing_.nodes[at(drawing_.from[2 * e])].at;
        const Vec2 q = drawing_.nodes[at(drawing_.from[2 * e + 1])].at;
        const double across = (slopes_[at(a)].gradient - slopes_[at(b)].gradient).norm();
        constexpr double kLeastAcross = 0.05;
        const double off = std::max(std::abs(depthAt(a, p) - depthAt(b, p)),
                                    std::abs(depthAt(a, q) - depthAt(b, q)));
        constexpr double kMostOff = 5.0;  // standard deviations
        if (across > kLeastAcross && mayMeet(a, b) && off / across < kMostOff * spread_) {
            line.shared = true;
            out.worstPx = std::max(out.worstPx, off / across);
            int from = a;
            while (out.part[at(from)] != from) from = out.part[at(from)];
            int to = b;
            while (out.part[at(to)] != to) to = out.part[at(to)];
            out.part[at(std::max(from, to))] = std::min(from, to);
        }
        const Vec2 middle = 0.5 * (p + q);
        line.front = depthAt(a, middle) < depthAt(b, middle) ? a : b;
        return line;
    }

    static constexpr double kWeakRow = 1e-4;      ///< of what is taken where nothing else tells
    static constexpr double kGradientPx = 100.0;  ///< so that unknowns weigh much the same

    const LineDrawing& drawing_;
    const AxisFrame& frame_;
    double spread_;
    std::vector<int> owner_;  ///< per edge: region that certainly has it alone, -1 if not known
    std::vector<Slope> slopes_;
    std::vector<int> axis_;
    std::vector<std::vector<int>> choices_;  ///< per region: axes that it may be across
    std::vector<int> start_;
    int unknowns_ = 0;
    Vec2 middle_ = Vec2::Zero();
    std::vector<double> levels_;
};

}  // namespace

std::vector<FaceLift> liftFaces(const LineDrawing& drawing, const AxisFrame& frame,
                                double spreadPx) {
    return Lifting(drawing, frame, spreadPx).run();
}

}  // namespace ew
