// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/zip_file.h"

#include <zip.h>

#include <memory>
#include <set>

#include "core/document/json_text.h"

namespace ew {

namespace {

struct DiscardZip {
    void operator()(zip_t* zip) const { zip_discard(zip); }
};
struct FreeSource {
    void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct CloseFile {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};

/// The entry's content must stay until the archive is closed.
bool addFile(zip_t* zip, const ZipEntry& entry) {
    zip_source_t* source = zip_source_buffer(zip, entry.content.data(), entry.content.size(), 0);
    if (source == nullptr) return false;
    const zip_int64_t index = zip_file_add(zip, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    // The format's first date.
    return zip_file_set_dostime(zip, static_cast<zip_uint64_t>(index), 0, 0x21, 0) == 0;
}

Unexpected<Error> notMade() { return fail(Errc::Internal, "The archive could not be made."); }

Unexpected<Error> damaged() {
    return fail(Errc::Damaged, "the archive is damaged or cut off, or no zip archive");
}

/// Does a name stay inside the folder that it is put into?
bool staysInside(const std::string& name) {
    if (name.empty() || name.front() == '/' || name.find('\\') != std::string::npos ||
        name.find(':') != std::string::npos || name.find('\0') != std::string::npos) {
        return false;
    }
    std::size_t from = 0;
    while (from <= name.size()) {
        const std::size_t to = std::min(name.find('/', from), name.size());
        const std::string part = name.substr(from, to - from);
        if (part == ".." || part == ".") return false;
        from = to + 1;
    }
    return true;
}

bool isLink(zip_t* zip, zip_uint64_t index) {
    zip_uint8_t system = 0;
    zip_uint32_t attributes = 0;
    if (zip_file_get_external_attributes(zip, index, 0, &system, &attributes) != 0) return false;
    constexpr zip_uint32_t kKind = 0170000;
    constexpr zip_uint32_t kLink = 0120000;
    constexpr unsigned kUnixShift = 16;
    return system == ZIP_OPSYS_UNIX && ((attributes >> kUnixShift) & kKind) == kLink;
}

Result<ZipEntry> readEntry(zip_t* zip, zip_uint64_t index, const std::string& name,
                           std::size_t most) {
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(zip, index, 0));
    if (!file) return damaged();
    ZipEntry entry{name, {}};
    std::string block(std::size_t{64} << 10U, '\0');
    while (true) {
        const zip_int64_t got = zip_fread(file.get(), block.data(), block.size());
        if (got < 0) return damaged();
        if (got == 0) return entry;
        // What an entry says of its size is no promise.
        if (entry.content.size() + static_cast<std::size_t>(got) > most) {
            return fail(Errc::TooLarge, nameQuoted(name) + " is too large");
        }
        entry.content.append(block.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace

Result<std::string> zipBytes(std::span<const ZipEntry> entries) {
    zip_error_t error;
    zip_error_init(&error);
    const std::unique_ptr<zip_source_t, FreeSource> target(
        zip_source_buffer_create(nullptr, 0, 0, &error));
    if (!target) return notMade();
    zip_source_keep(target.get());  // one reference for the archive, one to read it afterwards
    std::unique_ptr<zip_t, DiscardZip> zip(
        zip_open_from_source(target.get(), ZIP_TRUNCATE, &error));
    if (!zip) {
        zip_source_free(target.get());
        return notMade();
    }
    for (const ZipEntry& entry : entries) {
        if (!addFile(zip.get(), entry)) return notMade();
    }
    if (zip_close(zip.get()) != 0) return notMade();
    static_cast<void>(zip.release());  // closed
    zip_stat_t stat;
    if (zip_source_stat(target.get(), &stat) != 0 || zip_source_open(target.get()) != 0) {
        return notMade();
    }
    std::string out(static_cast<std::size_t>(stat.size), '\0');
    const zip_int64_t read = zip_source_read(target.get(), out.data(), out.size());
    zip_source_close(target.get());
    if (read != static_cast<zip_int64_t>(out.size())) return notMade();
    return out;
}

Result<std::vector<ZipEntry>> readZip(const std::string& bytes, const ZipLimits& limits) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    if (source == nullptr) return damaged();
    const std::unique_ptr<zip_t, DiscardZip> zip(
        zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error));
    if (!zip) {
        zip_source_free(source);
        return damaged();
    }
    const zip_int64_t count = zip_get_num_entries(zip.get(), 0);
    if (count > static_cast<zip_int64_t>(limits.entries)) {
        return fail(Errc::TooLarge,
                    "the archive holds more than " + std::to_string(limits.entries) + " files");
    }
    std::vector<ZipEntry> out;
    std::set<std::string> known;
    std::size_t left = limits.bytesOfAll;
    for (zip_int64_t i = 0; i < count; ++i) {
        const auto index = static_cast<zip_uint64_t>(i);
        const char* raw = zip_get_name(zip.get(), index, 0);
        if (raw == nullptr) return damaged();
        const std::string name = raw;
        if (!staysInside(name) || isLink(zip.get(), index)) {
            return fail(Errc::BadValue,
                        nameQuoted(name) + " leads out of the archive or is a link");
        }
        if (!known.insert(name).second) {
            return fail(Errc::BadValue, nameQuoted(name) + " comes twice");
        }
        if (name.back() == '/') continue;
        zip_stat_t stat;
        if (zip_stat_index(zip.get(), index, 0, &stat) != 0) return damaged();
        if ((stat.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 &&
            stat.encryption_method != ZIP_EM_NONE) {
            return fail(Errc::BadValue, nameQuoted(name) + " is encrypted");
        }
        auto entry = readEntry(zip.get(), index, name, std::min(limits.bytesOfOne, left));
        if (!entry) return fail(entry.error());
        left -= entry->content.size();
        out.push_back(*std::move(entry));
    }
    return out;
}

}  // namespace ew
