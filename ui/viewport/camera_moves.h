// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/solid.h"

namespace ew {

// Moves of the parallel camera. Each returns the moved camera; sizes and px are logical.

enum class StandardView { Home, Front, Back, Left, Right, Top, Bottom };

/// Turntable orbit: dx turns about the vertical, dy tips about the screen's horizontal, stopping
/// when it looks straight down or up. The pivot stays at its px.
OrthographicCamera orbitCamera(const OrthographicCamera& camera, const Vec2& deltaPx,
                               const Vec3& pivot);

/// The scene follows the pointer.
OrthographicCamera panCamera(const OrthographicCamera& camera, const Vec2& deltaPx);

/// Scales by a factor (> 1 comes nearer) about a px that stays where it is. Within 1e-6..1e6 mm/px.
OrthographicCamera zoomCamera(const OrthographicCamera& camera, const Vec2& px, double factor);

/// Looks along a standard direction, centre and scale kept.
OrthographicCamera standardView(const OrthographicCamera& camera, StandardView view);

/// Centres and scales so that all points are seen with a margin. No points: unchanged.
OrthographicCamera fitCamera(const OrthographicCamera& camera, const std::vector<Vec3>& points);

/// The camera in a viewport of another size. Keeps the scale (a window that is resized).
OrthographicCamera resizeCamera(const OrthographicCamera& camera, double width, double height);

/// The camera for a picture of another size: everything that was seen is still seen.
OrthographicCamera scaleCamera(const OrthographicCamera& camera, double width, double height);

/// World positions of all vertices.
std::vector<Vec3> bodyPoints(const std::vector<Body>& bodies);

}  // namespace ew
