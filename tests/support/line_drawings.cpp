// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/line_drawings.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace ew::test {
namespace {

constexpr double kSampleStepPx = 4.0;

/// A stroke in the file's units, y down.
struct RawStroke {
    std::vector<Vec2> points;
    int cluster = -1;
    bool hidden = false;
};

Result<std::string> readText(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return fail(Errc::FileNotFound, "There is no file " + path + ".");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Scales and centres; `exact` strokes are polylines and get samples between their points.
Result<LineDrawing> place(std::string name, const std::vector<RawStroke>& raw, bool exact,
                          double diagonalPx) {
    Vec2 low(HUGE_VAL, HUGE_VAL);
    Vec2 high = -low;
    for (const RawStroke& r : raw) {
        for (const Vec2& p : r.points) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
    }
    const double diagonal = (high - low).norm();
    if (raw.empty() || !(diagonal > 0.0) || !std::isfinite(diagonal)) {
        return fail(Errc::WrongFormat, name + " holds no drawing.");
    }
    LineDrawing drawing{std::move(name), {}, diagonalPx / diagonal};
    for (const RawStroke& r : raw) {
        ImportedStroke out{{}, r.cluster, r.hidden};
        const auto add = [&](const Vec2& p) { out.stroke.samples.push_back({p, 0.5, 0.0}); };
        Vec2 before = Vec2::Zero();
        for (std::size_t i = 0; i < r.points.size(); ++i) {
            const Vec2 p = Vec2(640, 400) + drawing.pxPerUnit * (r.points[i] - (low + high) / 2.0);
            const int pieces =
                exact && i > 0 ? std::max(1, static_cast<int>((p - before).norm() / kSampleStepPx))
                               : 1;
            for (int k = 1; k < pieces; ++k) {
                add(before + static_cast<double>(k) / pieces * (p - before));
            }
            add(p);
            before = p;
        }
        drawing.strokes.push_back(std::move(out));
    }
    return drawing;
}

/// The number in name="..." of an XML element.
std::optional<double> attribute(const std::string& element, const std::string& name) {
    const std::string key = " " + name + "=\"";
    const std::size_t at = element.find(key);
    if (at == std::string::npos) return {};
    const char* text = element.c_str() + at + key.size();
    char* end = nullptr;
    const double value = std::strtod(text, &end);
    if (end == text || *end != '"') return {};
    return value;
}

/// Appends the lines of one group; false where one lacks a coordinate.
bool readGroup(const std::string& svg, const std::string& id, double ySign,
               std::vector<RawStroke>& out) {
    std::size_t at = svg.find("id=\"" + id + "\"");
    if (at == std::string::npos) return true;
    const std::size_t end = svg.find("</g>", at);
    while ((at = svg.find("<line", at)) < end) {
        const std::string element = svg.substr(at, svg.find('>', at) - at);
        const auto x1 = attribute(element, "x1");
        const auto y1 = attribute(element, "y1");
        const auto x2 = attribute(element, "x2");
        const auto y2 = attribute(element, "y2");
        if (!x1 || !y1 || !x2 || !y2) return false;
        out.push_back({{Vec2(*x1, ySign * *y1), Vec2(*x2, ySign * *y2)}, -1, id == "Hidden"});
        at += element.size();
    }
    return true;
}

/// The corners of a line or rectangle element; empty for anything else.
std::vector<Vec2> excalidrawPoints(const nlohmann::json& element) {
    const Vec2 at(element.at("x").get<double>(), element.at("y").get<double>());
    std::vector<Vec2> points;
    if (element.at("type") == "rectangle") {
        const double w = element.at("width").get<double>();
        const double h = element.at("height").get<double>();
        points = {at, at + Vec2(w, 0), at + Vec2(w, h), at + Vec2(0, h), at};
    } else if (element.at("type") == "line") {
        for (const auto& p : element.at("points")) {
            points.emplace_back(at + Vec2(p.at(0).get<double>(), p.at(1).get<double>()));
        }
    }
    if (points.empty()) return points;
    // Elements turn about the middle of their bounding box.
    Vec2 low = points[0];
    Vec2 high = points[0];
    for (const Vec2& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Vec2 middle = (low + high) / 2.0;
    const Eigen::Rotation2Dd turn(element.value("angle", 0.0));
    for (Vec2& p : points) p = middle + turn * (p - middle);
    return points;
}

}  // namespace

std::vector<Stroke> LineDrawing::visible() const {
    std::vector<Stroke> out;
    for (const ImportedStroke& s : strokes) {
        if (!s.hidden) out.push_back(s.stroke);
    }
    return out;
}

std::vector<Stroke> LineDrawing::clusters(const std::vector<int>& numbers) const {
    std::vector<Stroke> out;
    for (const ImportedStroke& s : strokes) {
        if (std::find(numbers.begin(), numbers.end(), s.cluster) != numbers.end()) {
            out.push_back(s.stroke);
        }
    }
    return out;
}

std::string outsideDrawings() {
    const char* named = std::getenv("EDGEWRIGHT_DRAWINGS");
    const std::string folder = named != nullptr ? named : EDGEWRIGHT_SOURCE_DIR "/../shared/data";
    return std::filesystem::is_directory(folder) ? folder + "/" : "";
}

Result<LineDrawing> readHiddenLineSvg(const std::string& path, double diagonalPx) {
    const auto svg = readText(path);
    if (!svg) return fail(svg.error());
    const double ySign = svg->find("transform=\"scale(1,-1)\"") != std::string::npos ? -1.0 : 1.0;
    std::vector<RawStroke> raw;
    if (!readGroup(*svg, "Visible", ySign, raw) || !readGroup(*svg, "Hidden", ySign, raw)) {
        return fail(Errc::WrongFormat, path + " has a line without coordinates.");
    }
    return place(std::filesystem::path(path).stem(), raw, true, diagonalPx);
}

Result<LineDrawing> readScap(const std::string& path, double diagonalPx) {
    const auto text = readText(path);
    if (!text) return fail(text.error());
    std::istringstream in(*text);
    std::string line;
    std::vector<RawStroke> raw;
    bool inside = false;
    for (int number = 1; std::getline(in, line); ++number) {
        std::istringstream words(line);
        std::string first;
        if (!(words >> first)) continue;
        const auto broken = [&] {
            return fail(Errc::WrongFormat, path + ":" + std::to_string(number) + " is not SCAP.");
        };
        if (first == "{" || first == "}") {
            if (inside == (first == "{")) return broken();
            inside = first == "{";
            if (inside) raw.emplace_back();
        } else if (first[0] == '#') {
            if (inside && !(words >> raw.back().cluster)) return broken();
        } else if (first[0] != '@') {
            Vec2 p;
            if (!inside || !(std::istringstream(line) >> p.x() >> p.y())) return broken();
            raw.back().points.push_back(p);
        }
    }
    if (inside) return fail(Errc::WrongFormat, path + " is cut off.");
    return place(std::filesystem::path(path).stem(), raw, false, diagonalPx);
}

Result<std::vector<LineDrawing>> readExcalidrawLibrary(const std::string& path, double diagonalPx) {
    const auto text = readText(path);
    if (!text) return fail(text.error());
    std::vector<LineDrawing> drawings;
    try {
        const auto json = nlohmann::json::parse(*text);
        for (const auto& item : json.at("libraryItems")) {
            std::vector<RawStroke> raw;
            for (const auto& element : item.at("elements")) {
                RawStroke r{excalidrawPoints(element), -1,
                            element.value("strokeStyle", "solid") == "dashed"};
                if (r.points.size() > 1) raw.push_back(std::move(r));
            }
            if (raw.empty()) continue;
            auto drawing = place(item.value("name", ""), raw, true, diagonalPx);
            if (!drawing) return fail(drawing.error());
            drawings.push_back(std::move(*drawing));
        }
    } catch (const nlohmann::json::exception& e) {
        return fail(Errc::WrongFormat, path + ": " + e.what());
    }
    return drawings;
}

}  // namespace ew::test
