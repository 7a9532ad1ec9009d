// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmpxx.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/solid/solid.h"
#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

double uniform(double low, double high) {
    const int step = *rc::gen::inRange(0, 1'000'001);
    return low + (high - low) * step * 1e-6;
}

/// One of the shapes with 3 to 9 sides.
PolyhedronSpec anyShape() {
    const int sides = *rc::gen::inRange(3, 10);
    switch (*rc::gen::inRange(0, 7)) {
        case 0:
            return prism(sides);
        case 1:
            return pyramid(sides);
        case 2:
            return bipyramid(sides);
        case 3:
            return antiprism(sides);
        case 4:
            return frustum(sides, uniform(0.2, 0.9));
        case 5:
            return lPrism();
        default:
            return squareRing();
    }
}

PolyhedronSpec anyPlace(const PolyhedronSpec& spec) {
    return moved(spec, uniform(0.0, 6.3), uniform(0.01, 500.0),
                 Vec3(uniform(-900, 900), uniform(-900, 900), uniform(-900, 900)));
}

RC_GTEST_PROP(SolidProperty, TurningKeepsCountsAndVolume, ()) {
    const PolyhedronSpec still = anyShape();
    const PolyhedronSpec turned = anyPlace(still);
    const auto a = Solid::fromSpec(still);
    const auto b = Solid::fromSpec(turned);
    RC_ASSERT(a.has_value());
    RC_ASSERT(b.has_value());
    RC_ASSERT(a->vertices().size() == b->vertices().size());
    RC_ASSERT(a->edges().size() == b->edges().size());
    RC_ASSERT(a->faces().size() == b->faces().size());
    RC_ASSERT(a->genus() == b->genus());
    const double volume = plainVolume(turned);
    RC_ASSERT(std::abs(b->volume() - volume) < 1e-8 * volume);
}

RC_GTEST_PROP(SolidProperty, SerializeAndBackIsBitEqual, ()) {
    const auto solid = Solid::fromSpec(anyPlace(anyShape()));
    RC_ASSERT(solid.has_value());
    const std::string text = solid->serialize();
    const auto back = Solid::deserialize(text);
    RC_ASSERT(back.has_value());
    RC_ASSERT(back->identicalTo(*solid));
    RC_ASSERT(back->serialize() == text);
    RC_ASSERT(back->volume() == solid->volume());
}

using ExactPoint = std::array<mpq_class, 3>;

/// The exact points of a solid, read from its text form.
std::vector<ExactPoint> exactPoints(const Solid& solid) {
    std::istringstream in(solid.serialize());
    std::string word;
    std::size_t count = 0;
    in >> word >> word >> word >> count;
    std::vector<ExactPoint> points(count);
    for (ExactPoint& p : points) {
        for (mpq_class& x : p) {
            in >> word;
            if (word.find('/') != std::string::npos) {
                x = mpq_class(word);
            } else {
                x = mpq_class(std::stod(word));
            }
        }
    }
    return points;
}

mpq_class determinant(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                      const ExactPoint& d) {
    std::array<ExactPoint, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
        m[0][k] = b[k] - a[k];
        m[1][k] = c[k] - a[k];
        m[2][k] = d[k] - a[k];
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

RC_GTEST_PROP(SolidProperty, FacesArePlanarInExactArithmetic, ()) {
    const auto solid = Solid::fromSpec(anyPlace(anyShape()));
    RC_ASSERT(solid.has_value());
    const auto points = exactPoints(*solid);
    RC_ASSERT(points.size() == solid->vertices().size());
    for (const SolidFace& face : solid->faces()) {
        // Any three points of a loop of these shapes span the plane.
        const auto& first = face.loops[0];
        const auto at = [&](int i) -> const ExactPoint& {
            return points[static_cast<std::size_t>(i)];
        };
        for (const auto& loop : face.loops) {
            for (const int i : loop) {
                RC_ASSERT(determinant(at(first[0]), at(first[1]), at(first[2]), at(i)) == 0);
            }
        }
    }
}

ExactPoint exactNormal(const std::vector<ExactPoint>& points, const SolidFace& face) {
    const auto at = [&](std::size_t k) -> const ExactPoint& {
        return points[static_cast<std::size_t>(face.loops[0][k])];
    };
    ExactPoint u;
    ExactPoint v;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = at(1)[k] - at(0)[k];
        v[k] = at(2)[k] - at(0)[k];
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

RC_GTEST_PROP(SolidProperty, OppositeFacesOfAPrismAreParallelExactly, ()) {
    const int half = *rc::gen::inRange(2, 5);
    const auto solid = Solid::fromSpec(anyPlace(prism(2 * half)));
    RC_ASSERT(solid.has_value());
    const auto points = exactPoints(*solid);
    const auto parallel = [&](int f, int g) {
        const ExactPoint n = exactNormal(points, solid->faces()[static_cast<std::size_t>(f)]);
        const ExactPoint m = exactNormal(points, solid->faces()[static_cast<std::size_t>(g)]);
        return n[0] * m[1] == n[1] * m[0] && n[1] * m[2] == n[2] * m[1] &&
               n[2] * m[0] == n[0] * m[2];
    };
    RC_ASSERT(parallel(0, 1));
    for (int i = 0; i < half; ++i) RC_ASSERT(parallel(2 + i, 2 + half + i));
}

RC_GTEST_PROP(SolidProperty, RelabellingKeepsTheSolid, ()) {
    const PolyhedronSpec spec = anyPlace(anyShape());
    const int n = static_cast<int>(spec.vertices.size());
    const int shift = *rc::gen::inRange(1, n);
    PolyhedronSpec other;
    other.vertices.resize(spec.vertices.size());
    for (int i = 0; i < n; ++i) {
        other.vertices[static_cast<std::size_t>((i + shift) % n)] =
            spec.vertices[static_cast<std::size_t>(i)];
    }
    for (auto it = spec.faces.rbegin(); it != spec.faces.rend(); ++it) {
        std::vector<int> face = *it;
        for (int& i : face) i = (i + shift) % n;
        other.faces.push_back(face);
    }
    const auto a = Solid::fromSpec(spec);
    const auto b = Solid::fromSpec(other);
    RC_ASSERT(a.has_value());
    RC_ASSERT(b.has_value());
    RC_ASSERT(a->edges().size() == b->edges().size());
    RC_ASSERT(a->faces().size() == b->faces().size());
    RC_ASSERT(std::abs(a->volume() - b->volume()) < 1e-9 * a->volume());
}

RC_GTEST_PROP(SolidProperty, RandomFacesNeverCrash, ()) {
    PolyhedronSpec spec = anyShape();
    const int n = static_cast<int>(spec.vertices.size());
    const int changes = *rc::gen::inRange(1, 5);
    for (int c = 0; c < changes; ++c) {
        auto& face = spec.faces[static_cast<std::size_t>(
            *rc::gen::inRange(0, static_cast<int>(spec.faces.size())))];
        const auto k =
            static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(face.size())));
        switch (*rc::gen::inRange(0, 4)) {
            case 0:
                face[k] = *rc::gen::inRange(-1, n + 1);
                break;
            case 1:
                face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
                break;
            case 2:
                std::swap(face[k], face[0]);
                break;
            default: {
                auto& p = spec.vertices[static_cast<std::size_t>(*rc::gen::inRange(0, n))];
                p = spec.vertices[static_cast<std::size_t>(*rc::gen::inRange(0, n))] *
                    *rc::gen::inRange(0, 3);
            }
        }
        if (face.empty()) face.push_back(0);
    }
    const auto solid = Solid::fromSpec(spec);
    if (solid) {
        RC_ASSERT(solid->volume() > 0.0);
    } else {
        RC_ASSERT(solid.error().code != Errc::Internal);
    }
}

// The text form ----------------------------------------------------------------------------------

std::string boxText() { return Solid::fromSpec(box(Vec3::Zero(), Vec3(1, 2, 3)))->serialize(); }

TEST(DeferredSolid, IsReadWhenItIsLookedAtFirst) {
    const Solid box = *Solid::fromSpec(test::box(Vec3::Zero(), Vec3(1, 2, 3)));
    const std::string text = box.serialize();
    int asked = 0;
    const Solid deferred = Solid::deferred([&]() -> Result<std::string> {
        ++asked;
        return text;
    });
    const Solid copy = deferred;
    EXPECT_TRUE(copy.sharesDataWith(deferred));
    EXPECT_FALSE(copy.sharesDataWith(box));
    EXPECT_EQ(asked, 0);
    EXPECT_EQ(deferred.serialize(), text);
    EXPECT_FALSE(deferred.isLoaded());
    EXPECT_EQ(copy.faces().size(), 6U);
    EXPECT_TRUE(deferred.isLoaded());
    EXPECT_EQ(asked, 2) << "once to serialize it, once to read it";
    EXPECT_TRUE(deferred.identicalTo(box));
    EXPECT_EQ(deferred.serialize(), text);
    EXPECT_EQ(asked, 2);
    EXPECT_TRUE(deferred.load());
}

TEST(DeferredSolid, ThatIsNoneSaysSoEveryTime) {
    const Solid broken =
        Solid::deferred([]() -> Result<std::string> { return std::string("no solid"); });
    const Solid lost =
        Solid::deferred([]() -> Result<std::string> { return fail(Errc::Damaged, "It is gone."); });
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(broken.load());
        EXPECT_THROW(broken.vertices(), std::runtime_error);
        EXPECT_EQ(lost.load().error().code, Errc::Damaged);
    }
    EXPECT_EQ(broken.serialize(), "no solid");
}

TEST(DeferredSolid, IsReadOnceByManyThreads) {
    const std::string text = boxText();
    std::atomic<int> asked = 0;
    const Solid solid = Solid::deferred([&]() -> Result<std::string> {
        ++asked;
        return text;
    });
    std::atomic<std::size_t> faces = 0;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < 8; ++i) threads.emplace_back([&] { faces += solid.faces().size(); });
    }
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(faces, 48U);
}

TEST(SolidText, SaysWhatItHolds) {
    const std::string text = boxText();
    EXPECT_EQ(text.substr(0, text.find('\n')), "edgewright-solid 1");
    EXPECT_NE(text.find("vertices 8\n0 0 0\n1 0 0\n"), std::string::npos) << text;
    EXPECT_NE(text.find("faces 6\n1 4 0 3 2 1\n"), std::string::npos) << text;
}

TEST(SolidText, AFaceWithAHoleComesBack) {
    const auto ring = Solid::fromSpec(squareRing());
    ASSERT_TRUE(ring);
    const auto back = Solid::deserialize(ring->serialize());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->identicalTo(*ring));
}

TEST(SolidText, FacetedFacesComeBack) {
    const auto ring = Solid::fromSpec(moved(torus(8, 5), 0.7, 30.1, Vec3(3, 5, 7)));
    ASSERT_TRUE(ring);
    EXPECT_EQ(ring->faces().size(), 40U);
    const auto back = Solid::deserialize(ring->serialize());
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->identicalTo(*ring));
}

TEST(SolidText, CutAnywhereIsRefused) {
    const std::string text = boxText();
    for (std::size_t end = 0; end + 1 < text.size(); ++end) {
        EXPECT_FALSE(Solid::deserialize(text.substr(0, end))) << "cut at " << end;
    }
}

TEST(SolidText, BadTextsAreRefusedWithTheirCode) {
    const std::string text = boxText();
    const auto with = [&](const std::string& what, const std::string& by) {
        std::string out = text;
        const auto at = out.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        return out.replace(at, what.size(), by);
    };
    struct Case {
        std::string text;
        Errc code;
    };
    const std::vector<Case> cases{
        {"", Errc::WrongFormat},
        {"nonsense", Errc::WrongFormat},
        {with("solid 1", "solid 2"), Errc::WrongVersion},
        {with("vertices 8", "vertices 18446744073709551615"), Errc::BadValue},
        {with("vertices 8", "vertices 99999999"), Errc::BadValue},
        {with("vertices 8", "vertices -8"), Errc::BadValue},
        {with("vertices 8", "vertices 7"), Errc::BadValue},
        {with("0 0 0", "nan 0 0"), Errc::BadValue},
        {with("0 0 0", "inf 0 0"), Errc::BadValue},
        {with("0 0 0", "1e300 0 0"), Errc::BadValue},
        {with("0 0 0", "1/0 0 0"), Errc::BadValue},
        {with("0 0 0", "1/-3 0 0"), Errc::BadValue},
        {with("0 0 0", "/ 0 0"), Errc::BadValue},
        {with("0 0 0", "0x10/3 0 0"), Errc::BadValue},
        {with("0 0 0", "99999999999999999999999/3 0 0"), Errc::BadValue},
        {with("1 4 0 3 2 1", "1 4 0 3 2 8"), Errc::BadValue},
        {with("1 4 0 3 2 1", "1 4 1 2 3 0"), Errc::NotOriented},
        {with("1 4 0 3 2 1", "0"), Errc::BadValue},
        {with("faces 6", "faces 5"), Errc::BadValue},
        {with("1 0 0", "1/3 0 0"), Errc::NotPlanar},
        {text + "more", Errc::BadValue},
    };
    for (const Case& c : cases) {
        const auto solid = Solid::deserialize(c.text);
        ASSERT_FALSE(solid) << c.text;
        EXPECT_EQ(errcName(solid.error().code), errcName(c.code)) << solid.error().message << "\n"
                                                                  << c.text;
    }
}

RC_GTEST_PROP(SolidText, MutatedTextsNeverCrash, ()) {
    std::string text = boxText();
    const int changes = *rc::gen::inRange(1, 6);
    const std::string alphabet = "0123456789 -/.e\nx";
    for (int c = 0; c < changes; ++c) {
        const auto at =
            static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(text.size())));
        text[at] = alphabet[static_cast<std::size_t>(
            *rc::gen::inRange(0, static_cast<int>(alphabet.size())))];
    }
    const auto solid = Solid::deserialize(text);
    if (solid) RC_ASSERT(solid->volume() > 0.0);
}

}  // namespace
}  // namespace ew::test
