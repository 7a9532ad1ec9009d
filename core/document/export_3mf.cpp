// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_3mf.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/document/export_place.h"
#include "core/document/zip_file.h"

namespace ew {
namespace {

constexpr const char* kContentTypes =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr const char* kRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

void appendNumber(std::string& out, double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value == 0.0 ? 0.0 : value);
    out.append(buffer, end.ptr);
}

void appendNumber(std::string& out, int value) {
    char buffer[16];
    const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value);
    out.append(buffer, end.ptr);
}

/// Text for an XML attribute; control characters, which XML cannot hold, become blanks.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
        }
    }
    return out;
}

std::string modelText(std::span<const TriangleMeshView> bodies, const Vec3& origin) {
    std::string out = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<metadata name="Application">Edgewright</metadata>
<resources>
)";
    std::string items;
    int id = 0;
    for (const TriangleMeshView& body : bodies) {
        if (body.triangles.empty()) continue;
        appendNumber(out.append("<object id=\""), ++id);
        out.append("\" type=\"model\" name=\"").append(escaped(body.name));
        out.append("\"><mesh>\n<vertices>\n");
        Extent extent;
        extent.add(body.positions);
        const Vec3 own = fileOrigin(extent);
        for (const Vec3& position : body.positions) {
            const Vec3 p = position - own;
            appendNumber(out.append("<vertex x=\""), p.x());
            appendNumber(out.append("\" y=\""), p.y());
            appendNumber(out.append("\" z=\""), p.z());
            out.append("\"/>\n");
        }
        out.append("</vertices>\n<triangles>\n");
        for (const auto& t : body.triangles) {
            appendNumber(out.append("<triangle v1=\""), t[0]);
            appendNumber(out.append("\" v2=\""), t[1]);
            appendNumber(out.append("\" v3=\""), t[2]);
            out.append("\"/>\n");
        }
        out.append("</triangles>\n</mesh></object>\n");
        appendNumber(items.append("<item objectid=\""), id);
        const Vec3 place = origin + own;
        if (!place.isZero(0.0)) {
            items.append("\" transform=\"1 0 0 0 1 0 0 0 1");
            for (int k = 0; k < 3; ++k) appendNumber(items.append(" "), place[k]);
        }
        items.append("\"/>\n");
    }
    return out.append("</resources>\n<build>\n").append(items).append("</build>\n</model>\n");
}

}  // namespace

Result<std::string> threeMfBytes(std::span<const TriangleMeshView> bodies, const Vec3& origin) {
    if (auto ok = checkMeshes(bodies); !ok) return fail(ok.error());
    std::vector<ZipEntry> entries;
    entries.push_back({"[Content_Types].xml", kContentTypes});
    entries.push_back({"_rels/.rels", kRelations});
    entries.push_back({"3D/3dmodel.model", modelText(bodies, origin)});
    return zipBytes(entries);
}

}  // namespace ew
