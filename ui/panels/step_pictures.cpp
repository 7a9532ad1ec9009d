// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/step_pictures.h"

#include <algorithm>

#include "core/document/store.h"
#include "ui/viewport/shape_picture.h"

namespace ew {

namespace {

// A picture of this size shows no more of a surface, and more takes long.
constexpr int kMostLevels = 2;
constexpr std::size_t kMostKept = 2'000;

QImage pictureOfState(const DocumentState& state, ShapeCache& cache, QSize size, double ratio,
                      const ThemeColours& colours) {
    ShapeInput input{state.bodies, state.surface, {}};
    SubdivisionSettings& fine = input.settings.subdivision;
    fine.levels = std::min(fine.levels, kMostLevels);
    fine.tolerance = 0.0;
    // A little off the isometric direction, where corners of a cube would fall on each other.
    OrthographicCamera camera;
    camera.direction = Vec3(-0.55, 1.0, -0.6).normalized();
    return shapePicture(state.bodies, deriveShape(input, cache), camera, size, ratio, colours);
}

}  // namespace

StepPictures::StepPictures(QSize size, QObject* parent)
    : QObject(parent), size_(size), colours_(&lightColours()) {
    pool_.setMaxThreadCount(1);
    pool_.setThreadPriority(QThread::LowPriority);
}

StepPictures::~StepPictures() {
    pool_.clear();
    pool_.waitForDone();
}

void StepPictures::setLook(const ThemeColours& colours, double devicePixelRatio) {
    colours_ = &colours;
    ratio_ = devicePixelRatio;
    ++look_;
    pool_.clear();
    kept_.clear();
    emit ready();
}

QImage StepPictures::picture(const std::shared_ptr<const DocumentState>& state) {
    if (state == nullptr || state->bodies.empty()) return {};
    const auto found = kept_.find(state.get());
    // Another state may have got the address of one that is gone.
    if (found != kept_.end() && found->second.state.lock() == state) return found->second.image;
    if (kept_.size() > kMostKept) forgetGone();
    kept_[state.get()] = {state, {}, false};
    make(state);
    return {};
}

void StepPictures::make(const std::shared_ptr<const DocumentState>& state) {
    pool_.start([this, state, cache = cache_, size = size_, ratio = ratio_, colours = colours_,
                 look = look_] {
        const QImage image = pictureOfState(*state, *cache, size, ratio, *colours);
        QMetaObject::invokeMethod(
            this, [this, state, look, image] { keep(state.get(), look, image); },
            Qt::QueuedConnection);
    });
}

void StepPictures::keep(const DocumentState* state, long look, const QImage& image) {
    const auto found = kept_.find(state);
    if (look != look_ || found == kept_.end()) return;
    found->second.image = image;
    found->second.made = true;
    emit ready();
}

void StepPictures::forgetGone() {
    std::erase_if(kept_, [](const auto& pair) { return pair.second.state.expired(); });
    if (kept_.size() > kMostKept) kept_.clear();
}

}  // namespace ew
