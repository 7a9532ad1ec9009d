// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_3mf.h"

#include <zip.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "core/document/export_place.h"

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

struct DiscardZip {
    void operator()(zip_t* zip) const { zip_discard(zip); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};

/// \param text  must stay until the package is closed.
bool addFile(zip_t* zip, const char* name, std::string_view text) {
    zip_source_t* source = zip_source_buffer(zip, text.data(), text.size(), 0);
    if (source == nullptr) return false;
    const zip_int64_t index = zip_file_add(zip, name, source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    // One date for all: the format's first, so that the same model gives the same file.
    const auto i = static_cast<zip_uint64_t>(index);
    return zip_file_set_dostime(zip, i, 0, 0x21, 0) == 0;
}

Unexpected<Error> noPackage() { return fail(Errc::Internal, "The 3MF package could not be made."); }

}  // namespace

Result<std::string> threeMfBytes(std::span<const TriangleMeshView> bodies, const Vec3& origin) {
    if (auto ok = checkMeshes(bodies); !ok) return fail(ok.error());
    const std::string model = modelText(bodies, origin);
    zip_error_t error;
    zip_error_init(&error);
    const std::unique_ptr<zip_source_t, FreeSource> target(
        zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!target) return noPackage();
    zip_source_keep(target.get());  // one reference for the package, one to read it afterwards
    std::unique_ptr<zip_t, DiscardZip> zip(
        zip_open_from_source(target.get(), ZIP_TRUNCATE, &error));
    if (!zip) {
        zip_source_free(target.get());
        return noPackage();
    }
    const bool added = addFile(zip.get(), "[Content_Types].xml", kContentTypes) &&
                       addFile(zip.get(), "_rels/.rels", kRelations) &&
                       addFile(zip.get(), "3D/3dmodel.model", model);
    if (!added || zip_close(zip.get()) != 0) return noPackage();
    static_cast<void>(zip.release());  // closed
    zip_stat_t stat;
    if (zip_source_stat(target.get(), &stat) != 0 || zip_source_open(target.get()) != 0) {
        return noPackage();
    }
    std::string out(static_cast<std::size_t>(stat.size), '\0');
    const zip_int64_t read = zip_source_read(target.get(), out.data(), out.size());
    zip_source_close(target.get());
    if (read != static_cast<zip_int64_t>(out.size())) return noPackage();
    return out;
}

}  // namespace ew
