// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pull_controller.h"

#include <QUndoStack>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/edge_selection.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

constexpr double kSnapPx = 7.0;
constexpr double kLeastStepPx = 2.0;  // a drag goes by round numbers no finer than this

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// 1, 2 or 5 times a power of ten, at least so large.
double roundStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least) return factor * power;
    }
    return 10.0 * power;
}

}  // namespace

PullController::PullController(Document& document, ViewportWidget& viewport, QObject* parent)
    : QObject(parent), document_(document), viewport_(viewport) {
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &PullController::showPreview);
    connect(&document, &Document::changed, this, [this](DocumentChange what) {
        if (working_ || (what != DocumentChange::Bodies && what != DocumentChange::History)) return;
        // The face may be another one now.
        face_.reset();
        pulled_.reset();
        dragging_ = false;
        mark({});
        emit changed();
    });
}

void PullController::mark(const std::optional<FaceRef>& face) {
    if (face == marked_) return;
    marked_ = face;
    emit markedChanged();
}

void PullController::hover(const Vec2& px) {
    if (dragging_) return;
    const auto hit = faceUnder(document_.state().bodies, document_.camera(), px);
    mark(hit ? std::optional<FaceRef>(*hit) : face_);
}

void PullController::take(const Vec2& px) {
    const auto hit = faceUnder(document_.state().bodies, document_.camera(), px);
    face_ = hit ? std::optional<FaceRef>(*hit) : std::nullopt;
    outline_.reset();
    if (hit && !document_.pendingStrokes().empty()) {
        auto outline = document_.outlineAt(hit->world);
        if (outline && FaceRef{outline->profile.body, outline->profile.face} == *face_) {
            outline_ = *std::move(outline);
        }
    }
    start_ = px;
    distance_ = 0.0;
    pulled_.reset();
    dragging_ = face_.has_value();
    mark(face_);
    emit changed();
}

double PullController::snapped(double distance) const {
    const std::vector<Body>& bodies = document_.state().bodies;
    const Body& body = bodies[at(face_->body)];
    const SolidFace& face = body.solid.faces()[at(face_->face)];
    const Vec3 normal = body.pose.directionToWorld(face.normal);
    const double place = normal.dot(pointInFace(body, face_->face));
    const double reach = kSnapPx * document_.camera().worldPerPixel;
    double best = distance;
    double least = reach;
    for (const Body& other : bodies) {
        if (other.hidden) continue;
        for (const SolidFace& f : other.solid.faces()) {
            const Vec3 n = other.pose.directionToWorld(f.normal);
            constexpr double kParallel = 1e-9;
            if (n.cross(normal).norm() > kParallel) continue;
            const Vec3 p = other.pose.toWorld(other.solid.vertices()[at(f.loops[0][0])]);
            const double there = normal.dot(p) - place;
            if (std::abs(there - distance) >= least || std::abs(there) < kParallel) continue;
            least = std::abs(there - distance);
            best = there;
        }
    }
    if (best != distance) return best;
    const double step = roundStep(kLeastStepPx * document_.camera().worldPerPixel);
    return step * std::round(distance / step);
}

void PullController::dragTo(const Vec2& px) {
    if (!dragging_) return;
    const Body& body = document_.state().bodies[at(face_->body)];
    const Vec3 normal = body.pose.directionToWorld(body.solid.faces()[at(face_->face)].normal);
    const OrthographicCamera& camera = document_.camera();
    const Vec3 from = pointInFace(body, face_->face);
    const Vec2 along = camera.project(from + normal) - camera.project(from);
    constexpr double kLeastSlant = 0.1;
    double distance = 0.0;
    if (along.norm() * camera.worldPerPixel > kLeastSlant) {
        distance = (px - start_).dot(along) / along.squaredNorm();
    } else {
        // Seen straight on, a face comes nearer as the pointer goes up.
        distance = -(px - start_).y() * camera.worldPerPixel;
    }
    distance_ = snapped(distance);
    soon_.start(0);
    emit changed();
}

void PullController::showPreview() {
    if (!dragging_) return;
    if (distance_ == 0.0) {
        viewport_.setPreview({});
        return;
    }
    const auto after = document_.pulled({*face_, distance_, walls_, outline_});
    // The last one that could be made stays in sight.
    if (!after) return;
    ShapeInput input = document_.shapeInput();
    input.bodies = (*after)->bodies;
    input.settings = (*after)->surface;
    auto shape = std::make_shared<DerivedShape>(deriveShape(input, *document_.shapeCache()));
    viewport_.setPreview(ShapePreview{std::move(shape), true, (*after)->bodies});
}

Result<void> PullController::carryOut(const PullRequest& request) {
    working_ = true;
    auto done = document_.pull(request);
    working_ = false;
    viewport_.setPreview({});
    if (!done) return done;
    pulled_ = Made{request, document_.undoStack().index()};
    face_.reset();
    distance_ = request.distance;
    mark({});
    return {};
}

void PullController::release() {
    soon_.stop();
    if (!dragging_) return;
    dragging_ = false;
    if (distance_ == 0.0) {
        viewport_.setPreview({});
        emit changed();
        return;
    }
    if (auto done = carryOut({*face_, distance_, walls_, outline_}); !done) {
        emit failed(done.error());
    }
    emit changed();
}

void PullController::cancel() {
    soon_.stop();
    dragging_ = false;
    face_.reset();
    distance_ = 0.0;
    viewport_.setPreview({});
    mark({});
    emit changed();
}

void PullController::leave() {
    pulled_.reset();
    cancel();
}

void PullController::pullBy(double distance) {
    if (face_) {
        if (auto done = carryOut({*face_, distance, walls_, outline_}); !done) {
            emit failed(done.error());
        }
        emit changed();
        return;
    }
    if (!pulled_ || document_.undoStack().index() != pulled_->steps) return;
    if (pulled_->request.distance == distance && pulled_->request.walls == walls_) return;
    PullRequest request = pulled_->request;
    request.distance = distance;
    request.walls = walls_;
    working_ = true;
    auto undone = document_.undo();
    working_ = false;
    if (!undone) return;
    if (auto done = carryOut(request); !done) {
        // As it was.
        working_ = true;
        (void)document_.redo();
        working_ = false;
        emit failed(done.error());
    }
    emit changed();
}

}  // namespace ew
