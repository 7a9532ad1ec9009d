// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/json_text.h"
#include "core/document/store.h"

// What both schemas of the native document say in the same words. Readers throw ReadError.
namespace ew {

/// `list/i`, the place of an item in messages.
std::string itemPlace(const std::string& list, std::size_t i);
/// A comma before every item but the first of a list that begins with "[".
void separate(std::string& list);

/// A camera with all of its keys.
std::string fullCamera(const OrthographicCamera& camera);
OrthographicCamera fullCameraFromJson(const nlohmann::json& value, const std::string& place);

/// `"rotation": [...], "translation": [...]`.
std::string poseText(const Pose& pose);
Pose poseFromJson(const ObjectReader& body);

/// Throws where a sample is no sample or validateStroke() refuses it.
void checkSamples(const Stroke& stroke, const std::string& place);

/// Ids in rising order.
/// \param what  the messages' word for one of them.
std::vector<int> idsFromJson(const nlohmann::json& value, const std::string& place);
std::string idsText(const std::vector<int>& ids);

/// The libraries of the states of a document, by the templates that it added.
class StoredLibraries {
  public:
    /// \param own  the templates that states may name.
    /// \param used  templates that steps used and that may have come from elsewhere: where
    ///     `shipped` lacks them, they join it.
    StoredLibraries(const TemplateLibrary& shipped, std::vector<Template> own,
                    const std::vector<Template>& used = {});

    const std::vector<Template>& templates() const { return own_; }
    /// \param added  indices into templates().
    const TemplateLibrary& with(const std::vector<int>& added, const std::string& place);

  private:
    std::vector<Template> own_;
    TemplateLibrary base_;  ///< shipped, without those whose ids the document has taken
    std::map<std::vector<int>, TemplateLibrary> known_;
};

/// The list of bodies of a state: the tree itself, or its member where it has a mirror plane, too.
const nlohmann::json& bodyList(const nlohmann::json& tree);

}  // namespace ew
