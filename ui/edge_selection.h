// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "core/document/document.h"

namespace ew {

/// Which edges the surface panel speaks of: all, the convex or concave ones, or those that were
/// picked. Picked edges go when the solids change, for then they are other edges.
class EdgeSelection : public QObject {
    Q_OBJECT

  public:
    explicit EdgeSelection(Document& document, QObject* parent = nullptr);

    const EdgeChoice& choice() const { return choice_; }
    /// The edges of the choice; none where there is no solid.
    std::vector<EdgeRef> edges() const;

    void setWhich(EdgeChoice::Which which);
    /// Picks edges.
    /// \param add  keeps those that were picked before; where all of the new ones were among them,
    ///     they are taken out.
    void pick(const std::vector<EdgeRef>& edges, bool add);

  signals:
    void changed();

  private:
    Document& document_;
    EdgeChoice choice_;
};

/// The face that is seen at a point of the view, and where on it.
struct FaceHit : FaceRef {
    Vec3 world = Vec3::Zero();  ///< [mm]
};

/// \param px  of the view.
std::optional<FaceHit> faceUnder(const std::vector<Body>& bodies, const OrthographicCamera& camera,
                                 const Vec2& px);

/// All edges of a face.
std::vector<EdgeRef> edgesOfFace(const std::vector<Body>& bodies, const FaceRef& face);

/// What a click picks.
enum class PickMode { Edge, Loop, Face };

/// The edges that a click at a point of the view means: the nearest edge that is seen (else any)
/// within reach, the loop of a face that it is in, or all edges of the face under the point. Empty
/// where nothing is there.
std::vector<EdgeRef> edgesAt(const std::vector<Body>& bodies, const OrthographicCamera& camera,
                             const Vec2& px, PickMode mode);

}  // namespace ew
