// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/library.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/tlib/library_index.h"
#include "core/tlib/template_io.h"

namespace ew {

TemplateLibrary::TemplateLibrary() : index_(std::make_shared<const LibraryIndex>()) {}

Result<TemplateLibrary> TemplateLibrary::with(Template tmpl) const {
    std::vector<Template> one;
    one.push_back(std::move(tmpl));
    return withAll(std::move(one));
}

Result<TemplateLibrary> TemplateLibrary::withAll(std::vector<Template> templates) const {
    auto index = std::make_shared<LibraryIndex>(*index_);
    for (Template& t : templates) {
        if (auto ok = checkTemplate(t, t.id); !ok) return fail(ok.error());
        if (index->byId.contains(t.id)) {
            return fail(Errc::DuplicateId,
                        "There is already a template with the id \"" + t.id + "\".");
        }
        addEntry(*index, makeEntry(std::move(t)));
    }
    TemplateLibrary out;
    out.index_ = std::move(index);
    return out;
}

Result<TemplateLibrary> TemplateLibrary::withReplaced(Template tmpl) const {
    const int place = find(tmpl.id);
    if (place < 0) {
        return fail(Errc::UnknownTemplate, "There is no template \"" + tmpl.id + "\".");
    }
    if (auto ok = checkTemplate(tmpl, tmpl.id); !ok) return fail(ok.error());
    auto index = std::make_shared<LibraryIndex>();
    for (std::size_t i = 0; i < size(); ++i) {
        const bool here = i == static_cast<std::size_t>(place);
        addEntry(*index, here ? makeEntry(std::move(tmpl)) : index_->entries[i]);
    }
    TemplateLibrary out;
    out.index_ = std::move(index);
    return out;
}

TemplateLibrary TemplateLibrary::without(std::string_view id) const {
    if (find(id) < 0) return *this;
    auto index = std::make_shared<LibraryIndex>();
    for (const auto& entry : index_->entries) {
        if (entry->tmpl.id != id) addEntry(*index, entry);
    }
    TemplateLibrary out;
    out.index_ = std::move(index);
    return out;
}

std::size_t TemplateLibrary::size() const { return index_->entries.size(); }
const Template& TemplateLibrary::at(std::size_t i) const { return index_->entries[i]->tmpl; }
int TemplateLibrary::find(std::string_view id) const {
    const auto it = index_->byId.find(std::string(id));
    return it == index_->byId.end() ? -1 : it->second;
}

Result<LibraryLoad> loadLibrary(const std::string& folder) {
    namespace fs = std::filesystem;
    std::error_code ec;
    if (!fs::is_directory(folder, ec)) {
        return fail(Errc::FileNotFound, "There is no template folder at " + folder + ".");
    }
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder, ec)) {
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    LibraryLoad load;
    std::vector<Template> good;
    for (const fs::path& file : files) {
        std::ifstream in(file, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        auto tmpl = readTemplate(text.str(), file.filename().string());
        if (!tmpl) {
            load.problems.push_back(tmpl.error());
            continue;
        }
        const bool taken = std::any_of(good.begin(), good.end(),
                                       [&](const Template& t) { return t.id == tmpl->id; });
        if (taken) {
            load.problems.push_back({Errc::DuplicateId,
                                     file.filename().string() + ": /id: \"" + tmpl->id +
                                         "\" is taken by an earlier file.",
                                     {}});
            continue;
        }
        good.push_back(std::move(*tmpl));
    }
    auto library = TemplateLibrary().withAll(std::move(good));
    if (!library) return fail(library.error());
    load.library = std::move(*library);
    return load;
}

}  // namespace ew
