// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/ink_frames.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Directions that lines of the ink share, those with most ink first, at most five.
std::vector<Vec2> inkDirections(const InkReading& ink) {
    constexpr double kSameSine = 0.2;  // 12 degrees
    constexpr std::size_t kMost = 5;
    std::vector<std::pair<double, Vec2>> families;
    std::vector<const Segment*> order;
    for (const Segment& s : ink.segments) order.push_back(&s);
    std::stable_sort(order.begin(), order.end(), [](const Segment* a, const Segment* b) {
        return (a->b - a->a).norm() > (b->b - b->a).norm();
    });
    for (const Segment* s : order) {
        Vec2 d = s->b - s->a;
        const double length = d.norm();
        if (length < 1e-9) continue;
        const auto known = std::find_if(families.begin(), families.end(), [&](const auto& f) {
            return std::abs(cross2(f.second.normalized(), d)) < kSameSine * length;
        });
        if (known == families.end()) {
            families.emplace_back(length, d);
        } else {
            known->first += length;
            known->second += known->second.dot(d) < 0 ? Vec2(-d) : d;
        }
    }
    std::stable_sort(families.begin(), families.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    if (families.size() > kMost) families.resize(kMost);
    std::vector<Vec2> out;
    for (const auto& f : families) out.push_back(f.second.normalized());
    return out;
}

}  // namespace

std::vector<InkFrame> inkFrames(const InkReading& ink, const std::vector<Vec2>& hull) {
    std::vector<InkFrame> out;
    const std::vector<Vec2> d = inkDirections(ink);
    const auto add = [&](const std::array<Vec2, 3>& u) {
        Mat3 widths = Mat3::Zero();
        Vec3 wanted;
        Eigen::Matrix<double, 3, 2> normals;
        Vec3 middle;
        for (int i = 0; i < 3; ++i) {
            const Vec2 n(-u[at(i)].y(), u[at(i)].x());
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            for (const Vec2& p : hull) {
                low = std::min(low, n.dot(p));
                high = std::max(high, n.dot(p));
            }
            wanted(i) = high - low;
            middle(i) = 0.5 * (high + low);
            normals.row(i) = n.transpose();
            for (int j = 0; j < 3; ++j) widths(i, j) = i == j ? 0.0 : std::abs(n.dot(u[at(j)]));
        }
        const Vec3 lengths = widths.fullPivLu().solve(wanted);
        const double size = wanted.maxCoeff();
        if (!lengths.allFinite() || lengths.minCoeff() < 0.02 * size) return;
        InkFrame frame;
        frame.center = normals.colPivHouseholderQr().solve(middle);
        frame.sizePx = size;
        for (int i = 0; i < 3; ++i) frame.axes[at(i)] = lengths(i) * u[at(i)];
        out.push_back(frame);
    };
    for (std::size_t i = 0; i < d.size(); ++i) {
        for (std::size_t j = i + 1; j < d.size(); ++j) {
            for (std::size_t k = j + 1; k < d.size(); ++k) add({d[i], d[j], d[k]});
        }
    }
    return out;
}

}  // namespace ew
