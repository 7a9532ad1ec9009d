// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/closing_planes.h"

#include <algorithm>
#include <cmath>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Directions that differ by less are one; a direction so nearly across another one is so.
constexpr double kSameCosine = 0.9976;  // 4 degrees
constexpr double kAcrossSine = 0.0698;

class Planes {
  public:
    Planes(const LineDrawing& drawing, const AxisFrame& frame, const FaceLift& lift, double spread)
        : drawing_(drawing), frame_(frame), lift_(lift), spread_(spread) {
        for (int k = 0; k < 3; ++k) out_.directions.emplace_back(frame.axes.col(k));
    }

    SolidPlanes run() {
        for (std::size_t r = 0; r < drawing_.regions.size(); ++r) addSeen(static_cast<int>(r));
        const std::size_t seen = out_.directions.size();
        for (std::size_t i = 3; i < seen; ++i) {
            for (int k = 0; k < 3; ++k) {
                const Vec3 axis = frame_.axes.col(k);
                const Vec3& n = out_.directions[i];
                direction(n - 2.0 * n.dot(axis) * axis);
            }
        }
        for (std::size_t e = 0; e < lift_.lines.size(); ++e) {
            const LiftedLine& line = lift_.lines[e];
            if (!line.shared && line.front >= 0) addBehind(e, line.front);
        }
        return std::move(out_);
    }

  private:
    int direction(const Vec3& n) {
        for (std::size_t i = 0; i < out_.directions.size(); ++i) {
            if (std::abs(out_.directions[i].dot(n)) > kSameCosine) return static_cast<int>(i);
        }
        out_.directions.push_back(n.normalized());
        return static_cast<int>(out_.directions.size()) - 1;
    }

    void addSeen(int region) {
        const DrawnPlane& face = lift_.faces[at(region)];
        SolidPlane plane;
        plane.region = region;
        plane.part = lift_.part[at(region)];
        plane.direction =
            lift_.axis[at(region)] >= 0 ? lift_.axis[at(region)] : direction(face.normal);
        // Through the middle of what is seen of it.
        Vec2 middle = Vec2::Zero();
        const auto& loop = drawing_.regions[at(region)].loop;
        for (const int d : loop) {
            middle +=
                drawing_.nodes[at(drawing_.from[at(d)])].at / static_cast<double>(loop.size());
        }
        const Vec3 n = out_.directions[at(plane.direction)];
        plane.offset = n.dot(Vec3(middle.x(), middle.y(), face.depthAt(middle)));
        plane.away = n.z() > 0.0;
        plane.weightPx = std::sqrt(drawing_.regions[at(region)].areaPx);
        out_.planes.push_back(plane);
    }

    /// Direction of a directed edge on a face.
    Vec3 inSpace(int d, int region) const {
        const int axis = frame_.axisOf[at(d / 2)];
        if (axis >= 0) return frame_.axes.col(axis);
        const DrawnPlane& face = lift_.faces[at(region)];
        const Vec2 p = drawing_.nodes[at(drawing_.from[at(d)])].at;
        const Vec2 q = drawing_.nodes[at(drawing_.to(d))].at;
        return Vec3(q.x() - p.x(), q.y() - p.y(), face.depthAt(q) - face.depthAt(p)).normalized();
    }

    void addBehind(std::size_t e, int region) {
        const DrawnPlane& face = lift_.faces[at(region)];
        // Directed so that the face is on its right in the picture.
        const int d = static_cast<int>(2 * e) + (drawing_.left[2 * e] == region ? 0 : 1);
        const Vec2 p = drawing_.nodes[at(drawing_.from[at(d)])].at;
        const Vec2 q = drawing_.nodes[at(drawing_.to(d))].at;
        const Vec3 from(p.x(), p.y(), face.depthAt(p));
        const Vec3 to(q.x(), q.y(), face.depthAt(q));
        const int axis = frame_.axisOf[e];
        Vec3 along = (to - from).normalized();
        if (axis >= 0) {
            const Vec3 exact = frame_.axes.col(axis);
            along = exact.dot(along) < 0.0 ? Vec3(-exact) : exact;
        }
        // In the face, away from the edge: right of it in the picture, where y is down.
        Vec3 inside = face.normal.cross(along);
        const Vec2 right(-(q - p).y(), (q - p).x());
        if (inside.head<2>().dot(right) < 0.0) inside = -inside;
        std::vector<int> directions;
        const std::size_t known = out_.directions.size();
        for (std::size_t i = 0; i < known; ++i) {
            if (std::abs(out_.directions[i].dot(along)) < kAcrossSine) {
                directions.push_back(static_cast<int>(i));
            }
        }
        const auto addAcross = [&](const Vec3& other) {
            const Vec3 n = along.cross(other);
            constexpr double kTold = 0.1;
            if (n.norm() < kTold) return;
            const int id = direction(n.normalized());
            const bool isNew =
                std::find(directions.begin(), directions.end(), id) == directions.end();
            if (isNew) directions.push_back(id);
        };
        for (int k = 0; axis < 0 && k < 3; ++k) addAcross(frame_.axes.col(k));
        // Where three edges meet and one of them is shared by the two faces that are seen, the
        // hidden face has the other two.
        for (const int end : {LineDrawing::twin(d), d}) {
            const auto& out = drawing_.nodes[at(drawing_.from[at(end)])].out;
            if (out.size() != 3) continue;
            for (const int o : out) {
                const LiftedLine& other = lift_.lines[at(o / 2)];
                if (o == end || other.shared || other.front < 0 || other.front == region) continue;
                const bool joined = std::any_of(out.begin(), out.end(), [&](int s) {
                    return s != end && s != o && lift_.lines[at(s / 2)].shared;
                });
                if (joined) addAcross(inSpace(o, other.front));
            }
        }
        for (const int id : directions) {
            const Vec3 n = out_.directions[at(id)];
            if (std::abs(n.dot(face.normal)) > kSameCosine || std::abs(n.z()) < 0.02) continue;
            const double sense = n.z() > 0.0 ? 1.0 : -1.0;  // outwards, away from the eye
            if (sense * n.dot(inside) > -0.05) continue;
            SolidPlane plane;
            plane.part = lift_.part[at(region)];
            plane.direction = id;
            plane.offset = 0.5 * (n.dot(from) + n.dot(to));
            plane.away = sense < 0.0;
            plane.weightPx = (q - p).norm();
            const bool same =
                std::any_of(out_.planes.begin(), out_.planes.end(), [&](const SolidPlane& other) {
                    return other.region < 0 && other.direction == id && other.part == plane.part &&
                           std::abs(other.offset - plane.offset) < 1e-9 * spread_;
                });
            if (!same) out_.planes.push_back(plane);
        }
    }

    const LineDrawing& drawing_;
    const AxisFrame& frame_;
    const FaceLift& lift_;
    double spread_;
    SolidPlanes out_;
};

}  // namespace

SolidPlanes solidPlanes(const LineDrawing& drawing, const AxisFrame& frame, const FaceLift& lift,
                        double spreadPx) {
    return Planes(drawing, frame, lift, spreadPx).run();
}

}  // namespace ew
