// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "core/base/tolerance.h"
#include "core/solid/solid.h"
#include "core/tlib/template_io.h"

namespace ew {
namespace {

constexpr std::size_t kMaxIdLength = 64;
constexpr std::size_t kMaxTextLength = 500;
constexpr std::size_t kMaxTags = 32;
constexpr std::size_t kMaxLanguages = 64;

/// Makes the error of a failed check at a JSON path of a source.
class Checker {
  public:
    explicit Checker(std::string source) : source_(std::move(source)) {}
    Unexpected<Error> bad(const std::string& path, const std::string& text) const {
        return fail(Errc::BadTemplate, source_ + ": " + path + ": " + text);
    }

  private:
    std::string source_;
};

std::string at(const std::string& path, std::size_t index) {
    return path + "/" + std::to_string(index);
}

std::string edgeName(const TemplateEdge& e) {
    return std::to_string(e[0]) + "-" + std::to_string(e[1]);
}

Result<void> checkId(const Checker& check, const std::string& path, const std::string& id) {
    const bool ok =
        !id.empty() && id.size() <= kMaxIdLength && std::all_of(id.begin(), id.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
        });
    if (ok) return {};
    return check.bad(path, "an id has 1 to 64 characters out of a-z, 0-9 and -.");
}

Result<void> checkText(const Checker& check, const std::string& path, const std::string& text) {
    if (text.size() > kMaxTextLength) {
        return check.bad(path, "longer than " + std::to_string(kMaxTextLength) + " bytes.");
    }
    const bool control = std::any_of(text.begin(), text.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    });
    if (control) return check.bad(path, "holds a control character.");
    return {};
}

/// "de", "pt-BR", "zh-Hant"
bool isLanguage(const std::string& code) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::size_t i = 0;
    while (i < code.size() && code[i] >= 'a' && code[i] <= 'z') ++i;
    if (i < 2 || i > 3) return false;
    if (i == code.size()) return true;
    const std::string rest = code.substr(i + 1);
    return code[i] == '-' && rest.size() >= 2 && rest.size() <= 8 &&
           std::all_of(rest.begin(), rest.end(),
                       [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

Result<void> checkAbout(const Checker& check, const TemplateAbout& about) {
    if (auto ok = checkText(check, "/category", about.category); !ok) return ok;
    if (auto ok = checkText(check, "/author", about.author); !ok) return ok;
    if (auto ok = checkText(check, "/licence", about.licence); !ok) return ok;
    if (auto ok = checkText(check, "/template_version", about.version); !ok) return ok;
    if (about.tags.size() > kMaxTags) {
        return check.bad("/tags", "a template has at most " + std::to_string(kMaxTags) + " tags.");
    }
    for (std::size_t i = 0; i < about.tags.size(); ++i) {
        const std::string path = at("/tags", i);
        const std::string& tag = about.tags[i];
        if (tag.empty()) return check.bad(path, "a tag has a letter at least.");
        if (auto ok = checkText(check, path, tag); !ok) return ok;
        const auto here = about.tags.begin() + static_cast<std::ptrdiff_t>(i);
        if (std::find(about.tags.begin(), here, tag) != here) {
            return check.bad(path, "\"" + tag + "\" stands twice.");
        }
    }
    if (about.inLanguage.size() > kMaxLanguages) {
        return check.bad("/languages", "a template speaks at most " +
                                           std::to_string(kMaxLanguages) + " languages.");
    }
    for (const auto& [code, words] : about.inLanguage) {
        const std::string path = "/languages/" + code;
        if (!isLanguage(code)) {
            return check.bad(path, "a language is a code such as \"de\" or \"pt-BR\".");
        }
        if (words.name.empty() && words.description.empty()) {
            return check.bad(path, "says nothing.");
        }
        if (auto ok = checkText(check, path + "/name", words.name); !ok) return ok;
        if (auto ok = checkText(check, path + "/description", words.description); !ok) return ok;
    }
    return {};
}

Result<void> checkNames(const Checker& check, const Template& t) {
    if (auto ok = checkId(check, "/id", t.id); !ok) return ok;
    if (t.name.empty()) return check.bad("/name", "a template needs a name.");
    if (auto ok = checkText(check, "/name", t.name); !ok) return ok;
    if (auto ok = checkText(check, "/description", t.description); !ok) return ok;
    if (auto ok = checkAbout(check, t.about); !ok) return ok;
    // Candidates name their reading; these two names are taken by the program itself.
    std::set<std::string> seen{"default", "oblique"};
    for (std::size_t i = 0; i < t.readings.size(); ++i) {
        const std::string path = at("/readings", i);
        if (auto ok = checkId(check, path + "/id", t.readings[i].id); !ok) return ok;
        if (!seen.insert(t.readings[i].id).second) {
            return check.bad(path + "/id", "\"" + t.readings[i].id + "\" is taken.");
        }
        if (t.readings[i].name.empty()) return check.bad(path + "/name", "a reading needs a name.");
        if (auto ok = checkText(check, path + "/name", t.readings[i].name); !ok) return ok;
    }
    return {};
}

// Shape -------------------------------------------------------------------------------------------

Result<void> checkVertices(const Checker& check, const PolyhedronSpec& shape) {
    const std::size_t n = shape.vertices.size();
    if (n < 4 || n > kMaxTemplateVertices) {
        return check.bad("/vertices", "a template has 4 to " +
                                          std::to_string(kMaxTemplateVertices) + " vertices, not " +
                                          std::to_string(n) + ".");
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3& p = shape.vertices[i];
        if (!p.allFinite() || p.cwiseAbs().maxCoeff() > tol::kMaxCoordinateMm) {
            return check.bad(at("/vertices", i), "coordinates must be finite and at most 1000000.");
        }
    }
    return {};
}

/// Indices, closedness and orientation. Fills `left`: the face on the left of each directed edge.
Result<void> checkFaces(const Checker& check, const PolyhedronSpec& shape,
                        std::map<TemplateEdge, int>& left) {
    const int n = static_cast<int>(shape.vertices.size());
    std::vector<bool> used(shape.vertices.size(), false);
    if (shape.faces.size() < 4) return check.bad("/faces", "a solid has at least 4 faces.");
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const std::vector<int>& face = shape.faces[f];
        const std::string path = at("/faces", f);
        if (face.size() < 3) return check.bad(path, "a face has at least 3 vertices.");
        for (std::size_t k = 0; k < face.size(); ++k) {
            if (face[k] < 0 || face[k] >= n) {
                return check.bad(at(path, k), "vertex " + std::to_string(face[k]) +
                                                  " does not exist; there are " +
                                                  std::to_string(n) + " vertices.");
            }
            if (std::count(face.begin(), face.end(), face[k]) > 1) {
                return check.bad(at(path, k), "vertex " + std::to_string(face[k]) +
                                                  " stands twice in one face.");
            }
            used[static_cast<std::size_t>(face[k])] = true;
            const TemplateEdge e{face[k], face[(k + 1) % face.size()]};
            const auto [it, fresh] = left.emplace(e, static_cast<int>(f));
            if (!fresh) {
                return check.bad(at(path, k), "edge " + edgeName(e) +
                                                  " runs the same way in face " +
                                                  std::to_string(it->second) +
                                                  "; one of the two is inside out.");
            }
        }
    }
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) return check.bad(at("/vertices", i), "no face uses this vertex.");
    }
    for (const auto& [e, f] : left) {
        if (!left.contains({e[1], e[0]})) {
            return check.bad(at("/faces", static_cast<std::size_t>(f)),
                             "edge " + edgeName(e) + " has no face on its other side; not closed.");
        }
    }
    return {};
}

/// One fan of faces round every vertex, and one piece.
Result<void> checkManifold(const Checker& check, const PolyhedronSpec& shape,
                           const std::map<TemplateEdge, int>& left) {
    std::map<TemplateEdge, int> before;  // directed edge -> vertex before it in the same face
    std::vector<int> degree(shape.vertices.size(), 0);
    for (const auto& face : shape.faces) {
        for (std::size_t k = 0; k < face.size(); ++k) {
            before[{face[k], face[(k + 1) % face.size()]}] =
                face[(k + face.size() - 1) % face.size()];
            ++degree[static_cast<std::size_t>(face[k])];
        }
    }
    std::vector<bool> seen(shape.vertices.size(), false);
    for (const auto& entry : left) {
        const TemplateEdge& e = entry.first;
        const auto v = static_cast<std::size_t>(e[0]);
        if (seen[v]) continue;
        seen[v] = true;
        int steps = 0;
        int to = e[1];
        do {
            to = before.at({e[0], to});
            ++steps;
        } while (to != e[1]);
        if (steps != degree[v]) {
            return check.bad(at("/vertices", v),
                             "two parts of the surface touch in this vertex only.");
        }
    }
    std::vector<int> pending{shape.faces[0][0]};
    std::vector<bool> reached(shape.vertices.size(), false);
    reached[static_cast<std::size_t>(pending[0])] = true;
    while (!pending.empty()) {
        const int v = pending.back();
        pending.pop_back();
        for (auto it = left.lower_bound({v, 0}); it != left.end() && it->first[0] == v; ++it) {
            const auto to = static_cast<std::size_t>(it->first[1]);
            if (!reached[to]) pending.push_back(it->first[1]);
            reached[to] = true;
        }
    }
    const auto lost = std::find(reached.begin(), reached.end(), false);
    if (lost == reached.end()) return {};
    return check.bad(at("/vertices", static_cast<std::size_t>(lost - reached.begin())),
                     "not connected to vertex " + std::to_string(shape.faces[0][0]) + ".");
}

double sizeOf(const PolyhedronSpec& shape) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : shape.vertices) box.extend(p);
    return box.diagonal().norm();
}

Result<void> checkGeometry(const Checker& check, const PolyhedronSpec& shape,
                           const std::map<TemplateEdge, int>& left) {
    const double size = sizeOf(shape);
    if (size < tol::kMinSizeMm) return check.bad("/vertices", "the shape is too small.");
    const auto vertex = [&](int i) -> const Vec3& {
        return shape.vertices[static_cast<std::size_t>(i)];
    };
    for (const auto& [e, f] : left) {
        if ((vertex(e[1]) - vertex(e[0])).norm() <= tol::kPlanarRelative * size) {
            return check.bad(at("/faces", static_cast<std::size_t>(f)),
                             "edge " + edgeName(e) + " has no length.");
        }
    }
    std::vector<Vec3> normals;
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        const auto& face = shape.faces[f];
        Vec3 center = Vec3::Zero();
        Vec3 normal = Vec3::Zero();
        for (const int i : face) center += vertex(i) / static_cast<double>(face.size());
        for (std::size_t k = 0; k < face.size(); ++k) {
            normal +=
                (vertex(face[k]) - center).cross(vertex(face[(k + 1) % face.size()]) - center);
        }
        if (normal.norm() <= tol::kPlanarRelative * size * size) {
            return check.bad(at("/faces", f), "the face has no area.");
        }
        normal.normalize();
        for (std::size_t k = 0; k < face.size(); ++k) {
            if (std::abs((vertex(face[k]) - center).dot(normal)) > tol::kPlanarRelative * size) {
                return check.bad(at(at("/faces", f), k),
                                 "vertex " + std::to_string(face[k]) + " is off the face's plane.");
            }
        }
        normals.push_back(normal);
    }
    for (const auto& [e, f] : left) {
        const auto g = static_cast<std::size_t>(left.at({e[1], e[0]}));
        const Vec3& a = normals[static_cast<std::size_t>(f)];
        if (a.dot(normals[g]) > 0 && a.cross(normals[g]).norm() < tol::kTemplateMinFold) {
            return check.bad(at("/faces", g), "lies in one plane with face " + std::to_string(f) +
                                                  "; make them one face.");
        }
    }
    if (auto solid = Solid::fromSpec(shape); !solid) {
        return check.bad("/faces", solid.error().message);
    }
    return {};
}

// Relations ---------------------------------------------------------------------------------------

/// Sets of edges that are parallel, each edge with its sense in its set.
class ParallelSets {
  public:
    explicit ParallelSets(const std::map<TemplateEdge, int>& left) {
        for (const auto& entry : left) {
            if (entry.first[0] < entry.first[1])
                index_[entry.first] = static_cast<int>(index_.size());
        }
        parent_.resize(index_.size());
        std::iota(parent_.begin(), parent_.end(), 0);
        flipped_.assign(index_.size(), false);
    }

    bool known(const TemplateEdge& e) const { return index_.contains(ordered(e)); }

    struct Sense {
        int set;
        bool flipped;
    };
    Sense find(const TemplateEdge& e) const {
        int i = index_.at(ordered(e));
        bool flip = e[0] > e[1];
        while (parent_[static_cast<std::size_t>(i)] != i) {
            flip ^= flipped_[static_cast<std::size_t>(i)];
            i = parent_[static_cast<std::size_t>(i)];
        }
        return {i, flip};
    }

    /// False where the two were parallel already, in the opposite sense.
    bool join(const TemplateEdge& a, const TemplateEdge& b) {
        const Sense x = find(a);
        const Sense y = find(b);
        if (x.set == y.set) return x.flipped == y.flipped;
        parent_[static_cast<std::size_t>(x.set)] = y.set;
        flipped_[static_cast<std::size_t>(x.set)] = x.flipped != y.flipped;
        return true;
    }

  private:
    static TemplateEdge ordered(const TemplateEdge& e) {
        return {std::min(e[0], e[1]), std::max(e[0], e[1])};
    }
    std::map<TemplateEdge, int> index_;
    std::vector<int> parent_;
    std::vector<bool> flipped_;
};

/// The edges of one entry exist and come once.
template <class Edges>
Result<void> checkEdges(const Checker& check, const std::string& path, const Edges& edges,
                        const ParallelSets& sets) {
    if (edges.size() < 2) return check.bad(path, "at least two edges are needed.");
    std::set<TemplateEdge> seen;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const TemplateEdge& e = edges[i];
        if (!sets.known(e)) {
            return check.bad(at(path, i), "there is no edge " + edgeName(e) + ".");
        }
        if (!seen.insert({std::min(e[0], e[1]), std::max(e[0], e[1])}).second) {
            return check.bad(at(path, i), "edge " + edgeName(e) + " stands twice.");
        }
    }
    return {};
}

/// Adds the parallel classes to `sets`; contradictions among the relations by themselves.
Result<void> checkConsistent(const Checker& check, const std::string& path,
                             const TemplateRelations& r, ParallelSets& sets) {
    for (std::size_t c = 0; c < r.parallel.size(); ++c) {
        const std::string here = at(path + "/parallel", c);
        if (auto ok = checkEdges(check, here, r.parallel[c], sets); !ok) return ok;
        for (std::size_t i = 1; i < r.parallel[c].size(); ++i) {
            if (!sets.join(r.parallel[c][0], r.parallel[c][i])) {
                return check.bad(at(here, i), "edge " + edgeName(r.parallel[c][i]) +
                                                  " runs against its own class.");
            }
        }
    }
    for (std::size_t c = 0; c < r.perpendicular.size(); ++c) {
        const std::string here = at(path + "/perpendicular", c);
        if (auto ok = checkEdges(check, here, r.perpendicular[c], sets); !ok) return ok;
    }
    for (std::size_t c = 0; c < r.equalLength.size(); ++c) {
        const std::string here = at(path + "/equal_length", c);
        if (auto ok = checkEdges(check, here, r.equalLength[c], sets); !ok) return ok;
    }
    return {};
}

/// No perpendicular pair within one parallel set, no two edges of one corner in one set.
Result<void> checkNotParallel(const Checker& check, const std::string& path,
                              const TemplateRelations& r, const ParallelSets& sets) {
    for (std::size_t c = 0; c < r.perpendicular.size(); ++c) {
        const auto& [a, b] = r.perpendicular[c];
        if (sets.find(a).set == sets.find(b).set) {
            return check.bad(at(path + "/perpendicular", c),
                             "edges " + edgeName(a) + " and " + edgeName(b) +
                                 " are parallel too; they cannot be both.");
        }
    }
    return {};
}

/// The relations hold for the reference shape.
Result<void> checkHold(const Checker& check, const TemplateRelations& r, const PolyhedronSpec& s) {
    const auto vec = [&](const TemplateEdge& e) -> Vec3 {
        return s.vertices[static_cast<std::size_t>(e[1])] -
               s.vertices[static_cast<std::size_t>(e[0])];
    };
    for (std::size_t c = 0; c < r.parallel.size(); ++c) {
        const Vec3 a = vec(r.parallel[c][0]).normalized();
        for (std::size_t i = 1; i < r.parallel[c].size(); ++i) {
            const Vec3 b = vec(r.parallel[c][i]).normalized();
            const std::string here = at(at("/relations/parallel", c), i);
            const std::string name = "edge " + edgeName(r.parallel[c][i]);
            if (a.cross(b).norm() > tol::kTemplateRelation) {
                return check.bad(here, name + " of the reference shape is not parallel to edge " +
                                           edgeName(r.parallel[c][0]) + ".");
            }
            if (a.dot(b) < 0) {
                return check.bad(here, name + " runs against edge " + edgeName(r.parallel[c][0]) +
                                           "; name its vertices the other way round.");
            }
        }
    }
    for (std::size_t c = 0; c < r.perpendicular.size(); ++c) {
        const auto& [a, b] = r.perpendicular[c];
        if (std::abs(vec(a).normalized().dot(vec(b).normalized())) > tol::kTemplateRelation) {
            return check.bad(at("/relations/perpendicular", c),
                             "edges " + edgeName(a) + " and " + edgeName(b) +
                                 " of the reference shape are not perpendicular.");
        }
    }
    const double slack = tol::kTemplateRelation * sizeOf(s);
    for (std::size_t c = 0; c < r.equalLength.size(); ++c) {
        const double length = vec(r.equalLength[c][0]).norm();
        for (std::size_t i = 1; i < r.equalLength[c].size(); ++i) {
            if (std::abs(vec(r.equalLength[c][i]).norm() - length) > slack) {
                return check.bad(at(at("/relations/equal_length", c), i),
                                 "edge " + edgeName(r.equalLength[c][i]) +
                                     " of the reference shape is not as long as edge " +
                                     edgeName(r.equalLength[c][0]) + ".");
            }
        }
    }
    return {};
}

}  // namespace

Result<void> checkTemplate(const Template& t, const std::string& source) {
    const Checker check(source);
    std::map<TemplateEdge, int> left;
    if (auto ok = checkNames(check, t); !ok) return ok;
    if (auto ok = checkVertices(check, t.shape); !ok) return ok;
    if (auto ok = checkFaces(check, t.shape, left); !ok) return ok;
    if (auto ok = checkManifold(check, t.shape, left); !ok) return ok;
    if (auto ok = checkGeometry(check, t.shape, left); !ok) return ok;
    ParallelSets sets(left);
    if (auto ok = checkConsistent(check, "/relations", t.relations, sets); !ok) return ok;
    if (auto ok = checkNotParallel(check, "/relations", t.relations, sets); !ok) return ok;
    if (auto ok = checkHold(check, t.relations, t.shape); !ok) return ok;
    for (std::size_t i = 0; i < t.readings.size(); ++i) {
        const std::string path = at("/readings", i) + "/relations";
        const TemplateRelations& extra = t.readings[i].relations;
        ParallelSets both = sets;
        if (auto ok = checkConsistent(check, path, extra, both); !ok) return ok;
        if (auto ok = checkNotParallel(check, path, extra, both); !ok) return ok;
        if (auto ok = checkNotParallel(check, "/relations", t.relations, both); !ok) return ok;
    }
    return {};
}

}  // namespace ew
