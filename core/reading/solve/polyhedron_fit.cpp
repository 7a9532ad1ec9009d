// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/polyhedron_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Mat3 rotationBy(const Vec3& w) {
    const double angle = w.norm();
    if (angle < 1e-15) return Mat3::Identity();
    return Eigen::AngleAxisd(angle, w / angle).toRotationMatrix();
}

/// A model's numbers as one vector, and its vertices for any such vector.
class Parameters {
  public:
    explicit Parameters(const PlaneModel& model) : model_(model) {
        for (std::size_t i = 0; i < model.normals.size(); ++i) {
            if (model.normals[i].kind == PlaneModel::Normal::Kind::Free) free_.push_back(i);
        }
    }

    Eigen::Index count() const {
        return static_cast<Eigen::Index>(kPose + model_.angles.size() + model_.offsets.size() +
                                         2 * free_.size());
    }

    PlaneModel moved(const Eigen::VectorXd& by) const {
        PlaneModel m = model_;
        m.bodyToCamera = rotationBy(by.head<3>()) * model_.bodyToCamera;
        m.center.head<2>() += by.segment<2>(3) * kPxPerStep;
        Eigen::Index k = kPose;
        for (double& a : m.angles) a += by[k++];
        for (double& o : m.offsets) o += by[k++] * kPxPerStep;
        for (const std::size_t i : free_) {
            PlaneModel::Normal& n = m.normals[i];
            const Vec3 u = n.first.unitOrthogonal();
            n.first = (n.first + by[k] * u + by[k + 1] * n.first.cross(u)).normalized();
            k += 2;
        }
        return m;
    }

    /// Angles are steps of a radian; so that all steps weigh much the same, lengths are in this.
    static constexpr double kPxPerStep = 100.0;

  private:
    static constexpr int kPose = 5;
    const PlaneModel& model_;
    std::vector<std::size_t> free_;
};

/// Axis that a normal is, with its sign; -1 where it is none.
int axisOf(const Vec3& n) {
    for (int k = 0; k < 3; ++k) {
        if (std::abs(n[k]) == 1.0) return k;
    }
    return -1;
}

/// Planes whose normals span less than this volume do not meet in a point that anybody could tell.
constexpr double kFlat = 1e-9;

/// Where the planes of a vertex meet, in the body's frame. Coordinates along axes that planes are
/// perpendicular to are those planes' offsets, to the bit.
std::optional<Vec3> meet(const std::vector<Vec3>& normals, const std::vector<double>& offsets,
                         const std::vector<int>& faces) {
    Vec3 p = Vec3::Zero();
    std::array<bool, 3> known{false, false, false};
    std::vector<int> others;
    for (const int f : faces) {
        const int axis = axisOf(normals[at(f)]);
        if (axis < 0) {
            others.push_back(f);
        } else if (!known[at(axis)]) {
            known[at(axis)] = true;
            p[axis] = offsets[at(f)] * normals[at(f)][axis];
        }
    }
    if (known[0] && known[1] && known[2]) return p;
    // Rows of the planes for the coordinates that are still open; the others stay as they are.
    Mat3 a = Mat3::Zero();
    Vec3 b = Vec3::Zero();
    int rows = 0;
    for (int k = 0; k < 3; ++k) {
        if (!known[at(k)]) continue;
        a(rows, k) = 1.0;
        b[rows++] = p[k];
    }
    const bool determined = rows + static_cast<int>(others.size()) == 3;
    if (rows + static_cast<int>(others.size()) < 3) return std::nullopt;
    if (determined) {
        for (const int f : others) {
            a.row(rows) = normals[at(f)].transpose();
            b[rows++] = offsets[at(f)];
        }
    } else {
        // More planes than coordinates: least squares among them.
        const Mat3 fixed = a.transpose() * a;
        a = Mat3::Zero();
        Vec3 right = Vec3::Zero();
        for (const int f : others) {
            Vec3 n = normals[at(f)];
            double rest = offsets[at(f)];
            for (int k = 0; k < 3; ++k) {
                if (fixed(k, k) == 0.0) continue;
                rest -= n[k] * p[k];
                n[k] = 0.0;
            }
            a += n * n.transpose();
            right += rest * n;
        }
        a += fixed;
        b = right + fixed * p;
    }
    if (std::abs(a.determinant()) < kFlat) return std::nullopt;
    const Vec3 x = a.inverse() * b;
    for (int k = 0; k < 3; ++k) {
        if (!known[at(k)]) p[k] = x[k];
    }
    return p;
}

struct Shape {
    std::vector<Vec3> body, camera;
    double gap = 0.0;
    bool ok = true;
};

Shape shapeOf(const PlaneModel& m) {
    Shape out;
    std::vector<Vec3> normals;
    std::vector<double> offsets;
    for (const PlaneModel::Face& f : m.faces) {
        normals.push_back(m.direction(m.normals[at(f.normal)]));
        offsets.push_back(m.offsets[at(f.offset)]);
    }
    for (const std::vector<int>& faces : m.vertexFaces) {
        const auto p = meet(normals, offsets, faces);
        if (!p || !p->allFinite()) {
            out.ok = false;
            return out;
        }
        for (const int f : faces) {
            out.gap = std::max(out.gap, std::abs(normals[at(f)].dot(*p) - offsets[at(f)]));
        }
        out.body.push_back(*p);
        out.camera.push_back(m.center + m.bodyToCamera * *p);
    }
    return out;
}

/// Numbers of the drawing, each over its spread, against a shape.
class Residuals {
  public:
    Residuals(const std::vector<DrawnVertex>& vertices, const std::vector<DrawnStretch>& stretches)
        : vertices_(vertices), stretches_(stretches) {}

    /// Drawn numbers first, then how far vertices are from their planes.
    std::optional<Eigen::VectorXd> of(const PlaneModel& m) const {
        const Shape shape = shapeOf(m);
        if (!shape.ok) return std::nullopt;
        std::vector<double> r;
        for (std::size_t i = 0; i < vertices_.size(); ++i) {
            const Vec2 off = (shape.camera[at(vertices_[i].vertex)].head<2>() - vertices_[i].at) /
                             vertices_[i].spreadPx;
            r.push_back(off.x());
            r.push_back(off.y());
        }
        for (const DrawnStretch& s : stretches_) {
            const Vec2 a = shape.camera[at(s.vertices[0])].head<2>();
            const Vec2 d = shape.camera[at(s.vertices[1])].head<2>() - a;
            r.push_back(cross2(d, s.at - a) / std::max(d.norm(), 1e-6) / s.spreadPx);
        }
        for (std::size_t v = 0; v < m.vertexFaces.size(); ++v) {
            if (m.vertexFaces[v].size() < 4) continue;
            for (const int f : m.vertexFaces[v]) {
                const PlaneModel::Face& face = m.faces[at(f)];
                r.push_back(kPlanar * (m.direction(m.normals[at(face.normal)]).dot(shape.body[v]) -
                                       m.offsets[at(face.offset)]));
            }
        }
        return Eigen::Map<Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size()));
    }

    Eigen::Index drawn() const {
        return static_cast<Eigen::Index>(2 * vertices_.size() + stretches_.size());
    }

  private:
    static constexpr double kPlanar = 1e3;  ///< planes hold; drawn places do what they can
    const std::vector<DrawnVertex>& vertices_;
    const std::vector<DrawnStretch>& stretches_;
};

/// One step: the linear problem, damped until it helps.
/// \return false where nothing helps any more.
bool improve(PlaneModel& model, Eigen::VectorXd& r, double& damping, const Residuals& residuals) {
    const Parameters parameters(model);
    const Eigen::Index n = parameters.count();
    Eigen::MatrixXd jacobian(r.size(), n);
    constexpr double kStep = 1e-6;
    for (Eigen::Index k = 0; k < n; ++k) {
        Eigen::VectorXd by = Eigen::VectorXd::Zero(n);
        by[k] = kStep;
        const auto ahead = residuals.of(parameters.moved(by));
        by[k] = -kStep;
        const auto behind = residuals.of(parameters.moved(by));
        if (!ahead || !behind) return false;
        jacobian.col(k) = (*ahead - *behind) / (2.0 * kStep);
    }
    const Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
    const Eigen::VectorXd gradient = jacobian.transpose() * r;
    for (int tries = 0; tries < 12; ++tries, damping *= 4.0) {
        Eigen::MatrixXd damped = normal;
        damped.diagonal().array() += damping * (normal.diagonal().array() + 1e-6);
        const Eigen::VectorXd by = -damped.ldlt().solve(gradient);
        if (!by.allFinite() || by.norm() > 20.0) continue;
        PlaneModel next = parameters.moved(by);
        const auto moved = residuals.of(next);
        if (!moved || moved->squaredNorm() >= r.squaredNorm()) continue;
        const bool more = moved->squaredNorm() < r.squaredNorm() * (1.0 - 1e-9) - 1e-18;
        model = std::move(next);
        r = *moved;
        damping = std::max(damping / 8.0, 1e-12);
        return more;
    }
    return false;
}

/// Numbers the entries that something uses, and forgets the others.
template <class T, class Uses>
void keepUsed(std::vector<T>& values, const Uses& uses) {
    std::vector<int> number(values.size(), -1);
    uses([&](int& i) {
        if (i >= 0) number[at(i)] = 0;
    });
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (number[i] < 0) continue;
        number[i] = static_cast<int>(count);
        values[count++] = values[i];
    }
    values.resize(count);
    uses([&](int& i) {
        if (i >= 0) i = number[at(i)];
    });
}

void dropUnused(PlaneModel& model) {
    keepUsed(model.normals, [&](const auto& visit) {
        for (PlaneModel::Face& f : model.faces) visit(f.normal);
    });
    keepUsed(model.offsets, [&](const auto& visit) {
        for (PlaneModel::Face& f : model.faces) visit(f.offset);
    });
    keepUsed(model.angles, [&](const auto& visit) {
        for (PlaneModel::Normal& n : model.normals) visit(n.angle);
    });
}

/// Finds the normals and offsets of a rough polyhedron's faces.
class Regular {
  public:
    Regular(const PolyhedronSpec& rough, const Mat3& frame, double angleDeg)
        : rough_(rough),
          cosine_(std::cos(angleDeg * std::numbers::pi / 180.0)),
          sine_(std::sin(angleDeg * std::numbers::pi / 180.0)) {
        out_.bodyToCamera = frame;
        for (const Vec3& v : rough.vertices) {
            out_.center += v / static_cast<double>(rough.vertices.size());
        }
    }

    PlaneModel model() {
        for (const std::vector<int>& loop : rough_.faces) addFace(loop);
        out_.vertexFaces.resize(rough_.vertices.size());
        for (std::size_t f = 0; f < rough_.faces.size(); ++f) {
            for (const int v : rough_.faces[f]) addPlane(v, static_cast<int>(f));
        }
        return std::move(out_);
    }

  private:
    void addFace(const std::vector<int>& loop) {
        Vec3 area = Vec3::Zero();
        Vec3 middle = Vec3::Zero();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec3& a = rough_.vertices[at(loop[i])];
            const Vec3& b = rough_.vertices[at(loop[(i + 1) % loop.size()])];
            area += (a - out_.center).cross(b - out_.center);
            middle += a / static_cast<double>(loop.size());
        }
        const Vec3 n = (out_.bodyToCamera.transpose() * area).normalized();
        PlaneModel::Face face;
        face.normal = normalFor(n, face.sense);
        const Vec3 exact = out_.direction(out_.normals[at(face.normal)]);
        const double offset = exact.dot(out_.bodyToCamera.transpose() * (middle - out_.center));
        face.offset = offsetFor(face.normal, offset);
        out_.faces.push_back(face);
    }

    /// Faces that lie in one plane stay in one.
    int offsetFor(int normal, double offset) {
        constexpr double kSame = 1e-7;
        for (const PlaneModel::Face& f : out_.faces) {
            const double known = out_.offsets[at(f.offset)];
            if (f.normal != normal || std::abs(known - offset) > kSame * (1.0 + std::abs(known))) {
                continue;
            }
            return f.offset;
        }
        out_.offsets.push_back(offset);
        return static_cast<int>(out_.offsets.size()) - 1;
    }

    /// A vertex lies on each plane once, however many faces of it meet there.
    void addPlane(int vertex, int face) {
        const PlaneModel::Face& f = out_.faces[at(face)];
        std::vector<int>& faces = out_.vertexFaces[at(vertex)];
        const bool known = std::any_of(faces.begin(), faces.end(), [&](int other) {
            return out_.faces[at(other)].normal == f.normal &&
                   out_.faces[at(other)].offset == f.offset;
        });
        if (!known) faces.push_back(face);
    }

    int normalFor(const Vec3& n, double& sense) {
        for (std::size_t i = 0; i < out_.normals.size(); ++i) {
            const double c = out_.direction(out_.normals[i]).dot(n);
            if (std::abs(c) < cosine_) continue;
            sense = c > 0 ? 1.0 : -1.0;
            return static_cast<int>(i);
        }
        PlaneModel::Normal normal;
        normal.first = n;
        normal.kind = PlaneModel::Normal::Kind::Free;
        for (int k = 0; k < 3; ++k) {
            if (std::abs(n[k]) < cosine_) continue;
            normal.kind = PlaneModel::Normal::Kind::Fixed;
            normal.first = Vec3::Unit(k);
            sense = n[k] > 0 ? 1.0 : -1.0;
        }
        if (normal.kind == PlaneModel::Normal::Kind::Free) turn(normal, n);
        out_.normals.push_back(normal);
        return static_cast<int>(out_.normals.size()) - 1;
    }

    /// About an axis that the normal is nearly perpendicular to; by the angle of another one where
    /// it is the same or mirrored.
    void turn(PlaneModel::Normal& normal, const Vec3& n) {
        int axis = 0;
        for (int k = 1; k < 3; ++k) {
            if (std::abs(n[k]) < std::abs(n[axis])) axis = k;
        }
        if (std::abs(n[axis]) > sine_) return;
        normal.kind = PlaneModel::Normal::Kind::Turn;
        const Vec3 u = Vec3::Unit((axis + 1) % 3);
        const Vec3 w = Vec3::Unit((axis + 2) % 3);
        for (const PlaneModel::Normal& other : out_.normals) {
            if (other.kind != PlaneModel::Normal::Kind::Turn) continue;
            if (std::abs(other.first.cross(other.second)[axis]) < 0.5) continue;
            const double a = out_.angles[at(other.angle)];
            for (const double su : {1.0, -1.0}) {
                for (const double sw : {1.0, -1.0}) {
                    const Vec3 mirrored = std::cos(a) * su * u + std::sin(a) * sw * w;
                    if (mirrored.dot(n) < cosine_) continue;
                    normal.first = su * u;
                    normal.second = sw * w;
                    normal.angle = other.angle;
                    return;
                }
            }
        }
        normal.first = u;
        normal.second = w;
        normal.angle = static_cast<int>(out_.angles.size());
        out_.angles.push_back(std::atan2(n.dot(w), n.dot(u)));
    }

    const PolyhedronSpec& rough_;
    double cosine_;  ///< of the angle within which directions are one
    double sine_;
    PlaneModel out_;
};

}  // namespace

Vec3 PlaneModel::direction(const Normal& normal) const {
    if (normal.kind != Normal::Kind::Turn) return normal.first;
    const double a = angles[at(normal.angle)];
    return std::cos(a) * normal.first + std::sin(a) * normal.second;
}

int PlaneModel::freedoms() const {
    int count = 3 + static_cast<int>(angles.size() + offsets.size());
    int fixed = 0;
    for (const Normal& n : normals) {
        count += n.kind == Normal::Kind::Free ? 2 : 0;
        fixed += n.kind == Normal::Kind::Fixed ? 1 : 0;
    }
    // Without an axis that something is fixed to, the attitude is told twice, and so is the place
    // of the center; its depth is not seen.
    if (fixed == 0) count -= angles.empty() ? 3 : 2;
    if (fixed == 1) count -= 1;
    return count - 1;
}

std::optional<PlaneFit> fitPlanes(PlaneModel model, const std::vector<DrawnVertex>& vertices,
                                  const std::vector<DrawnStretch>& stretches, int mostSteps) {
    const Residuals residuals(vertices, stretches);
    auto r = residuals.of(model);
    if (!r) return std::nullopt;
    double damping = 1e-3;
    for (int step = 0; step < mostSteps && improve(model, *r, damping, residuals); ++step) {
    }
    PlaneFit out;
    const Shape shape = shapeOf(model);
    if (!shape.ok) return std::nullopt;
    out.body = shape.body;
    out.camera = shape.camera;
    out.gapPx = shape.gap;
    out.model = std::move(model);
    const Eigen::Index drawn = residuals.drawn();
    double squares = 0.0;
    for (Eigen::Index k = 0; k < drawn; ++k) {
        const double square = (*r)[k] * (*r)[k];
        squares += square;
        out.cost += (params::kTailFreedoms + 1.0) * std::log1p(square / params::kTailFreedoms);
    }
    out.misfit = squares / static_cast<double>(std::max<Eigen::Index>(drawn, 1));
    return out;
}

void makeRegularRing(PlaneModel& model, const std::vector<int>& sides) {
    const auto n = static_cast<double>(sides.size());
    double offset = 0.0;
    double slope = 0.0;
    std::vector<Vec3> outward;
    for (const int f : sides) {
        const PlaneModel::Face& face = model.faces[at(f)];
        outward.push_back(face.sense * model.direction(model.normals[at(face.normal)]));
        offset += face.sense * model.offsets[at(face.offset)] / n;
        slope += std::asin(std::clamp(outward.back().z(), -1.0, 1.0)) / n;
    }
    // The frame turns so that the first side looks along its first axis.
    const Mat3 back = rotationBy(Vec3(0, 0, std::atan2(outward[0].y(), outward[0].x())));
    model.bodyToCamera = model.bodyToCamera * back;
    for (PlaneModel::Normal& normal : model.normals) {
        normal.first = back.transpose() * normal.first;
        normal.second = back.transpose() * normal.second;
    }
    constexpr double kUpright = 0.02;  // [rad]
    const bool tapers = std::abs(slope) > kUpright;
    model.offsets.push_back(offset);
    if (tapers) model.angles.push_back(slope);
    for (std::size_t k = 0; k < sides.size(); ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / n;
        PlaneModel::Normal normal;
        normal.first = k == 0 ? Vec3::UnitX() : Vec3(std::cos(angle), std::sin(angle), 0.0);
        if (tapers) {
            normal.kind = PlaneModel::Normal::Kind::Turn;
            normal.second = Vec3::UnitZ();
            normal.angle = static_cast<int>(model.angles.size()) - 1;
        }
        model.normals.push_back(normal);
        PlaneModel::Face& face = model.faces[at(sides[k])];
        face.normal = static_cast<int>(model.normals.size()) - 1;
        face.sense = 1.0;
        face.offset = static_cast<int>(model.offsets.size()) - 1;
    }
    dropUnused(model);
}

PlaneModel regularModel(const PolyhedronSpec& rough, const Mat3& frame, double angleDeg) {
    return Regular(rough, frame, angleDeg).model();
}

}  // namespace ew
