// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>

#include "ui/viewport/hidden_line_mapper.h"
#include "ui/viewport/scene_geometry.h"

namespace ew {

namespace {

constexpr double kEdgeWidthPx = 1.6;
constexpr double kHiddenWidthPx = 1.1;
constexpr double kGridWidthPx = 1.0;
constexpr double kEdgeLiftPx = 3.0;  // of depth
constexpr double kDashPx = 7.0;
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
    vtkNew<vtkActor> grid;
    vtkNew<vtkActor> faces;
    vtkNew<vtkActor> edges;
    vtkNew<vtkActor> hidden;
    vtkNew<vtkPolyDataMapper> gridMapper;
    vtkNew<vtkPolyDataMapper> facesMapper;
    vtkNew<vtkPolyDataMapper> edgesMapper;
    vtkNew<HiddenLineMapper> hiddenMapper;

    std::vector<Body> bodies;
    OrthographicCamera camera;
    const ThemeColours* colours = &lightColours();
    GridLayout layout;
    Vec3 origin = Vec3::Zero();  // of the coordinates given to VTK
    double ground = 0.0;
    double reach = 1.0;  // of the bodies from the origin
    double dashMm = 0.0;
    double scale = 1.0;
    bool gridVisible = true;
    bool hiddenVisible = false;
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
        hiddenMapper->SetInputData(dashedGeometry(bodies, origin, dashMm));
    }

    void updateCamera() {
        vtkCamera* c = renderer->GetActiveCamera();
        c->ParallelProjectionOn();
        const Vec3 centre = camera.center - origin;
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
        c->SetParallelScale(camera.worldPerPixel * camera.height / 2.0);
        c->SetClippingRange(0.9 * radius, 3.1 * radius);
        // Towards the eye, which in a parallel projection moves nothing on the screen: where a line
        // covers the border of a face, the face's depth there is only guessed by the card.
        const Vec3 nearer = -camera.direction * (kEdgeLiftPx * camera.worldPerPixel);
        edges->SetPosition(nearer.x(), nearer.y(), nearer.z());
    }

    void updateWidths() {
        edges->GetProperty()->SetLineWidth(static_cast<float>(kEdgeWidthPx * scale));
        hidden->GetProperty()->SetLineWidth(static_cast<float>(kHiddenWidthPx * scale));
        grid->GetProperty()->SetLineWidth(static_cast<float>(kGridWidthPx * scale));
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
    d.grid->SetMapper(d.gridMapper);
    d.faces->SetMapper(d.facesMapper);
    d.edges->SetMapper(d.edgesMapper);
    d.hidden->SetMapper(d.hiddenMapper);
    makeUnlit(d.grid);
    makeUnlit(d.edges);
    makeUnlit(d.hidden);
    vtkProperty* look = d.faces->GetProperty();
    look->SetInterpolationToFlat();
    look->SetAmbient(0.46);
    look->SetDiffuse(0.62);
    look->SetSpecular(0.0);
    // Faces step back in depth by more than half the width of a line, so that an edge is whole even
    // where its face comes nearer from it.
    d.facesMapper->SetResolveCoincidentTopologyToPolygonOffset();
    d.facesMapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(2.5, 4.0);
    d.gridMapper->SetScalarModeToUsePointData();
    d.renderer->AddActor(d.grid);
    d.renderer->AddActor(d.faces);
    d.renderer->AddActor(d.hidden);
    d.renderer->AddActor(d.edges);
    d.renderer->AutomaticLightCreationOff();
    d.addLight(-0.4, 0.85, 0.9, 0.85);
    d.addLight(0.9, -0.1, 0.6, 0.14);
    d.updateWidths();
    setColours(lightColours());
    setBodies({});
}

Scene::~Scene() = default;

vtkRenderer* Scene::renderer() const { return d_->renderer; }

void Scene::setBodies(const std::vector<Body>& bodies) {
    Private& d = *d_;
    d.bodies = bodies;
    Eigen::AlignedBox3d box;
    for (const Body& body : bodies) {
        for (const Vec3& v : body.solid.vertices()) box.extend(body.pose.toWorld(v));
    }
    d.origin = box.isEmpty() ? Vec3::Zero() : Vec3(box.center());
    d.reach = box.isEmpty() ? 1.0 : std::max(1e-9, box.diagonal().norm() / 2);
    // A hair below the lowest face, which would flicker on the grid otherwise.
    d.ground = box.isEmpty() ? 0.0 : box.min().z() - 1e-3 * d.reach;
    d.facesMapper->SetInputData(facesGeometry(bodies, d.origin));
    d.edgesMapper->SetInputData(edgesGeometry(bodies, d.origin));
    d.faces->SetVisibility(!bodies.empty());
    d.edges->SetVisibility(!bodies.empty());
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
    d.colours = &colours;
    d.renderer->SetBackground(colours.background.redF(), colours.background.greenF(),
                              colours.background.blueF());
    setColour(d.faces, colours.body);
    setColour(d.edges, colours.bodyEdge);
    setColour(d.hidden, colours.hiddenEdge);
    d.rebuildGrid();
    d.changed = true;
}

void Scene::setGridVisible(bool on) {
    if (on == d_->gridVisible) return;
    d_->gridVisible = on;
    d_->grid->SetVisibility(on);
    d_->changed = true;
}

void Scene::setHiddenEdgesVisible(bool on) {
    if (on == d_->hiddenVisible) return;
    d_->hiddenVisible = on;
    d_->updateDashes();
    d_->changed = true;
}

void Scene::setScale(double devicePixelRatio) {
    if (devicePixelRatio == d_->scale) return;
    d_->scale = devicePixelRatio;
    d_->updateWidths();
    d_->changed = true;
}

bool Scene::takeChanged() { return std::exchange(d_->changed, false); }

}  // namespace ew
