// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/practice/practice_json.h"

#include <QDateTime>

#include "core/document/json_text.h"
#include "core/document/practice/practice_shape.h"

namespace ew {

using nlohmann::json;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kMostCount = 1'000'000;

double readAmount(const json& value, const std::string& place, double most) {
    const double amount = readNumber(value, place);
    if (!(amount >= 0.0 && amount <= most)) throwRead(Errc::BadValue, place + ": out of range");
    return amount;
}

PracticeResult readResult(const json& value, const std::string& place) {
    const ObjectReader in(value, place);
    PracticeResult out;
    const QDateTime time = QDateTime::fromString(
        QString::fromStdString(readString(in.require("time"), place + "/time")), Qt::ISODate);
    if (!time.isValid()) throwRead(Errc::BadValue, place + "/time: no time");
    out.time = time.toSecsSinceEpoch();
    out.level = readInt(in.require("level"), place + "/level", 1, kPracticeLevels);
    constexpr double kMostSeed = 4294967295.0;
    out.seed =
        static_cast<std::uint32_t>(readAmount(in.require("seed"), place + "/seed", kMostSeed));
    out.accuracy = readAmount(in.require("accuracy"), place + "/accuracy", 1.0);
    out.seconds = readAmount(in.require("seconds"), place + "/seconds", kMostCount);
    out.wobblePx = readAmount(in.require("wobble_px"), place + "/wobble_px", kMostCount);
    out.strokes = readInt(in.require("strokes"), place + "/strokes", 0, kMostCount);
    return out;
}

}  // namespace

Json practiceJson(const std::vector<PracticeResult>& results) {
    Json out = Json::array();
    for (const PracticeResult& r : results) {
        out.push_back(
            {{"time",
              QDateTime::fromSecsSinceEpoch(r.time, Qt::UTC).toString(Qt::ISODate).toStdString()},
             {"level", r.level},
             {"seed", r.seed},
             {"accuracy", r.accuracy},
             {"seconds", r.seconds},
             {"wobble_px", r.wobblePx},
             {"strokes", r.strokes}});
    }
    return out;
}

std::vector<PracticeResult> practiceFromJson(const json& value, const std::string& place) {
    std::vector<PracticeResult> out;
    const json::array_t& list = readArray(value, place);
    for (std::size_t i = 0; i < list.size(); ++i) {
        addResult(out, readResult(list[i], place + "/" + std::to_string(i)));
    }
    return out;
}

}  // namespace ew
