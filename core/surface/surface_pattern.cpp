// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/surface_pattern.h"

#include <opensubdiv/bfr/tessellation.h>

#include <algorithm>

namespace ew {
namespace {

using OpenSubdiv::Bfr::Parameterization;
using OpenSubdiv::Bfr::Tessellation;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A grid of R x R quadrangles.
SurfacePattern quadPattern(int rate) {
    SurfacePattern out;
    std::vector<int> id(at((rate + 1) * (rate + 1)), -1);
    const auto add = [&](int i, int k) {
        id[at(i + (rate + 1) * k)] = static_cast<int>(out.coords.size());
        out.coords.emplace_back(static_cast<double>(i) / rate, static_cast<double>(k) / rate);
    };
    for (int i = 0; i < rate; ++i) add(i, 0);
    for (int i = 0; i < rate; ++i) add(rate, i);
    for (int i = 0; i < rate; ++i) add(rate - i, rate);
    for (int i = 0; i < rate; ++i) add(0, rate - i);
    for (int k = 1; k < rate; ++k) {
        for (int i = 1; i < rate; ++i) add(i, k);
    }
    for (int k = 0; k < rate; ++k) {
        for (int i = 0; i < rate; ++i) {
            const auto a = at(i + (rate + 1) * k);
            const auto up = at(rate + 1);
            out.facets.push_back({id[a], id[a + 1], id[a + up + 1], id[a + up]});
        }
    }
    return out;
}

/// A grid of R^2 triangles.
SurfacePattern trianglePattern(int rate) {
    SurfacePattern out;
    std::vector<int> id(at((rate + 1) * (rate + 1)), -1);
    const auto add = [&](int i, int k) {
        id[at(i + (rate + 1) * k)] = static_cast<int>(out.coords.size());
        out.coords.emplace_back(static_cast<double>(i) / rate, static_cast<double>(k) / rate);
    };
    for (int i = 0; i < rate; ++i) add(i, 0);
    for (int i = 0; i < rate; ++i) add(rate - i, i);
    for (int i = 0; i < rate; ++i) add(0, rate - i);
    for (int k = 1; k < rate; ++k) {
        for (int i = 1; i + k < rate; ++i) add(i, k);
    }
    const auto at2 = [&](int i, int k) { return id[at(i + (rate + 1) * k)]; };
    for (int k = 0; k < rate; ++k) {
        for (int i = 0; i + k < rate; ++i) {
            out.facets.push_back({at2(i, k), at2(i + 1, k), at2(i, k + 1), -1});
            if (i + k + 2 > rate) continue;
            out.facets.push_back({at2(i + 1, k), at2(i + 1, k + 1), at2(i, k + 1), -1});
        }
    }
    return out;
}

/// A grid of quadrangles for each corner of a polygon.
class PolygonPattern {
  public:
    PolygonPattern(const Parameterization& face, int rate)
        : face_(face), size_(face.GetFaceSize()), rate_(rate), half_(rate / 2) {}

    SurfacePattern make() {
        for (int k = 0; k < size_; ++k) {
            for (int i = 0; i < rate_; ++i)
                add(i <= half_ ? k : next(k), i <= half_ ? i : 0, i <= half_ ? 0 : rate_ - i);
        }
        const int spokes = static_cast<int>(out_.coords.size());
        for (int k = 0; k < size_; ++k) {
            for (int q = 1; q < half_; ++q) add(k, half_, q);
        }
        center_ = static_cast<int>(out_.coords.size());
        add(0, half_, half_);
        const int inside = center_ + 1;
        for (int k = 0; k < size_; ++k) {
            for (int q = 1; q < half_; ++q) {
                for (int p = 1; p < half_; ++p) add(k, p, q);
            }
        }
        const auto id = [&](int k, int p, int q) {
            const int before = (k + size_ - 1) % size_;
            if (p == half_ && q == half_) return center_;
            if (q == 0) return k * rate_ + p;
            if (p == 0) return before * rate_ + rate_ - q;
            if (p == half_) return spokes + k * (half_ - 1) + q - 1;
            if (q == half_) return spokes + before * (half_ - 1) + p - 1;
            return inside + (k * (half_ - 1) + q - 1) * (half_ - 1) + p - 1;
        };
        for (int k = 0; k < size_; ++k) {
            for (int q = 0; q < half_; ++q) {
                for (int p = 0; p < half_; ++p) {
                    out_.facets.push_back(
                        {id(k, p, q), id(k, p + 1, q), id(k, p + 1, q + 1), id(k, p, q + 1)});
                }
            }
        }
        return std::move(out_);
    }

  private:
    int next(int k) const { return (k + 1) % size_; }
    void add(int subFace, int p, int q) {
        const double sub[2] = {static_cast<double>(p) / half_, static_cast<double>(q) / half_};
        Vec2 uv;
        face_.ConvertNormalizedSubFaceToCoord(subFace, sub, uv.data());
        out_.coords.push_back(uv);
    }

    const Parameterization& face_;
    int size_;
    int rate_;
    int half_;
    int center_ = -1;
    SurfacePattern out_;
};

/// A quadrangle with its own number of pieces on every edge. OpenSubdiv's own pattern puts a fan
/// round the middle where one inner rate is 1, which a cylinder's long faces cannot bear.
class StitchedPattern {
  public:
    explicit StitchedPattern(const std::vector<int>& rates)
        : rates_(rates), across_(rates[4]), along_(rates[5]) {
        // Points on the other pair of edges need rows to go to.
        if (across_ == 1 && (rates[0] > 1 || rates[2] > 1)) across_ = 2;
        if (along_ == 1 && (rates[1] > 1 || rates[3] > 1)) along_ = 2;
        if (rates[1] == 1 && rates[3] == 1 && rates[5] == 1) along_ = 1;
        if (rates[0] == 1 && rates[2] == 1 && rates[4] == 1) across_ = 1;
    }

    SurfacePattern make() {
        for (int k = 0; k < 4; ++k) addEdge(k);
        if (along_ == 1) {
            join(edge(0, false), edge(2, true));
        } else if (across_ == 1) {
            join(edge(1, false), edge(3, true));
        } else {
            addInside();
            for (int k = 0; k < 4; ++k) addCorner(k);
            join(side(0), row(1));
            join(side(1), column(across_ - 1));
            join(side(2), reversed(row(along_ - 1)));
            join(side(3), reversed(column(1)));
        }
        return std::move(out_);
    }

  private:
    /// Points from left to right as seen from the first row, each with its place along it.
    using Chain = std::vector<std::pair<double, int>>;

    void addEdge(int k) {
        const int rate = rates_[at(k)];
        first_[at(k)] = static_cast<int>(out_.coords.size());
        for (int i = 0; i < rate; ++i) {
            const double t = static_cast<double>(i) / rate;
            const std::array<Vec2, 4> on{Vec2(t, 0), Vec2(1, t), Vec2(1 - t, 1), Vec2(0, 1 - t)};
            out_.coords.push_back(on[at(k)]);
        }
    }

    Chain edge(int k, bool backwards) const {
        const int rate = rates_[at(k)];
        Chain out;
        for (int i = 0; i <= rate; ++i) {
            const int id = i < rate ? first_[at(k)] + i : first_[at((k + 1) % 4)];
            out.emplace_back(static_cast<double>(i) / rate, id);
        }
        return backwards ? reversed(out) : out;
    }

    /// Edge k without the ends that are parts of corners' quadrangles.
    Chain side(int k) const {
        Chain out = edge(k, false);
        if (cornered_[at((k + 1) % 4)]) out.pop_back();
        if (cornered_[at(k)]) out.erase(out.begin());
        return out;
    }

    /// A quadrangle between a corner and the point inside that is next to it, where it is convex.
    void addCorner(int k) {
        const int before = (k + 3) % 4;
        const double here = rates_[at(k)];
        const double there = rates_[at(before)];
        const double pieces =
            k % 2 == 0 ? here / across_ + there / along_ : here / along_ + there / across_;
        constexpr double kConvex = 1.2;
        if (here < 2 || there < 2 || pieces < kConvex) return;
        cornered_[at(k)] = true;
        const std::array<int, 4> next{inner(1, 1), inner(across_ - 1, 1),
                                      inner(across_ - 1, along_ - 1), inner(1, along_ - 1)};
        out_.facets.push_back({first_[at(k)], first_[at(k)] + 1, next[at(k)],
                               first_[at(before)] + rates_[at(before)] - 1});
    }

    static Chain reversed(Chain chain) {
        std::reverse(chain.begin(), chain.end());
        for (auto& [t, id] : chain) t = 1.0 - t;
        return chain;
    }

    int inner(int i, int k) const { return inside_ + (i - 1) + (across_ - 1) * (k - 1); }
    Chain row(int k) const {
        Chain out;
        for (int i = 1; i < across_; ++i)
            out.emplace_back(static_cast<double>(i) / across_, inner(i, k));
        return out;
    }
    Chain column(int i) const {
        Chain out;
        for (int k = 1; k < along_; ++k)
            out.emplace_back(static_cast<double>(k) / along_, inner(i, k));
        return out;
    }

    void addInside() {
        inside_ = static_cast<int>(out_.coords.size());
        for (int k = 1; k < along_; ++k) {
            for (int i = 1; i < across_; ++i) {
                out_.coords.emplace_back(static_cast<double>(i) / across_,
                                         static_cast<double>(k) / along_);
            }
        }
        for (int k = 1; k + 1 < along_; ++k) {
            for (int i = 1; i + 1 < across_; ++i) {
                out_.facets.push_back(
                    {inner(i, k), inner(i + 1, k), inner(i + 1, k + 1), inner(i, k + 1)});
            }
        }
    }

    /// Facets between two chains that run the same way, the second one on the left. Where a step
    /// along one of them follows one along the other, the two make a quadrangle, so that the
    /// better diagonal can be chosen.
    void join(const Chain& right, const Chain& left) {
        std::size_t r = 0;
        std::size_t l = 0;
        const auto stepsRight = [&](std::size_t i, std::size_t k) {
            return k + 1 == left.size() ||
                   (i + 1 < right.size() &&
                    right[i + 1].first + right[i].first <= left[k + 1].first + left[k].first);
        };
        while (r + 1 < right.size() || l + 1 < left.size()) {
            const bool onRight = stepsRight(r, l);
            const std::size_t nextR = onRight ? r + 1 : r;
            const std::size_t nextL = onRight ? l : l + 1;
            const bool more = nextR + 1 < right.size() || nextL + 1 < left.size();
            if (more && stepsRight(nextR, nextL) != onRight) {
                out_.facets.push_back(
                    {right[r].second, right[r + 1].second, left[l + 1].second, left[l].second});
                ++r;
                ++l;
                continue;
            }
            const int tip = onRight ? right[nextR].second : left[nextL].second;
            out_.facets.push_back({right[r].second, tip, left[l].second, -1});
            r = nextR;
            l = nextL;
        }
    }

    const std::vector<int>& rates_;
    int across_;
    int along_;
    int inside_ = 0;
    std::array<int, 4> first_{};
    std::array<bool, 4> cornered_{};
    SurfacePattern out_;
};

/// A polygon as triangles round its middle.
SurfacePattern fanPattern(const Parameterization& face) {
    SurfacePattern out;
    const int n = face.GetFaceSize();
    for (int k = 0; k < n; ++k) {
        Vec2 uv;
        face.GetVertexCoord(k, uv.data());
        out.coords.push_back(uv);
        out.facets.push_back({k, (k + 1) % n, n, -1});
    }
    Vec2 middle;
    face.GetCenterCoord(middle.data());
    out.coords.push_back(middle);
    return out;
}

}  // namespace

SurfacePattern uniformPattern(const Parameterization& face, int levels) {
    const int rate = 1 << levels;
    switch (face.GetType()) {
        case Parameterization::QUAD:
            return quadPattern(rate);
        case Parameterization::TRI:
            return trianglePattern(rate);
        default:
            return levels == 0 ? fanPattern(face) : PolygonPattern(face, rate).make();
    }
}

SurfacePattern adaptivePattern(const Parameterization& face, const std::vector<int>& rates) {
    if (face.GetType() == Parameterization::QUAD) return StitchedPattern(rates).make();
    Tessellation::Options options;
    options.SetFacetSize(3);
    const Tessellation tessellation(face, static_cast<int>(rates.size()), rates.data(), options);
    SurfacePattern out;
    const int count = tessellation.GetNumCoords();
    std::vector<double> uv(2 * at(count));
    tessellation.GetCoords(uv.data());
    for (int i = 0; i < count; ++i) out.coords.emplace_back(uv[2 * at(i)], uv[2 * at(i) + 1]);
    std::vector<int> facets(3 * at(tessellation.GetNumFacets()));
    tessellation.GetFacets(facets.data());
    for (std::size_t i = 0; i + 2 < facets.size(); i += 3) {
        out.facets.push_back({facets[i], facets[i + 1], facets[i + 2], -1});
    }
    return out;
}

}  // namespace ew
