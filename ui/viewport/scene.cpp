// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>

#include <algorithm>

#include "ui/viewport/hidden_line_mapper.h"
#include "ui/viewport/scene_geometry.h"
#include "ui/viewport/surface_geometry.h"

namespace ew {

namespace {

constexpr double kEdgeWidthPx = 1.6;
constexpr double kSoftWidthPx = 1.0;
constexpr double kCageWidthPx = 1.0;
constexpr double kChosenWidthPx = 3.2;
constexpr double kHiddenWidthPx = 1.1;
constexpr double kGridWidthPx = 1.0;
constexpr double kEdgeLiftPx = 3.0;    // of depth
constexpr double kRibbonLiftPx = 2.0;  // under the edges
constexpr double kDashPx = 7.0;
constexpr double kSoftShare = 0.55;      // of the body's colour in quiet lines
constexpr double kOcclusionReach = 0.2;  // how far corners darken, in reaches of the bodies
constexpr double kOcclusionBias = 0.02;  // nearer than this nothing casts, or flat faces would
// Dashes are cut anew when the scale differs by more than this factor.
constexpr double kDashSlack = 1.25;

void setColour(vtkActor* actor, const QColor& c) {
    actor->GetProperty()->SetColor(c.redF(), c.greenF(), c.blueF());
}

void makeUnlit(vtkActor* actor) {
    actor->GetProperty()->SetLighting(false);
    actor->PickableOff();
}

}  // namespace

struct Scene::Private {
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> occlusion;
    vtkNew<vtkActor> grid;
    vtkNew<vtkActor> faces;
    vtkNew<vtkActor> surfaces;
    vtkNew<vtkActor> soft;
    vtkNew<vtkActor> edges;
    vtkNew<vtkActor> hidden;
    vtkNew<vtkActor> ribbons;
    vtkNew<vtkActor> cage;
    vtkNew<vtkActor> chosen;
    vtkNew<vtkActor> chosenBehind;
    vtkNew<vtkPolyDataMapper> gridMapper;
    vtkNew<vtkPolyDataMapper> facesMapper;
    vtkNew<vtkPolyDataMapper> surfacesMapper;
    vtkNew<vtkPolyDataMapper> softMapper;
    vtkNew<vtkPolyDataMapper> edgesMapper;
    vtkNew<HiddenLineMapper> hiddenMapper;
    vtkNew<vtkPolyDataMapper> ribbonsMapper;
    vtkNew<vtkPolyDataMapper> cageMapper;
    vtkNew<vtkPolyDataMapper> chosenMapper;
    vtkNew<HiddenLineMapper> chosenBehindMapper;

    std::vector<Body> bodies;
    std::shared_ptr<const DerivedShape> shape;
    std::vector<MappedStroke> mapped;
    std::vector<EdgeRef> chosenEdges;
    LinePieces crisp;  // of the shape, for the dashes
    OrthographicCamera camera;
    const ThemeColours* colours = &lightColours();
    GridLayout layout;
    Vec3 origin = Vec3::Zero();  // of the coordinates given to VTK
    double ground = 0.0;
    double reach = 1.0;  // of the bodies from the origin
    double dashMm = 0.0;
    double scale = 1.0;
    int occlusionSamples = 0;
    QRectF tile;
    bool gridVisible = true;
    bool hiddenVisible = false;
    bool cageVisible = false;
    bool transparent = false;
    bool cameraSet = false;
    bool changed = true;

    void updateGrid() {
        const GridLayout wanted = gridLayout(camera, ground);
        if (wanted == layout) return;
        layout = wanted;
        rebuildGrid();
    }

    void rebuildGrid() {
        if (layout.spacing <= 0.0) return;
        gridMapper->SetInputData(gridGeometry(layout, origin, *colours));
    }

    void updateDashes() {
        hidden->SetVisibility(hiddenVisible && !bodies.empty());
        if (!hiddenVisible) return;
        const double wanted = kDashPx * camera.worldPerPixel;
        if (dashMm > 0.0 && wanted < dashMm * kDashSlack && wanted > dashMm / kDashSlack) return;
        dashMm = wanted;
        hiddenMapper->SetInputData(dashedGeometry(crisp, origin, dashMm));
    }

    void updateCamera() {
        vtkCamera* c = renderer->GetActiveCamera();
        c->ParallelProjectionOn();
        const QRectF part = tile.isEmpty() ? QRectF(0, 0, camera.width, camera.height) : tile;
        const Vec3 centre = camera.unproject(Vec2(part.center().x(), part.center().y())) - origin;
        const double seen = camera.worldPerPixel * std::max(camera.width, camera.height);
        const double gridReach = 1.5 * kGridCells * layout.spacing;
        const Vec2 gridAway(layout.centre.x() - camera.center.x(),
                            layout.centre.y() - camera.center.y());
        const double radius =
            std::max({centre.norm() + reach, seen,
                      gridReach + gridAway.norm() + std::abs(ground - camera.center.z())});
        const Vec3 eye = centre - camera.direction * (2.0 * radius);
        const Vec3 up = camera.trueUp();
        c->SetFocalPoint(centre.x(), centre.y(), centre.z());
        c->SetPosition(eye.x(), eye.y(), eye.z());
        c->SetViewUp(up.x(), up.y(), up.z());
        c->SetParallelScale(camera.worldPerPixel * part.height() / 2.0);
        c->SetClippingRange(0.9 * radius, 3.1 * radius);
        // Towards the eye, which in a parallel projection moves nothing on the screen: where a line
        // covers the border of a face, the face's depth there is only guessed by the card.
        const Vec3 nearer = -camera.direction * (kEdgeLiftPx * camera.worldPerPixel);
        for (vtkActor* lines : {edges.Get(), soft.Get(), cage.Get(), chosen.Get()}) {
            lines->SetPosition(nearer.x(), nearer.y(), nearer.z());
        }
        const Vec3 lift = nearer * (kRibbonLiftPx / kEdgeLiftPx);
        ribbons->SetPosition(lift.x(), lift.y(), lift.z());
    }

    void updateOcclusion() {
        if (occlusionSamples > 0) {
            occlusion->SetRadius(kOcclusionReach * reach);
            occlusion->SetBias(kOcclusionBias * reach);
            occlusion->SetKernelSize(static_cast<unsigned>(occlusionSamples));
        }
        renderer->SetPass(occlusionSamples > 0 ? occlusion.Get() : nullptr);
    }

    void updateRibbons() {
        if (!shape) return;
        ribbons->SetVisibility(!shape->curves.empty());
        ribbonsMapper->SetInputData(ribbonGeometry(*shape, mapped, origin, *colours));
    }

    void updateCage() {
        const bool shown = cageVisible && shape && shape->hasSurface();
        cage->SetVisibility(shown);
        if (shown) cageMapper->SetInputData(linesGeometry(cageLines(bodies, *shape), origin));
    }

    void updateChosen() {
        LinePieces lines;
        for (const EdgeRef& e : chosenEdges) {
            const auto body = static_cast<std::size_t>(e.body);
            const auto edge = static_cast<std::size_t>(e.edge);
            if (body >= bodies.size() || bodies[body].hidden ||
                edge >= bodies[body].solid.edges().size())
                continue;
            const auto& ends = bodies[body].solid.edges()[edge].ends;
            const auto corner = [&](int i) {
                const auto v = static_cast<std::size_t>(i);
                return bodies[body].pose.toWorld(bodies[body].solid.vertices()[v]);
            };
            lines.push_back({corner(ends[0]), corner(ends[1])});
        }
        chosen->SetVisibility(!lines.empty());
        chosenBehind->SetVisibility(!lines.empty());
        const auto data = linesGeometry(lines, origin);
        chosenMapper->SetInputData(data);
        chosenBehindMapper->SetInputData(data);
    }

    void updateBackground() {
        // Black under the transparent parts: what is drawn over it is premultiplied then.
        const QColor c = transparent ? QColor(Qt::black) : colours->background;
        renderer->SetBackground(c.redF(), c.greenF(), c.blueF());
        renderer->SetBackgroundAlpha(transparent ? 0.0 : 1.0);
        grid->SetVisibility(gridVisible && !transparent);
    }

    void updateWidths() {
        const std::pair<vtkActor*, double> widths[] = {
            {edges, kEdgeWidthPx},       {soft, kSoftWidthPx}, {hidden, kHiddenWidthPx},
            {grid, kGridWidthPx},        {cage, kCageWidthPx}, {chosen, kChosenWidthPx},
            {chosenBehind, kEdgeWidthPx}};
        for (const auto& [actor, width] : widths) {
            actor->GetProperty()->SetLineWidth(static_cast<float>(width * scale));
        }
    }

    void addLight(double x, double y, double z, double intensity) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(x, y, z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(intensity);
        renderer->AddLight(light);
    }
};

Scene::Scene() : d_(std::make_unique<Private>()) {
    Private& d = *d_;
    const std::pair<vtkActor*, vtkMapper*> parts[] = {{d.grid, d.gridMapper},
                                                      {d.faces, d.facesMapper},
                                                      {d.surfaces, d.surfacesMapper},
                                                      {d.hidden, d.hiddenMapper},
                                                      {d.chosenBehind, d.chosenBehindMapper},
                                                      {d.soft, d.softMapper},
                                                      {d.edges, d.edgesMapper},
                                                      {d.ribbons, d.ribbonsMapper},
                                                      {d.cage, d.cageMapper},
                                                      {d.chosen, d.chosenMapper}};
    for (const auto& [actor, mapper] : parts) {
        actor->SetMapper(mapper);
        if (actor != d.faces.Get() && actor != d.surfaces.Get()) makeUnlit(actor);
        d.renderer->AddActor(actor);  // in the order of drawing
    }
    vtkProperty* look = d.faces->GetProperty();
    look->SetInterpolationToFlat();
    look->SetAmbient(0.46);
    look->SetDiffuse(0.62);
    look->SetSpecular(0.0);
    vtkProperty* smooth = d.surfaces->GetProperty();
    smooth->SetInterpolationToPhong();
    smooth->SetAmbient(0.40);
    smooth->SetDiffuse(0.66);
    smooth->SetSpecular(0.10);
    smooth->SetSpecularPower(24.0);
    // Bodies are closed: what faces away is always behind something, and half of the work.
    look->BackfaceCullingOn();
    smooth->BackfaceCullingOn();
    // Faces step back in depth by more than half the width of a line, so that an edge is whole even
    // where its face comes nearer from it.
    for (vtkPolyDataMapper* mapper : {d.facesMapper.Get(), d.surfacesMapper.Get()}) {
        mapper->SetResolveCoincidentTopologyToPolygonOffset();
        mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.5, 4.0);
    }
    d.gridMapper->SetScalarModeToUsePointData();
    d.ribbonsMapper->SetScalarModeToUsePointData();
    d.occlusion->SetDelegatePass(d.steps);
    d.occlusion->BlurOn();
    d.renderer->AutomaticLightCreationOff();
    d.addLight(-0.4, 0.85, 0.9, 0.85);
    d.addLight(0.9, -0.1, 0.6, 0.14);
    d.updateWidths();
    setColours(lightColours());
    setShape({}, std::make_shared<const DerivedShape>(), {});
}

Scene::~Scene() = default;

vtkRenderer* Scene::renderer() const { return d_->renderer; }

void Scene::setShape(const std::vector<Body>& bodies, std::shared_ptr<const DerivedShape> shape,
                     const std::vector<MappedStroke>& mapped) {
    Private& d = *d_;
    d.bodies = bodies;
    d.shape = std::move(shape);
    Eigen::AlignedBox3d box;
    for (const Body& body : bodies) {
        if (body.hidden) continue;
        for (const Vec3& v : body.solid.vertices()) box.extend(body.pose.toWorld(v));
    }
    d.origin = box.isEmpty() ? Vec3::Zero() : Vec3(box.center());
    d.reach = box.isEmpty() ? 1.0 : std::max(1e-9, box.diagonal().norm() / 2);
    // A hair below the lowest face, which would flicker on the grid otherwise.
    d.ground = box.isEmpty() ? 0.0 : box.min().z() - 1e-3 * d.reach;
    ShapeLines lines = shapeLines(bodies, *d.shape);
    d.crisp = std::move(lines.crisp);
    d.facesMapper->SetInputData(flatGeometry(bodies, *d.shape, d.origin));
    d.surfacesMapper->SetInputData(smoothGeometry(bodies, *d.shape, d.origin));
    d.edgesMapper->SetInputData(linesGeometry(d.crisp, d.origin));
    d.softMapper->SetInputData(linesGeometry(lines.soft, d.origin));
    d.mapped = mapped;
    d.updateRibbons();
    d.faces->SetVisibility(!box.isEmpty());
    d.surfaces->SetVisibility(d.shape->hasSurface());
    d.edges->SetVisibility(!d.crisp.empty());
    d.soft->SetVisibility(!lines.soft.empty());
    d.updateOcclusion();
    d.updateCage();
    d.updateChosen();
    d.dashMm = 0.0;
    d.layout = {};
    d.updateDashes();
    d.updateGrid();
    d.updateCamera();
    d.changed = true;
}

void Scene::setCamera(const OrthographicCamera& camera) {
    Private& d = *d_;
    if (d.cameraSet && camera == d.camera) return;
    d.cameraSet = true;
    d.camera = camera;
    d.updateGrid();
    d.updateDashes();
    d.updateCamera();
    d.changed = true;
}

void Scene::setColours(const ThemeColours& colours) {
    Private& d = *d_;
    const bool other = d.colours != &colours;
    d.colours = &colours;
    if (other) d.updateRibbons();
    d.updateBackground();
    setColour(d.faces, colours.body);
    setColour(d.surfaces, colours.body);
    setColour(d.soft, mixColours(colours.bodyEdge, colours.body, kSoftShare));
    setColour(d.cage, colours.accent);
    setColour(d.chosen, colours.accent);
    setColour(d.chosenBehind, mixColours(colours.accent, colours.body, kSoftShare));
    setColour(d.edges, colours.bodyEdge);
    setColour(d.hidden, colours.hiddenEdge);
    d.rebuildGrid();
    d.changed = true;
}

void Scene::setGridVisible(bool on) {
    if (on == d_->gridVisible) return;
    d_->gridVisible = on;
    d_->updateBackground();
    d_->changed = true;
}

void Scene::setHiddenEdgesVisible(bool on) {
    if (on == d_->hiddenVisible) return;
    d_->hiddenVisible = on;
    d_->updateDashes();
    d_->changed = true;
}

void Scene::setOcclusion(int samples) {
    if (samples == d_->occlusionSamples) return;
    d_->occlusionSamples = samples;
    d_->updateOcclusion();
    d_->changed = true;
}

void Scene::setChosen(const std::vector<EdgeRef>& edges) {
    if (edges == d_->chosenEdges) return;
    d_->chosenEdges = edges;
    d_->updateChosen();
    d_->changed = true;
}

void Scene::setCageVisible(bool on) {
    if (on == d_->cageVisible) return;
    d_->cageVisible = on;
    d_->updateCage();
    d_->changed = true;
}

void Scene::setTile(const QRectF& tile) {
    if (tile == d_->tile) return;
    d_->tile = tile;
    d_->updateCamera();
    d_->changed = true;
}

void Scene::setTransparent(bool on) {
    if (on == d_->transparent) return;
    d_->transparent = on;
    d_->updateBackground();
    d_->changed = true;
}

void Scene::setScale(double devicePixelRatio) {
    if (devicePixelRatio == d_->scale) return;
    d_->scale = devicePixelRatio;
    d_->updateWidths();
    d_->changed = true;
}

bool Scene::changed() const { return d_->changed; }

bool Scene::takeChanged() { return std::exchange(d_->changed, false); }

}  // namespace ew
