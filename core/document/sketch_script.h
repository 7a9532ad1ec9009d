// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/camera.h"
#include "core/base/result.h"
#include "core/document/body_list.h"
#include "core/document/export_options.h"
#include "core/reading/types/interpretation.h"
#include "core/solid/boolean.h"
#include "core/solid/mirror.h"
#include "core/solid/pull.h"
#include "core/stroke/stroke.h"
#include "core/tlib/template.h"

namespace ew {

// One struct a step of the sketch script, version 1. Optional members were not named in the file.
struct CameraStep {
    std::optional<Vec3> direction, up, center;
    std::optional<double> worldPerPixel;
    std::optional<Vec2>
        viewport;  ///< [px], where later strokes were drawn in a window of another size
};
struct ThresholdsStep {
    std::optional<double> distancePx, angleDeg;
};
struct StrokeStep {
    Stroke stroke;
    bool hasPressure = false;
};
struct EraseStep {
    Vec2 at = Vec2::Zero();
};
struct ClearStep {};
/// What stays of a solid that a plane cuts in two.
enum class SplitKeep { Both, Larger, Smaller };
/// "both", "larger", "smaller".
std::string_view splitKeepName(SplitKeep keep);
struct ApplyStep {
    std::optional<int> candidate;
    std::string templateId;
    Operation operation = Operation::Auto;
    std::optional<double> obliqueFactor;  ///< k of the oblique reading, where it is not 0.5
    SplitKeep keep = SplitKeep::Both;
    bool level = false;  ///< see ApplyRequest
};
/// Which edges a step is for.
struct EdgeWords {
    enum class Which { All, Convex, Concave, Near };
    Which which = Which::All;
    std::vector<Vec3> near;   ///< world points, for Which::Near; each names the nearest edge
    std::vector<int> bodies;  ///< by point: the body whose edge it names, -1: any; empty: all any
};
struct FilletStep : EdgeWords {
    double radius = 0.0;  ///< [mm], > 0
    std::optional<int> segments;
};
struct SharpenStep : EdgeWords {};
struct CreaseStep : EdgeWords {
    std::optional<double> sharpness;  ///< 0..10, not set: automatic
};
struct SubdivideStep {
    std::string scheme;               ///< "catmull-clark" or "loop"
    std::optional<int> levels;        ///< 0..6
    std::optional<double> tolerance;  ///< [mm], > 0
    std::optional<double> crease;     ///< 0..10, sharpness of edges that are not filleted; not set:
                                      ///< automatic
    bool sharpCorners = false;
};
struct MapStrokesStep {
    std::string color;  ///< "#rrggbb", empty: the default
};
struct UnmapStrokesStep {};
struct DefineTemplateStep {
    std::string id, name;
    std::optional<Template> tmpl;  ///< not set: from the solid
    bool replace = false;          ///< takes the place of the document's own template of this id
};
struct UndoStep {
    int count = 1;
    bool ink = false;  ///< changes of the ink, not steps of the history
};
struct RedoStep {
    int count = 1;
    bool ink = false;
};
struct DeleteSolidStep {};
struct SaveStep {
    std::string path;
};
struct OpenStep {
    std::string path;
};
struct ExportStep {
    std::string path;
    ExportFaces faces = ExportFaces::Simple;
    ExportUnit unit = ExportUnit::Millimetre;
    std::vector<int> bodies = {};  ///< by index; empty: all
};
/// How a step names a body: by its index, or by its name.
struct BodyWord {
    int index = -1;
    std::string name;  ///< where index is -1
};
struct PullStep {
    Vec3 at = Vec3::Zero();  ///< a world point on the face
    double distance = 0.0;   ///< outwards positive [mm]
    PullWalls walls = PullWalls::Follow;
    std::optional<BodyWord> body;
    bool whole = false;  ///< the face, also where pending strokes are an outline round the point
};
struct MoveBodyStep {
    BodyWord body;
    BodyMove move;
};
struct NameBodyStep {
    BodyWord body;
    std::string name;
};
struct ShowBodyStep {
    BodyWord body;
    bool visible = true;
};
struct DeleteBodyStep {
    BodyWord body;
};
struct CombineBodiesStep {
    BodyWord body, other;
    BooleanKind kind = BooleanKind::Add;  ///< Add or Cut
};
struct MirrorPlaneStep {
    std::optional<MirrorPlane> plane;  ///< not set: off
};
/// Gives a state of the history a name.
struct NameStep {
    std::string name;          ///< empty: takes the name away
    std::optional<int> state;  ///< how many steps are done in it; not set: the one of now
};
/// Merges the steps between named states.
struct CompactStep {};

using ScriptStep =
    std::variant<CameraStep, ThresholdsStep, StrokeStep, EraseStep, ClearStep, ApplyStep,
                 FilletStep, SharpenStep, CreaseStep, SubdivideStep, MapStrokesStep,
                 UnmapStrokesStep, DefineTemplateStep, DeleteSolidStep, UndoStep, RedoStep,
                 SaveStep, OpenStep, ExportStep, NameStep, CompactStep, PullStep, MoveBodyStep,
                 NameBodyStep, ShowBodyStep, DeleteBodyStep, CombineBodiesStep, MirrorPlaneStep>;

/// The "do" word of a step.
std::string_view stepName(const ScriptStep& step);

/// A sketch script, version 1 (the contract is in the project's documentation,
/// docs/sketch-script.md).
struct SketchScript {
    std::string title;
    std::array<double, 2> viewport{1280, 800};
    Thresholds thresholds;
    bool namesDistance = false;  ///< else each drawing tells it: Document::automaticDistance
    std::vector<ScriptStep> steps;
};

// Ranges that a script, a document and the window share.
inline constexpr double kMinDistancePx = 1.0;
inline constexpr double kMaxDistancePx = 100.0;
inline constexpr double kMinAngleDeg = 0.5;
inline constexpr double kMaxAngleDeg = 45.0;
inline constexpr double kMinViewportPx = 16.0;
inline constexpr double kMaxViewportPx = 100'000.0;
inline constexpr double kMinWorldPerPixel = 1e-9;
inline constexpr double kMaxWorldPerPixel = 1e9;
inline constexpr double kMaxCenterMm = 1e12;
inline constexpr double kMinObliqueFactor = 0.1;
inline constexpr double kMaxObliqueFactor = 2.0;

inline constexpr std::size_t kMaxScriptBytes = 64U << 20U;
inline constexpr std::size_t kMaxScriptSteps = 1'000'000;

/// Reads a script. Errors name the step (counted from 0, as in the report) and the key, e.g.
/// `step 3 (stroke): unknown key "pts"`: Syntax, WrongFormat, WrongVersion, UnknownKey, MissingKey,
/// WrongType, BadValue, TooLarge (over 64 MiB, or too many values or steps), TooDeep, and those of
/// readTemplate for an inline template. Stroke coordinates are checked when the step runs.
Result<SketchScript> readSketchScript(std::string_view json);

/// Reads one step, as it stands in a script. Errors as above.
Result<ScriptStep> readScriptStep(std::string_view json);

/// JSON text that reads back to the same script, one step a line.
std::string writeSketchScript(const SketchScript& script);

}  // namespace ew
