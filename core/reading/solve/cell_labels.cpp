// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/cell_labels.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <map>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using FlowGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, long,
                    boost::property<boost::vertex_color_t, boost::default_color_type,
                                    boost::property<boost::vertex_distance_t, long,
                                                    boost::property<boost::vertex_predecessor_t,
                                                                    Traits::edge_descriptor>>>>,
    boost::property<
        boost::edge_capacity_t, double,
        boost::property<boost::edge_residual_capacity_t, double,
                        boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;

/// Per cell: is it solid?
/// \param filling  what a cell costs that is not solid, as a share of its surface.
std::vector<bool> leastSurface(const CellComplex& complex, const std::vector<CellVotes>& votes,
                               double filling) {
    // So much less than what is seen does area weigh that is not.
    constexpr double kAreaShare = 0.02;
    const std::size_t n = votes.size();
    FlowGraph graph(n + 2);
    const auto source = static_cast<Traits::vertex_descriptor>(n);
    const auto sink = static_cast<Traits::vertex_descriptor>(n + 1);
    auto capacity = boost::get(boost::edge_capacity, graph);
    auto reverse = boost::get(boost::edge_reverse, graph);
    const auto connect = [&](Traits::vertex_descriptor a, Traits::vertex_descriptor b, double forth,
                             double back) {
        const auto e = boost::add_edge(a, b, graph).first;
        const auto r = boost::add_edge(b, a, graph).first;
        capacity[e] = forth;
        capacity[r] = back;
        reverse[e] = r;
        reverse[r] = e;
    };
    for (std::size_t c = 0; c < n; ++c) {
        connect(source, c, votes[c].solid, 0.0);
        connect(c, sink, votes[c].empty, 0.0);
    }
    constexpr double kSure = 1e12;
    for (std::size_t f = 0; f < complex.facets().size(); ++f) {
        const auto& cells = complex.facets()[f].cells;
        if (cells[0] < 0 || cells[1] < 0) {
            connect(at(std::max(cells[0], cells[1])), sink, kSure, 0.0);  // the border of the box
            continue;
        }
        const double area = kAreaShare * complex.area(static_cast<int>(f));
        connect(at(cells[0]), at(cells[1]), area, area);
        for (const int c : cells) connect(source, at(c), filling * area, 0.0);
    }
    boost::boykov_kolmogorov_max_flow(graph, source, sink);
    const auto color = boost::get(boost::vertex_color, graph);
    std::vector<bool> solid(n);
    const auto black = boost::color_traits<boost::default_color_type>::black();
    for (std::size_t c = 0; c < n; ++c) solid[c] = color[c] == black;
    return solid;
}

/// Makes what is not seen simpler.
class Simpler {
  public:
    Simpler(const CellComplex& complex, const std::vector<CellVotes>& votes)
        : complex_(complex),
          edgesOf_(votes.size()),
          neighbours_(votes.size()),
          unseen_(votes.size()),
          mark_(votes.size(), 0) {
        for (std::size_t c = 0; c < votes.size(); ++c) unseen_[c] = votes[c].unseen();
        std::map<std::array<int, 2>, std::size_t> number;
        for (std::size_t f = 0; f < complex.facets().size(); ++f) {
            const CellComplex::Facet& facet = complex.facets()[f];
            if (facet.cells[0] < 0 || facet.cells[1] < 0) {
                unseen_[at(std::max(facet.cells[0], facet.cells[1]))] = false;  // outside
                continue;
            }
            neighbours_[at(facet.cells[0])].push_back(facet.cells[1]);
            neighbours_[at(facet.cells[1])].push_back(facet.cells[0]);
            for (std::size_t k = 0; k < facet.loop.size(); ++k) {
                const int v = facet.loop[k];
                const int w = facet.loop[(k + 1) % facet.loop.size()];
                const auto [it, isNew] = number.emplace(
                    std::array<int, 2>{std::min(v, w), std::max(v, w)}, edges_.size());
                if (isNew) {
                    edges_.push_back(
                        {(complex.vertices()[at(v)] - complex.vertices()[at(w)]).norm(), {}, 0});
                }
                edges_[it->second].facets.push_back(static_cast<int>(f));
            }
        }
        for (std::size_t e = 0; e < edges_.size(); ++e) {
            for (const int f : edges_[e].facets) {
                for (const int c : complex.facets()[at(f)].cells) {
                    std::vector<std::size_t>& list = edgesOf_[at(c)];
                    if (list.empty() || list.back() != e) list.push_back(e);
                }
            }
        }
    }

    void improve(std::vector<bool>& solid) {
        constexpr int kRounds = 2;
        bool better = true;
        for (int round = 0; round < kRounds && better; ++round) {
            better = false;
            for (std::size_t p = 0; p < complex_.planes().size(); ++p) {
                for (const bool positive : {false, true}) {
                    for (const bool label : {false, true}) {
                        better = tryAll(p, positive, label, solid) || better;
                    }
                }
            }
        }
    }

  private:
    struct Edge {
        double length = 0.0;
        std::vector<int> facets;
        int mark = 0;
    };

    /// Length of an edge at which the surface bends; four faces at an edge are no solid.
    double cost(const Edge& e, const std::vector<bool>& solid) const {
        constexpr double kNoSolid = 10.0;
        int faces = 0;
        int plane = -1;
        bool bends = false;
        for (const int f : e.facets) {
            const CellComplex::Facet& facet = complex_.facets()[at(f)];
            if (solid[at(facet.cells[0])] == solid[at(facet.cells[1])]) continue;
            bends = bends || (faces > 0 && facet.plane != plane);
            plane = facet.plane;
            ++faces;
        }
        return (bends ? e.length : 0.0) + (faces > 2 ? kNoSolid * e.length : 0.0);
    }

    double cost(const std::vector<int>& cells, const std::vector<bool>& solid) {
        ++stamp_;
        double sum = 0.0;
        for (const int c : cells) {
            for (const std::size_t e : edgesOf_[at(c)]) {
                if (edges_[e].mark == stamp_) continue;
                edges_[e].mark = stamp_;
                sum += cost(edges_[e], solid);
            }
        }
        return sum;
    }

    /// Each connected group of unseen cells on one side of a plane that is not labelled so.
    bool tryAll(std::size_t plane, bool positive, bool label, std::vector<bool>& solid) {
        const int visit = ++visits_;
        const auto fits = [&](int c) {
            return unseen_[at(c)] && mark_[at(c)] != visit && solid[at(c)] != label &&
                   complex_.isPositive(c, plane) == positive;
        };
        bool better = false;
        for (int c = 0; c < complex_.cellCount(); ++c) {
            if (!fits(c)) continue;
            std::vector<int> group{c};
            mark_[at(c)] = visit;
            for (std::size_t i = 0; i < group.size(); ++i) {
                for (const int n : neighbours_[at(group[i])]) {
                    if (!fits(n)) continue;
                    mark_[at(n)] = visit;
                    group.push_back(n);
                }
            }
            const double before = cost(group, solid);
            for (const int g : group) solid[at(g)] = label;
            if (cost(group, solid) < before * (1.0 - 1e-9)) {
                better = true;
                continue;
            }
            for (const int g : group) solid[at(g)] = !label;
        }
        return better;
    }

    const CellComplex& complex_;
    std::vector<Edge> edges_;
    std::vector<std::vector<std::size_t>> edgesOf_;  ///< per cell
    std::vector<std::vector<int>> neighbours_;       ///< per cell
    std::vector<bool> unseen_;                       ///< per cell: not seen, and not at the border
    std::vector<int> mark_;
    int visits_ = 0;
    int stamp_ = 0;
};

}  // namespace

std::vector<std::vector<bool>> cellLabels(const CellComplex& complex,
                                          const std::vector<CellVotes>& votes) {
    std::vector<std::vector<bool>> out;
    const auto add = [&](const std::vector<bool>& solid) {
        if (std::find(out.begin(), out.end(), solid) == out.end()) out.push_back(solid);
    };
    Simpler simpler(complex, votes);
    for (const double filling : {0.0, 0.1, 0.3, 1.0}) {
        std::vector<bool> solid = leastSurface(complex, votes, filling);
        add(solid);
        simpler.improve(solid);
        add(solid);
    }
    return out;
}

}  // namespace ew
