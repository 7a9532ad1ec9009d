// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/camera.h"
#include "core/document/body_list.h"
#include "core/document/derived_shape.h"
#include "core/document/export_options.h"
#include "core/document/sketch_script.h"
#include "core/reading/propose/profile.h"
#include "core/reading/types/interpretation.h"
#include "core/solid/boolean.h"
#include "core/solid/mirror.h"
#include "core/solid/pull.h"
#include "core/solid/solid.h"
#include "core/stroke/stroke.h"
#include "core/tlib/library.h"

class QUndoStack;

namespace ew {

struct DocumentFile;
struct DocumentUpdate;
struct OpenedFile;
struct HistoryChange;

/// The document's truth, as an immutable snapshot. Undo and redo swap snapshots.
struct DocumentState {
    std::vector<Body> bodies;
    TemplateLibrary library;                  ///< the T-LIB in use: shipped templates and additions
    std::vector<std::string> addedTemplates;  ///< ids that this document added
    SurfaceSettings surface;                  ///< fillets and subdivision
    std::vector<MappedStroke> mapped;         ///< strokes drawn onto the surface
    std::optional<MirrorPlane> mirror;        ///< what is done is done on both sides of it
};

/// A stroke that no command has consumed yet.
struct PendingStroke {
    int id = -1;                ///< unique in the document's life
    Stroke stroke;              ///< Sketch Plane px of `camera`
    OrthographicCamera camera;  ///< what it was drawn through
};

/// What changed; one signal carries it.
enum class DocumentChange {
    Ink,      ///< pending strokes
    Reading,  ///< the interpretation of the pending strokes (after Ink, Thresholds or Library)
    Bodies,   ///< the solids
    Shape,    ///< what shape() gives: cage, surface, mapped strokes
    Camera,
    Thresholds,
    Library,
    History,  ///< undo stack index, count or names
    File,     ///< path or modified flag
};

struct ApplyRequest {
    std::optional<int> candidate;  ///< not set: the accepted one, else an error says why
    std::string templateId;        ///< empty: any
    Operation operation = Operation::Auto;
    std::optional<double> obliqueFactor;  ///< not set: Document::obliqueFactor()
    SplitKeep keep = SplitKeep::Both;     ///< of a solid that is cut in two
    /// A first solid is turned level and stands on the ground, and the camera turns with it; a
    /// further one is set beside it where its picture allows it.
    bool level = false;
};

struct ApplyOutcome {
    Interpretation interpretation;
    int chosen = -1;  ///< index into interpretation.candidates
};

/// A closed outline among the pending strokes, on a face.
struct OutlineOnFace {
    Profile profile;           ///< `body` as in DocumentState::bodies
    Vec3 at = Vec3::Zero();    ///< a world point inside it
    std::vector<int> strokes;  ///< ids of the pending strokes that it was drawn by
};

/// A face that is moved along its normal.
struct PullRequest {
    FaceRef face;
    double distance = 0.0;  ///< outwards positive [mm]
    PullWalls walls = PullWalls::Follow;
    std::optional<OutlineOnFace> outline = {};  ///< only what it encloses is pulled
};

struct FilletRequest {
    EdgeChoice edges;
    double radius = 0.0;          ///< of the rolling ball [mm], > 0
    std::optional<int> segments;  ///< of all fillets; not set: as they are
    bool replace = false;         ///< takes the place of the newest command where that was a fillet
                                  ///< of the same edges, so that a series of drags is one step
};

struct FilletOutcome {
    int edges = 0;                     ///< how many were chosen
    std::vector<ClampedEdge> clamped;  ///< of the whole document
};

struct MapOutcome {
    int mapped = 0;  ///< strokes that are on the surface now
    int missed = 0;  ///< strokes with no surface under them; they stay pending
};

/// How strokes are read; interpret() unless a test puts another one in.
using Interpreter = std::function<Interpretation(const std::vector<Stroke>&, const TemplateLibrary&,
                                                 const InterpretOptions&)>;

/// A document and everything a person can do to it. The window and replay call the same functions;
/// each successful one is recorded as a sketch script step. A function that fails changes nothing.
/// Single-threaded (the thread that made it).
/// \paper{7.4}
class Document : public QObject {
    Q_OBJECT

  public:
    /// \param shippedLibrary  the templates of resources/templates.
    explicit Document(TemplateLibrary shippedLibrary, QObject* parent = nullptr);
    Document(TemplateLibrary shippedLibrary, Interpreter interpreter, QObject* parent = nullptr);
    ~Document() override;

    const DocumentState& state() const;

    // Ink ---------------------------------------------------------------------------------------
    /// Adds a pending stroke and returns its id. Errors of validateStroke, Errc::TooManyStrokes.
    Result<int> addStroke(Stroke stroke);
    /// Removes the pending stroke nearest to a point, within the distance threshold; returns its
    /// id. Errc::NoStroke.
    Result<int> eraseAt(const Vec2& px);
    /// Removes these pending strokes (unknown ids are ignored).
    void removeStrokes(const std::vector<int>& ids);
    void clearStrokes();
    const std::vector<PendingStroke>& pendingStrokes() const;
    /// Takes back the newest ink change (stroke added, erased, cleared) since the newest command. A
    /// command that is undone brings the changes before it back, so that undoing ink where there is
    /// some, and else a step, goes back in one line of time.
    bool undoInk();
    bool canUndoInk() const;
    /// Does again what undoInk() took back, until the ink changes in another way or a new command
    /// comes. Going forward, ink comes before the step.
    bool redoInk();
    bool canRedoInk() const;
    /// As undoInk(), for a gesture that is given up: nothing to do again is left of it.
    bool withdrawInk();

    // View and thresholds -------------------------------------------------------------------------
    const OrthographicCamera& camera() const;
    Result<void> setCamera(const OrthographicCamera& camera);
    const Thresholds& thresholds() const;
    /// Another distance than the one in use ends automaticDistance().
    Result<void> setThresholds(const Thresholds& thresholds);
    /// Is the distance threshold told by the pending strokes (suitedDistancePx)? So it is until
    /// somebody sets it.
    bool automaticDistance() const;
    void setAutomaticDistance(bool automatic);
    double obliqueFactor() const;
    void setObliqueFactor(double k);

    // Reading ------------------------------------------------------------------------------------
    /// The pending strokes as read now (cached until something that it depends on changes).
    const Interpretation& interpretation() const;
    /// What apply(request) would choose from.
    const Interpretation& interpretationFor(const ApplyRequest& request) const;
    /// The same with one more stroke that is still under way; nothing is stored.
    Interpretation interpretWith(const Stroke& underWay) const;
    /// The same for a stroke that is drawn through another camera (on the Sketch Plane of earlier
    /// ink).
    Interpretation interpretWith(const Stroke& underWay, const OrthographicCamera& camera) const;
    /// The work of interpretation() or, with a stroke under way, of interpretWith(), on copies: it
    /// may be done on another thread while the document changes.
    std::function<Interpretation()> readingTask(const Stroke* underWay,
                                                const OrthographicCamera& camera) const;
    /// Is interpretation() known already?
    bool readingKnown() const;
    /// Keeps what a readingTask() without a stroke found.
    /// \pre nothing that it depends on changed since it was made.
    void keepReading(Interpretation reading);

    // Commands -----------------------------------------------------------------------------------
    /// Makes or changes the solid from the pending strokes. Only if it succeeds, and only those
    /// that the chosen candidate explains are consumed (Candidate::unusedStrokes stay pending).
    Result<ApplyOutcome> apply(const ApplyRequest& request = {});
    /// What the newest apply read, for the other readings: while it is still the newest command,
    /// nothing was drawn since and the thresholds stand; read again where the oblique factor moved.
    /// nullptr otherwise.
    const ApplyOutcome* lastApply() const;
    /// Replaces the newest apply by another of its candidates: undo, then apply.
    Result<ApplyOutcome> chooseReading(int candidate);
    /// Carries out a one-click repair on the pending strokes or thresholds.
    Result<void> repair(const Repair& repair);
    /// \param replace  it takes the place of the document's own template of this id. Errors:
    ///     BadTemplate, DuplicateId; UnknownTemplate where there is none to replace, or only one
    ///     that does not belong to the document.
    Result<void> defineTemplate(Template tmpl, bool replace = false);
    /// Adds the solid of the document as a template; relations are read off its geometry.
    Result<void> defineTemplateFromSolid(const std::string& id, const std::string& name);
    /// Removes every body (one undo step). Errc::NoSolid.
    Result<void> deleteBodies();

    // Surface ------------------------------------------------------------------------------------
    /// Rounds edges; a radius that does not fit is clamped edge by edge. A setting: it can be
    /// changed later, and edges that survive a change of the solid keep theirs. Errors: NoSolid,
    /// NoEdge, BadValue, and what shape() would have for a problem.
    Result<FilletOutcome> fillet(const FilletRequest& request);
    /// Takes the fillets of edges away. NoSolid, NoEdge (also where none is filleted), BadValue.
    Result<void> sharpen(const EdgeChoice& edges);
    /// How sharp edges that are not filleted stay in the surface: 0..kInfiniteSharpness or
    /// kAutomaticSharpness. NoSolid, NoEdge, BadValue and what shape() would have for a problem.
    Result<void> crease(const EdgeChoice& edges, double sharpness);
    /// Sets the smooth surface.
    /// \param replace  as in FilletRequest, for a newest command of the same kind. NoSolid,
    ///     BadValue, TooMuchMemory and what else shape() would have for a problem.
    Result<void> subdivide(const SubdivisionSettings& settings, bool replace = false);
    /// Draws the pending strokes onto what is seen of the surface (or cage, or solid) and consumes
    /// those that have any of it under them. NoSolid, EmptySketch, NoSurface.
    Result<MapOutcome> mapStrokes(const StrokeColor& color = kDefaultStrokeColor);
    /// Removes all strokes from the surface. NoStroke.
    Result<void> unmapStrokes();
    /// Cage, surface and mapped strokes of the state, derived where they are not known yet.
    std::shared_ptr<const DerivedShape> shape() const;
    /// What shape() is derived from, for previews with other settings.
    ShapeInput shapeInput() const;
    /// Where shape() looks first; a preview that was made with it need not be made again.
    const std::shared_ptr<ShapeCache>& shapeCache() const;
    /// Most bytes of all surfaces together; not part of the file.
    void setSurfaceMemoryLimit(std::size_t bytes);

    // Bodies, by index into DocumentState::bodies. Each is a step of the history.
    // ------------------
    /// The outline of pending strokes round a world point on a face. Errors: those of
    /// readProfile().
    Result<OutlineOnFace> outlineAt(const Vec3& world) const;
    /// An outline is consumed. Errors: NoSolid, BadValue, those of pullFace() and pullProfile().
    Result<void> pull(const PullRequest& request);
    /// What pull() would lead to, for previews.
    Result<std::shared_ptr<const DocumentState>> pulled(const PullRequest& request) const;
    /// Fillets go with the body; strokes on the surface stay where they are seen.
    /// \return the body that was moved, or the copy. Errors: BadValue, those of movedBody().
    Result<int> moveBody(int body, const BodyMove& move);
    /// From now on what is applied, pulled, filleted or creased is so on both sides of this plane;
    /// nothing: on one. Errors: NoChange where it is so already, those of mirrorPlane().
    Result<void> setMirror(const std::optional<MirrorPlane>& plane);
    /// Errors: BadValue, DuplicateId for a name that another body has.
    /// \param name  empty: it is called by its number again.
    Result<void> nameBody(int body, const std::string& name);
    /// Errors: BadValue, NoChange.
    Result<void> showBody(int body, bool visible);
    Result<void> deleteBody(int body);
    /// Adds another body to one or cuts it out of it; the other one is gone then.
    /// Errors: BadValue, OperationImpossible for an addition that does not touch, those of
    /// combine().
    Result<void> combineBodies(int body, int other, BooleanKind kind);

    /// Errors of both: NothingToUndo, NothingToRedo, BadValue; Damaged where the solids of the
    /// state to go to, which an opened file leaves for later, cannot be read: then nothing is done.
    Result<void> undo(int count = 1);
    Result<void> redo(int count = 1);
    /// Goes back or forward along the line of time, with all ink on the way, to right after a step
    /// (forward) or to right before the next one (back).
    /// \param index  steps that are done then. BadValue, Damaged as undo(), where it stays at the
    ///     last step that it came to.
    Result<void> goToStep(int index);
    QUndoStack& undoStack() const;

    // History ------------------------------------------------------------------------------------
    /// Gives a state of the history a name, or takes it away (empty). Errors: BadValue for a state
    /// that is not there, or a name over kMaxStateName bytes.
    /// \param steps  that are done in the state, 0 for the one before the first.
    Result<void> nameState(int steps, const std::string& name);
    /// Empty where it has none.
    const std::string& stateName(int steps) const;
    /// The document as it was or will be with so many steps done; null where there are not so many.
    /// Its solids may still have to be read from the file: loadState().
    std::shared_ptr<const DocumentState> stateAt(int steps) const;
    /// Merges the steps between named states, so that only those and the newest state stay; what
    /// was undone and could be done again goes, too. Never done by itself. The recorded script
    /// stays whole.
    Result<void> compactHistory();
    /// Takes a changed history (changeStep() in history_change.h) in place of this one.
    void replaceHistory(HistoryChange change);
    /// The history before replaceHistory(), as long as nothing else was done since.
    bool canTakeBackHistory() const;
    void takeBackHistory();

    // Files --------------------------------------------------------------------------------------
    /// Native document: state, history with every snapshot, ink, camera, thresholds. A name without
    /// .edgewright gets it (filePath() tells). Errors: BadValue for a name of a script, TooLarge,
    /// CannotWrite.
    Result<void> save(const QString& wanted);
    /// Writes the same into another file, and goes on with the one that it has.
    Result<void> saveCopy(const QString& wanted) const;
    /// Replaces everything, history included; on error nothing changes. Errors: of loadDocument().
    Result<void> open(const QString& path);
    /// Reads a file as a task for another thread; open() then takes what it gives. The solids of
    /// states that are not shown are read when somebody goes there (undo()), so that a long history
    /// is open at once; open() with a path reads all.
    std::function<Result<OpenedFile>()> openTask(const QString& path,
                                                 std::function<bool(double)> progress = {}) const;
    void open(OpenedFile opened);
    void reset();
    QString filePath() const;
    /// What the document is called in itself, whatever its file is called.
    const std::string& title() const;
    void setTitle(const std::string& title);
    /// Was the file written to or replaced by anyone else since it was opened or saved? False where
    /// it is gone: saving it then overwrites nothing.
    bool fileChangedByOthers() const;
    /// Does the file hold more than this version knows? Then nothing is saved over it.
    bool isReadOnly() const;
    bool isModified() const;
    /// Writes the surface, else the filleted cage, else the solid: .obj, .stl, .ply, .glb, .3mf by
    /// extension. A sentence for the person, or nothing, and the errors, of exportShape().
    Result<std::string> exportTo(const QString& path, const ExportOptions& options = {}) const;
    /// The same as a task on copies, for another thread. Call it once.
    std::function<Result<std::string>()> exportTask(const QString& path,
                                                    const ExportOptions& options) const;

    /// All that was done since the document was new, as a script that replays to this state.
    SketchScript recordedScript() const;

    /// All that a file holds.
    DocumentFile contents() const;

    // For a working copy -------------------------------------------------------------------------
    /// What changed since the last call, or all that there is. One caller only.
    DocumentUpdate takeUpdate(bool whole);
    /// Another number whenever another document takes this one's place (open, reset).
    long life() const;
    /// Is it as it was when its life began?
    bool untouched() const;
    /// Takes over what a working copy held, with the changes that are in no file yet.
    /// \param path  of the document's file, or empty.
    void restore(DocumentFile file, const QString& path);
    /// A small picture of the document for lists, as PNG; kept with it.
    void setThumbnail(std::string png);
    const std::string& thumbnail() const;

  signals:
    void changed(ew::DocumentChange what);

  public:
    struct Private;  ///< document_private.h; inside the document room only

  private:
    std::unique_ptr<Private> d_;
};

}  // namespace ew
