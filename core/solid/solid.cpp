// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/solid.h"

#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "core/solid/assemble.h"
#include "core/solid/mesh_kernel.h"
#include "core/solid/realize.h"
#include "core/solid/serialize.h"
#include "core/solid/validity.h"

namespace ew {
namespace {

Result<std::shared_ptr<const Solid::Impl>> fromFaces(const PolyhedronSpec& spec) {
    std::vector<FaceLoops> faces;
    for (const auto& face : spec.faces) faces.push_back({face});
    if (auto ok = checkCoordinates(spec.vertices); !ok) return fail(ok.error());
    if (auto ok = checkLoops(spec.vertices.size(), faces); !ok) return fail(ok.error());
    auto brep = realize(spec);
    if (!brep) return fail(brep.error());
    return assemble(std::move(*brep));
}

}  // namespace

/// What copies of a solid share.
class Solid::Content {
  public:
    explicit Content(std::shared_ptr<const Impl> impl)
        : impl_(std::move(impl)), ready_(impl_.get()) {}
    explicit Content(std::function<Result<std::string>()> text) : text_(std::move(text)) {}

    /// nullptr: not read yet.
    const Impl* ready() const { return ready_.load(std::memory_order_acquire); }

    Result<const Impl*> read() {
        if (const Impl* made = ready()) return made;
        const std::lock_guard lock(mutex_);
        if (const Impl* made = ready()) return made;
        if (problem_) return fail(*problem_);
        const auto text = text_();
        auto solid = text ? deserialize(*text) : Result<Solid>(fail(text.error()));
        if (!solid) {
            problem_ = solid.error();
            return fail(*problem_);
        }
        impl_ = solid->content_->impl_;
        text_ = nullptr;  // what it holds is of no more use
        ready_.store(impl_.get(), std::memory_order_release);
        return impl_.get();
    }

    /// The text that it is to be read from; nothing where it was read.
    std::optional<Result<std::string>> text() {
        const std::lock_guard lock(mutex_);
        return text_ ? std::optional(text_()) : std::nullopt;
    }

  private:
    std::mutex mutex_;  ///< of the members below but for `ready_`
    std::function<Result<std::string>()> text_;
    std::optional<Error> problem_;
    std::shared_ptr<const Impl> impl_;
    std::atomic<const Impl*> ready_ = nullptr;
};

Solid::Solid(std::shared_ptr<const Impl> impl)
    : content_(std::make_shared<Content>(std::move(impl))) {}
Solid::Solid(std::shared_ptr<Content> content) : content_(std::move(content)) {}

Solid Solid::deferred(std::function<Result<std::string>()> text) {
    return Solid(std::make_shared<Content>(std::move(text)));
}

const Solid::Impl& Solid::impl() const {
    if (const Impl* made = content_->ready()) return *made;
    const auto read = content_->read();
    if (!read) throw std::runtime_error(read.error().message);
    return **read;
}

Result<void> Solid::load() const {
    const auto read = content_->read();
    if (!read) return fail(read.error());
    return {};
}

bool Solid::isLoaded() const { return content_->ready() != nullptr; }

std::string Solid::serialize() const {
    if (!isLoaded()) {
        const auto text = content_->text();
        if (text && *text) return **text;
    }
    return textOf(impl());
}

Result<Solid> Solid::fromSpec(const PolyhedronSpec& spec) {
    try {
        auto impl = fromFaces(spec);
        if (!impl) return fail(impl.error());
        return Solid(std::move(*impl));
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The solid could not be built: ") + e.what());
    }
}

const std::vector<Vec3>& Solid::vertices() const { return impl().vertices; }
const std::vector<SolidEdge>& Solid::edges() const { return impl().edges; }
const std::vector<SolidFace>& Solid::faces() const { return impl().faces; }
const std::vector<SolidTriangle>& Solid::triangles() const { return impl().triangles; }
int Solid::shellCount() const { return impl().shells; }
int Solid::genus() const { return impl().genus; }
double Solid::volume() const { return impl().volume; }
double Solid::area() const { return impl().area; }
std::array<Vec3, 2> Solid::bounds() const { return impl().bounds; }

bool Solid::identicalTo(const Solid& other) const {
    if (sharesDataWith(other)) return true;
    const Impl& a = impl();
    const Impl& b = other.impl();
    if (a.vertices != b.vertices || a.faces.size() != b.faces.size() ||
        a.triangles.size() != b.triangles.size()) {
        return false;
    }
    for (std::size_t f = 0; f < a.faces.size(); ++f) {
        if (a.faces[f].loops != b.faces[f].loops) return false;
    }
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
        if (a.triangles[t].vertices != b.triangles[t].vertices ||
            a.triangles[t].face != b.triangles[t].face) {
            return false;
        }
    }
    for (const auto v : a.surface.mesh.vertices()) {
        if (a.surface.point(v) != b.surface.point(v)) return false;
    }
    return true;
}

}  // namespace ew
