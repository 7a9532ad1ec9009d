// SPDX-License-Identifier: GPL-3.0-or-later
// The exact text form: only points and the loops of the faces. The triangles follow from them.
//
//   edgewright-solid 1
//   vertices N
//   x y z                       a double in its shortest form, or a fraction n/d
//   faces F
//   loops n i i i ... n i i i   counts and vertex indices, outer loop first
#include "core/solid/serialize.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "core/base/tolerance.h"
#include "core/solid/assemble.h"

namespace ew {
namespace {

constexpr std::string_view kMagic = "edgewright-solid";
constexpr std::size_t kMaxDigits = 100'000;  // far beyond what any solid here needs

std::string exactText(const Rational& x) {
    const double d = CGAL::to_double(x);
    if (Rational(d) == x) {
        char buffer[32];
        const auto end = std::to_chars(buffer, buffer + sizeof(buffer), d == 0.0 ? 0.0 : d);
        return {buffer, end.ptr};
    }
    return x.get_num().get_str() + "/" + x.get_den().get_str();
}

/// Words of a text, one after the other; remembers the line for messages.
class Words {
  public:
    explicit Words(std::string_view text) : text_(text) {}

    std::string_view next() {
        while (at_ < text_.size() && isSpace(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
        const std::size_t begin = at_;
        while (at_ < text_.size() && !isSpace(text_[at_])) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    std::size_t left() const { return text_.size() - at_; }
    Unexpected<Error> bad(const std::string& what) const {
        return fail(Errc::BadValue, "Solid, line " + std::to_string(line_) + ": " + what + ".");
    }

  private:
    static bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

bool allDigits(std::string_view s) {
    if (s.empty() || s.size() > kMaxDigits) return false;
    for (const char c : s) {
        if (c < '0' || c > '9') return false;
    }
    return true;
}

Result<Exact> readExact(Words& words) {
    const std::string_view word = words.next();
    const std::size_t slash = word.find('/');
    if (slash == std::string_view::npos) {
        double value = 0.0;
        const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
        if (word.empty() || end.ec != std::errc() || end.ptr != word.data() + word.size()) {
            return words.bad("a coordinate is missing or no number");
        }
        if (!std::isfinite(value) || std::abs(value) > tol::kMaxCoordinateMm) {
            return words.bad("a coordinate is out of range");
        }
        return Exact(value);
    }
    std::string_view top = word.substr(0, slash);
    const std::string_view bottom = word.substr(slash + 1);
    const bool negative = !top.empty() && top[0] == '-';
    if (negative) top.remove_prefix(1);
    if (!allDigits(top) || !allDigits(bottom)) return words.bad("a fraction is malformed");
    const mpz_class n{std::string(top), 10};
    const mpz_class d{std::string(bottom), 10};
    if (d == 0) return words.bad("a fraction has the denominator 0");
    Rational value(n, d);
    value.canonicalize();
    if (value > Rational(tol::kMaxCoordinateMm)) return words.bad("a coordinate is out of range");
    if (negative) value = -value;
    return Exact(value);
}

/// A count or index below `limit`.
Result<std::size_t> readCount(Words& words, std::size_t limit, const std::string& what) {
    const std::string_view word = words.next();
    std::size_t value = 0;
    const auto end = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || end.ec != std::errc() || end.ptr != word.data() + word.size()) {
        return words.bad("the " + what + " is missing or no whole number");
    }
    if (value >= limit) return words.bad("the " + what + " is too large");
    return value;
}

Result<void> expectWord(Words& words, std::string_view wanted) {
    if (words.next() == wanted) return {};
    std::string text = "the word ";
    text.append(wanted).append(" is missing");
    return words.bad(text);
}

Result<FaceLoops> readFace(Words& words, std::size_t points) {
    auto loopCount = readCount(words, words.left(), "number of loops");
    if (!loopCount) return fail(loopCount.error());
    FaceLoops loops;
    for (std::size_t l = 0; l < *loopCount; ++l) {
        auto count = readCount(words, words.left(), "number of indices");
        if (!count) return fail(count.error());
        loops.emplace_back();
        for (std::size_t k = 0; k < *count; ++k) {
            auto index = readCount(words, points, "vertex index");
            if (!index) return fail(index.error());
            loops.back().push_back(static_cast<int>(*index));
        }
    }
    return loops;
}

Result<ExactBrep> readBrep(std::string_view text) {
    Words words(text);
    if (words.next() != kMagic) return fail(Errc::WrongFormat, "This text holds no solid.");
    if (words.next() != "1") {
        return fail(Errc::WrongVersion, "The solid was written by a newer version.");
    }
    ExactBrep brep;
    if (auto ok = expectWord(words, "vertices"); !ok) return fail(ok.error());
    // Every coordinate takes two bytes or more, so a count beyond what is left is a lie.
    auto pointCount = readCount(words, words.left() / 2, "number of vertices");
    if (!pointCount) return fail(pointCount.error());
    for (std::size_t i = 0; i < *pointCount; ++i) {
        std::array<Exact, 3> p;
        for (Exact& x : p) {
            auto value = readExact(words);
            if (!value) return fail(value.error());
            x = *value;
        }
        brep.points.emplace_back(p[0], p[1], p[2]);
    }
    if (auto ok = expectWord(words, "faces"); !ok) return fail(ok.error());
    auto faceCount = readCount(words, words.left() / 2, "number of faces");
    if (!faceCount) return fail(faceCount.error());
    for (std::size_t f = 0; f < *faceCount; ++f) {
        auto face = readFace(words, *pointCount);
        if (!face) return fail(face.error());
        brep.faces.push_back(std::move(*face));
    }
    if (!words.next().empty()) return words.bad("text after the last face");
    return brep;
}

}  // namespace

std::string textOf(const Solid::Impl& solid) {
    const ExactMesh& surface = solid.surface;
    std::string out(kMagic);
    out.append(" 1\nvertices ").append(std::to_string(solid.vertices.size())).append("\n");
    for (const auto v : surface.mesh.vertices()) {
        const auto& e = CGAL::exact(surface.point(v));
        out.append(exactText(e.x())).append(" ").append(exactText(e.y()));
        out.append(" ").append(exactText(e.z())).append("\n");
    }
    out.append("faces ").append(std::to_string(solid.faces.size())).append("\n");
    for (const SolidFace& face : solid.faces) {
        out.append(std::to_string(face.loops.size()));
        for (const std::vector<int>& loop : face.loops) {
            out.append(" ").append(std::to_string(loop.size()));
            for (const int i : loop) out.append(" ").append(std::to_string(i));
        }
        out.append("\n");
    }
    return out;
}

Result<Solid> Solid::deserialize(const std::string& text) {
    try {
        auto brep = readBrep(text);
        if (!brep) return fail(brep.error());
        auto impl = assemble(std::move(*brep));
        if (!impl) return fail(impl.error());
        return Solid(std::move(*impl));
    } catch (const std::exception& e) {
        return fail(Errc::Internal, std::string("The solid could not be read: ") + e.what());
    }
}

}  // namespace ew
