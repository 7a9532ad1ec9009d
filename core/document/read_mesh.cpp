// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/read_mesh.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string_view>
#include <vector>

#include "core/tlib/mesh_shape.h"

namespace ew {

namespace {

constexpr std::size_t kMostFaces = 2 * kMaxMeshPoints;
constexpr int kMostCorners = 4096;  // of a face

/// Words of one line after another.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {}

    /// False at the end.
    bool next() {
        if (rest_.empty()) return false;
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        line_ = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++number_;
        return true;
    }
    std::string_view word() {
        constexpr std::string_view kSpace = " \t\r";
        line_.remove_prefix(std::min(line_.find_first_not_of(kSpace), line_.size()));
        const std::size_t end = std::min(line_.find_first_of(kSpace), line_.size());
        const std::string_view found = line_.substr(0, end);
        line_.remove_prefix(end);
        return found;
    }
    int number() const { return number_; }
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    std::string_view line_;
    int number_ = 0;
};

std::optional<double> numberIn(std::string_view word) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<int> wholeIn(std::string_view word) {
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
}

class Reader {
  public:
    Reader(const std::string& bytes, std::string source)
        : lines_(bytes), source_(std::move(source)) {}

    Result<PolyhedronSpec> obj() {
        while (lines_.next()) {
            const std::string_view what = lines_.word();
            if (what == "v") {
                if (!addPoint()) return syntax();
            } else if (what == "f") {
                if (!addObjFace()) return syntax();
            }
            if (tooLarge()) return large();
        }
        return std::move(mesh_);
    }

    Result<PolyhedronSpec> ply() {
        if (!readHeader()) return syntax();
        if (points_ > kMaxMeshPoints || faces_ > kMostFaces) return large();
        const bool done = binary_ ? readBinary() : readText();
        if (!done) return syntax();
        return std::move(mesh_);
    }

  private:
    Unexpected<Error> syntax() const {
        return fail(Errc::Syntax, source_ + ": line " + std::to_string(lines_.number()) +
                                      ": not as a mesh file has it.");
    }
    Unexpected<Error> large() const {
        return fail(Errc::TooLarge, source_ + ": the mesh has more than " +
                                        std::to_string(kMaxMeshPoints) + " points.");
    }
    bool tooLarge() const {
        return mesh_.vertices.size() > kMaxMeshPoints || mesh_.faces.size() > kMostFaces;
    }

    bool addPoint() {
        Vec3 p;
        for (Eigen::Index k = 0; k < 3; ++k) {
            const auto value = numberIn(lines_.word());
            if (!value) return false;
            p[k] = *value;
        }
        mesh_.vertices.push_back(p);
        return true;
    }

    /// "7", "7/1", "7//3", "-1": from 1, or back from the newest.
    bool addObjFace() {
        std::vector<int> face;
        for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
            const auto index = wholeIn(word.substr(0, word.find('/')));
            if (!index || *index == 0 || face.size() >= kMostCorners) return false;
            const int count = static_cast<int>(mesh_.vertices.size());
            face.push_back(*index > 0 ? *index - 1 : count + *index);
        }
        if (face.size() < 3) return false;
        mesh_.faces.push_back(std::move(face));
        return true;
    }

    struct Property {
        std::string name;
        std::string type;
        std::string countType;  ///< empty: no list
    };

    bool readHeader() {
        std::vector<Property>* into = nullptr;
        while (lines_.next()) {
            const std::string_view what = lines_.word();
            if (what == "end_header") return sizeKnown();
            if (what == "format") {
                const std::string_view format = lines_.word();
                binary_ = format == "binary_little_endian";
                if (!binary_ && format != "ascii") return false;
            } else if (what == "element") {
                const std::string_view element = lines_.word();
                const auto count = wholeIn(lines_.word());
                // Points come first; what follows the faces is passed over.
                const bool point = element == "vertex" && into == nullptr;
                const bool face = element == "face" && into == &pointProperties_;
                if (!count || *count < 0) return false;
                if (!point && !face) {
                    if (into != &faceProperties_) return false;
                    into = &passedOver_;
                    continue;
                }
                (point ? points_ : faces_) = static_cast<std::size_t>(*count);
                into = point ? &pointProperties_ : &faceProperties_;
            } else if (what == "property") {
                if (into == nullptr) return false;
                Property p;
                p.type = lines_.word();
                if (p.type == "list") {
                    p.countType = lines_.word();
                    p.type = lines_.word();
                }
                p.name = lines_.word();
                into->push_back(std::move(p));
            }
        }
        return false;
    }

    static int bytesOf(const std::string& type) {
        if (type == "char" || type == "uchar" || type == "int8" || type == "uint8") return 1;
        if (type == "short" || type == "ushort" || type == "int16" || type == "uint16") return 2;
        if (type == "double" || type == "float64") return 8;
        const bool four = type == "int" || type == "uint" || type == "float" || type == "int32" ||
                          type == "uint32" || type == "float32";
        return four ? 4 : 0;
    }

    bool sizeKnown() const {
        for (const auto* properties : {&pointProperties_, &faceProperties_}) {
            for (const Property& p : *properties) {
                if (bytesOf(p.type) == 0) return false;
                if (!p.countType.empty() && bytesOf(p.countType) == 0) return false;
            }
        }
        return points_ > 0 && faces_ > 0;
    }

    /// One element, each of its numbers by `number(type)`.
    template <class Number>
    bool addElement(const std::vector<Property>& properties, bool isFace, Number number) {
        Vec3 p = Vec3::Zero();
        std::vector<int> face;
        for (const Property& property : properties) {
            double count = 1.0;
            if (!property.countType.empty()) {
                const auto told = number(property.countType);
                if (!told || *told < 0 || *told > kMostCorners) return false;
                count = *told;
            }
            for (int i = 0; i < static_cast<int>(count); ++i) {
                const auto value = number(property.type);
                if (!value || !std::isfinite(*value)) return false;
                if (property.name == "x") p.x() = *value;
                if (property.name == "y") p.y() = *value;
                if (property.name == "z") p.z() = *value;
                if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
                if (*value < 0 || *value > static_cast<double>(kMaxMeshPoints)) return false;
                face.push_back(static_cast<int>(*value));
            }
        }
        if (isFace && face.size() < 3) return false;
        if (isFace)
            mesh_.faces.push_back(std::move(face));
        else
            mesh_.vertices.push_back(p);
        return true;
    }

    bool readText() {
        const auto number = [this](const std::string&) { return numberIn(lines_.word()); };
        for (std::size_t i = 0; i < points_ + faces_; ++i) {
            const bool isFace = i >= points_;
            if (!lines_.next()) return false;
            if (!addElement(isFace ? faceProperties_ : pointProperties_, isFace, number)) {
                return false;
            }
        }
        return true;
    }

    template <class T>
    static double valueOf(const char* bytes) {
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return static_cast<double>(value);
    }

    static double valueAt(const std::string& type, const char* bytes) {
        if (type == "char" || type == "int8") return valueOf<std::int8_t>(bytes);
        if (type == "uchar" || type == "uint8") return valueOf<std::uint8_t>(bytes);
        if (type == "short" || type == "int16") return valueOf<std::int16_t>(bytes);
        if (type == "ushort" || type == "uint16") return valueOf<std::uint16_t>(bytes);
        if (type == "int" || type == "int32") return valueOf<std::int32_t>(bytes);
        if (type == "uint" || type == "uint32") return valueOf<std::uint32_t>(bytes);
        if (type == "float" || type == "float32") return valueOf<float>(bytes);
        return valueOf<double>(bytes);
    }

    bool readBinary() {
        std::string_view left = lines_.rest();
        const auto number = [&left](const std::string& type) -> std::optional<double> {
            const auto size = static_cast<std::size_t>(bytesOf(type));
            if (left.size() < size) return std::nullopt;
            const double value = valueAt(type, left.data());
            left.remove_prefix(size);
            return value;
        };
        for (std::size_t i = 0; i < points_ + faces_; ++i) {
            const bool isFace = i >= points_;
            if (!addElement(isFace ? faceProperties_ : pointProperties_, isFace, number)) {
                return false;
            }
        }
        return true;
    }

    Lines lines_;
    std::string source_;
    PolyhedronSpec mesh_;
    bool binary_ = false;
    std::size_t points_ = 0;
    std::size_t faces_ = 0;
    std::vector<Property> pointProperties_;
    std::vector<Property> faceProperties_;
    std::vector<Property> passedOver_;
};

/// Does a line of the file begin with a point?
bool looksLikeObj(std::string_view bytes) {
    return bytes.starts_with("v ") || bytes.find("\nv ") != std::string_view::npos;
}

}  // namespace

Result<PolyhedronSpec> readMesh(const std::string& bytes, const std::string& source) {
    if (bytes.starts_with("ply")) return Reader(bytes, source).ply();
    if (looksLikeObj(bytes)) return Reader(bytes, source).obj();
    return fail(Errc::WrongFormat, source + ": neither an OBJ nor a PLY mesh.");
}

}  // namespace ew
