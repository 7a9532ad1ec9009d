// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/replay_arguments.h"

#include <QRegularExpression>

namespace ew {

namespace {

constexpr std::pair<const char*, bool PictureLook::*> kLookOptions[] = {
    {"--transparent", &PictureLook::transparent},  {"--cage", &PictureLook::cage},
    {"--hidden-edges", &PictureLook::hiddenEdges}, {"--dark", &PictureLook::dark},
    {"--occlusion", &PictureLook::occlusion},
};

constexpr int kLeastPicturePx = 16;
constexpr int kMostPicturePx = 16'384;

/// Walks through the arguments; an option's values are the arguments up to the next option.
class ArgumentReader {
  public:
    explicit ArgumentReader(const QStringList& arguments) : arguments_(arguments) {}
    Result<ReplayArguments> read();

  private:
    bool atOption() const { return arguments_[next_].startsWith('-') && arguments_[next_] != "-"; }
    bool atEnd() const { return next_ >= arguments_.size(); }

    Result<QString> value(const QString& option) {
        if (atEnd() || atOption()) {
            return fail(Errc::MissingKey, option.toStdString() + " needs a value.");
        }
        return arguments_[next_++];
    }

    Result<void> option(const QString& name);
    Result<void> text(const QString& name, QString& into);
    Result<void> exports();
    Result<void> faces(const QString& name);
    Result<void> unit(const QString& name);
    Result<void> bodies(const QString& name);
    Result<void> change(const QString& name);
    Result<void> script(const QString& path);

    const QStringList& arguments_;
    qsizetype next_ = 0;
    ReplayArguments out_;
};

Result<void> ArgumentReader::text(const QString& name, QString& into) {
    auto v = value(name);
    if (!v) return fail(v.error());
    if (v->isEmpty()) return fail(Errc::BadValue, name.toStdString() + " needs a value.");
    into = *v;
    return {};
}

Result<void> ArgumentReader::exports() {
    QString first;
    if (auto ok = text("--export", first); !ok) return ok;
    out_.exports << first;
    // A script may stand behind the files; no export format is called .json.
    while (!atEnd() && !atOption() && !arguments_[next_].endsWith(".json")) {
        out_.exports << arguments_[next_++];
    }
    return {};
}

Result<void> ArgumentReader::faces(const QString& name) {
    QString word;
    if (auto ok = text(name, word); !ok) return ok;
    const auto read = exportFacesFromName(word.toStdString());
    if (!read) {
        return fail(Errc::BadValue, name.toStdString() + " is simple, triangles or polygons.");
    }
    out_.faces = *read;
    return {};
}

Result<void> ArgumentReader::unit(const QString& name) {
    QString word;
    if (auto ok = text(name, word); !ok) return ok;
    const auto read = exportUnitFromName(word.toStdString());
    if (!read) return fail(Errc::BadValue, name.toStdString() + " is mm, cm, m or inch.");
    out_.unit = *read;
    return {};
}

Result<void> ArgumentReader::bodies(const QString& name) {
    QString list;
    if (auto ok = text(name, list); !ok) return ok;
    for (const QString& word : list.split(',')) {
        bool isNumber = false;
        out_.bodies.push_back(word.toInt(&isNumber));
        if (!isNumber || out_.bodies.back() < 0) {
            return fail(Errc::BadValue,
                        name.toStdString() + " takes numbers from 0 on, as in 0,2.");
        }
    }
    return {};
}

Result<void> ArgumentReader::change(const QString& name) {
    if (auto ok = text(name, out_.changedStep); !ok) return ok;
    return text(name, out_.stepText);
}

Result<void> ArgumentReader::option(const QString& name) {
    if (readLookOption(name, out_.look)) return {};
    if (name == "--help" || name == "-h")
        out_.help = true;
    else if (name == "--version")
        out_.version = true;
    else if (name == "--keep-going")
        out_.keepGoing = true;
    else if (name == "--allow-outside")
        out_.allowOutside = true;
    else if (name == "--progress")
        out_.progress = true;
    else if (name == "--out") {
        out_.namesOut = true;
        return text(name, out_.outFolder);
    } else if (name == "--work-copy")
        return text(name, out_.workCopy);
    else if (name == "--recover")
        return text(name, out_.recover);
    else if (name == "--save")
        return text(name, out_.save);
    else if (name == "--save-script")
        return text(name, out_.saveScript);
    else if (name == "--until")
        return text(name, out_.until);
    else if (name == "--report")
        return text(name, out_.report);
    else if (name == "--screenshot")
        return text(name, out_.screenshot);
    else if (name == "--export")
        return exports();
    else if (name == "--faces")
        return faces(name);
    else if (name == "--unit")
        return unit(name);
    else if (name == "--bodies")
        return bodies(name);
    else if (name == "--change-step")
        return change(name);
    else if (name == "--templates")
        return text(name, out_.templates.emplace());
    else if (name == "--size") {
        QString size;
        if (auto ok = text(name, size); !ok) return ok;
        auto parsed = parseSize(size);
        if (!parsed) return fail(parsed.error());
        out_.size = *parsed;
    } else {
        return fail(Errc::UnknownKey, "There is no option " + name.toStdString() + ".");
    }
    return {};
}

Result<void> ArgumentReader::script(const QString& path) {
    if (!out_.script.isEmpty()) {
        return fail(Errc::BadValue, "One script at a time: " + out_.script.toStdString() + " and " +
                                        path.toStdString() + " were given.");
    }
    out_.script = path;
    return {};
}

Result<ReplayArguments> ArgumentReader::read() {
    while (!atEnd()) {
        const bool isOption = atOption();
        QString argument = arguments_[next_++];
        const auto equals = argument.indexOf('=');
        if (isOption && argument.startsWith("--") && equals > 0) {
            return fail(Errc::UnknownKey, "Write " + argument.left(equals).toStdString() +
                                              " and its value as two arguments.");
        }
        if (auto ok = isOption ? option(argument) : script(argument); !ok) return fail(ok.error());
    }
    if (out_.help || out_.version) return out_;
    if (!out_.recover.isEmpty()) {
        if (out_.script.isEmpty()) return out_;
        return fail(Errc::BadValue, "--recover takes no script.");
    }
    if (out_.script.isEmpty()) return fail(Errc::MissingKey, "No script was given.");
    if (out_.size && out_.screenshot.isEmpty()) {
        return fail(Errc::BadValue, "--size goes with --screenshot.");
    }
    if (out_.look != PictureLook{} && out_.screenshot.isEmpty()) {
        const std::string option = lookOptions(out_.look).front().toStdString();
        return fail(Errc::BadValue, option + " goes with --screenshot.");
    }
    return out_;
}

}  // namespace

bool readLookOption(const QString& name, PictureLook& look) {
    for (const auto& [option, member] : kLookOptions) {
        if (name != QLatin1String(option)) continue;
        look.*member = true;
        return true;
    }
    return false;
}

QStringList lookOptions(const PictureLook& look) {
    QStringList out;
    for (const auto& [option, member] : kLookOptions) {
        if (look.*member) out << QLatin1String(option);
    }
    return out;
}

Result<QSize> parseSize(const QString& text) {
    static const QRegularExpression pattern("^([0-9]{1,5})x([0-9]{1,5})$");
    const auto match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    const auto fits = [](int n) { return n >= kLeastPicturePx && n <= kMostPicturePx; };
    if (!match.hasMatch() || !fits(size.width()) || !fits(size.height())) {
        return fail(Errc::BadValue, "A size is WxH in pixels, each from 16 to 16384; \"" +
                                        text.toStdString() + "\" is not.");
    }
    return size;
}

Result<ReplayArguments> parseReplayArguments(const QStringList& arguments) {
    return ArgumentReader(arguments).read();
}

QString replayHelp() {
    return QStringLiteral(
        "Usage: edgewright-replay SCRIPT|DOCUMENT [option...]\n"
        "       edgewright-replay --recover DIR [--out DIR2]\n"
        "Replays a sketch script without a window, or tells of a document what it tells of a\n"
        "script.\n"
        "\n"
        "  --out DIR              folder for what the script's save and export steps write; made\n"
        "                         if it is not there (default: the current folder)\n"
        "  --allow-outside        let these steps write, and open steps read, anywhere: absolute\n"
        "                         paths and paths that lead out of their folder with ..\n"
        "  --export FILE ...      write the surface, cage or solid at the end: .obj, .stl,\n"
        "                         .ply, .glb or .3mf\n"
        "  --faces WORD           what --export makes of flat faces in .obj and .ply: simple (at\n"
        "                         most four corners, else triangles; the default), triangles, or\n"
        "                         polygons (whole faces)\n"
        "  --unit WORD            unit of lengths in .obj, .stl and .ply: mm (the default), cm, m\n"
        "                         or inch\n"
        "  --bodies LIST          export these bodies only, counted from 0, as in 0,2\n"
        "  --change-step N JSON   change step N of a document's history, counted from 0, into "
        "this\n"
        "                         step of the same kind and do again what follows; what does not\n"
        "                         fit any more is named, its strokes are kept. --save writes it\n"
        "  --save FILE            write the document at the end\n"
        "  --screenshot FILE.png  write a picture of the viewport at the end, as .png or .jpg "
        "(needs\n"
        "                         a display, or Xvfb installed)\n"
        "  --size WxH             size of the picture (default: the script's viewport)\n"
        "  --transparent          no background and no grid in the picture\n"
        "  --cage                 the cage over the surface in the picture\n"
        "  --hidden-edges         hidden edges as dashes in the picture\n"
        "  --dark                 the picture in the colours of the dark theme\n"
        "  --occlusion            corners and hollows darker in the picture, as under an even sky\n"
        "  --until STEP           stop before a step: its index, or its name and which of that\n"
        "                         name it is, as in apply:3 (fillet is the first fillet)\n"
        "  --report FILE.json     write the report\n"
        "  --save-script FILE     write what was done as a sketch script\n"
        "  --work-copy DIR        keep a working copy in this folder, as the window does: a step\n"
        "                         that is told as done is safe, however the program ends\n"
        "  --progress             print \"done N\" after each step\n"
        "  --recover DIR          list the working copies in a folder as JSON; with --out also\n"
        "                         write each as a document\n"
        "  --keep-going           go on after a step that failed\n"
        "  --templates DIR        use the templates of this folder only\n"
        "  --version, --help\n"
        "\n"
        "Exit status: 0 every step succeeded; 1 a step failed; 2 the script or the arguments are\n"
        "unusable, or a file could not be written.\n");
}

}  // namespace ew
