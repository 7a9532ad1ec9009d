// SPDX-License-Identifier: GPL-3.0-or-later
// Long work: random commands in documents that are saved, opened and exported now and then. Solids
// stay valid, memory stays flat, files stay small, and a deep history stays quick.
#include <gtest/gtest.h>
#include <malloc.h>

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QUndoStack>
#include <algorithm>
#include <random>
#include <set>

#include "core/document/document_compare.h"
#include "core/document/sketch_script_json.h"
#include "core/document/store.h"
#include "core/document/work_copy.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

/// How much is done; the whole number in `tests/run soak`.
int amount(const char* name, int brief) {
    bool ok = false;
    const int wanted = qEnvironmentVariableIntValue(name, &ok);
    return ok ? wanted : brief;
}

/// Memory that is in use [bytes]: what the process holds besides is the allocator's, which gives it
/// back or not.
std::size_t memoryHeld() {
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

/// Checks each solid once, as if it came from a file.
class SolidChecker {
  public:
    void check(const DocumentState& state) {
        for (const Body& body : state.bodies) {
            if (!seen_.insert(body.solid.serialize()).second) continue;
            ++checked_;
            const auto again = Solid::deserialize(*seen_.find(body.solid.serialize()));
            ASSERT_TRUE(again) << again.error().message;
            ASSERT_TRUE(again->identicalTo(body.solid));
        }
    }
    void forget() { seen_.clear(); }
    std::size_t checked() const { return checked_; }

  private:
    std::set<std::string> seen_;
    std::size_t checked_ = 0;
};

/// What the steps of a document hold, each content once [bytes].
std::size_t sumOfSteps(const DocumentFile& file) {
    std::size_t sum = 0;
    std::set<std::string> solids;
    for (const StoredCommand& c : file.commands) {
        for (const Body& body : c.after->bodies) solids.insert(body.solid.serialize());
        sum += c.name.size() + sizeof(Pose);
    }
    for (const std::string& solid : solids) sum += solid.size();
    constexpr std::size_t kSampleBytes = 32;
    for (const PendingStroke& s : file.strokes) sum += s.stroke.samples.size() * kSampleBytes;
    for (const Recorder::Entry& e : file.script) sum += stepJson(e.step).size();
    return sum;
}

TEST(Soak, RandomWorkStaysValidSmallAndFlat) {
    const int commands = amount("EDGEWRIGHT_SOAK", 1'500);
    constexpr int kRound = 500;  // commands in one document
    constexpr std::size_t kEmptyFile = 128U << 10U;
    const QTemporaryDir folder;
    const QString path = folder.filePath("soak.edgewright");
    std::mt19937 random(5);
    const auto upTo = [&](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    SolidChecker solids;
    std::size_t warm = 0;
    std::size_t most = 0;
    const auto d = test::fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.filePath("work")));
    for (int done = 0; done < commands; ++done) {
        test::doSomething(*d, upTo(test::kDeeds), upTo(30));
        solids.check(d->state());
        if (HasFatalFailure()) return;
        if (done % 50 == 49) {
            ASSERT_TRUE(copy.flush());
            if (!d->state().bodies.empty()) {
                const auto out = d->exportTo(folder.filePath("soak.obj"));
                const bool allHidden = !out && out.error().code == Errc::NoSolid;
                ASSERT_TRUE(out || allHidden || d->shape()->problem) << out.error().message;
            }
        }
        if (done % kRound != kRound - 1) continue;
        ASSERT_TRUE(d->save(path));
        EXPECT_LE(static_cast<std::size_t>(QFileInfo(path).size()),
                  2 * sumOfSteps(d->contents()) + kEmptyFile);
        const auto opened = test::fakeDocument();
        const auto ok = opened->open(path);
        ASSERT_TRUE(ok) << ok.error().message;
        ASSERT_TRUE(identicalDocuments(*d, *opened));
        d->reset();
        solids.forget();
        const std::size_t held = memoryHeld();
        if (done % (20 * kRound) == kRound - 1) {
            std::printf("%d commands: %zu MiB\n", done + 1, held >> 20U);
            std::fflush(stdout);
        }
        // Pools and caches fill in the first rounds.
        if (done < commands / 3)
            warm = std::max(warm, held);
        else
            most = std::max(most, held);
    }
    EXPECT_GT(solids.checked(), static_cast<std::size_t>(commands) / 100);
#if !defined(__SANITIZE_ADDRESS__)
    constexpr double kLittle = 1U << 20U;  // of what is held so little that a list more shows
    EXPECT_LE(static_cast<double>(most), 1.1 * static_cast<double>(warm) + kLittle);
#endif
}

TEST(Soak, ADeepHistoryStaysQuick) {
    const int depth = amount("EDGEWRIGHT_DEPTH", 1'000);
    const QTemporaryDir folder;
    const auto d = test::fakeDocument();
    WorkCopy copy(*d, WorkFolder(folder.filePath("work")));
    ASSERT_TRUE(d->addStroke(test::line({0, 5}, {50, 60})));
    ASSERT_TRUE(d->apply());
    std::vector<double> commandMs, undoMs;
    QElapsedTimer clock;
    const auto timed = [&](std::vector<double>& into, const auto& deed) {
        clock.start();
        deed();
        into.push_back(static_cast<double>(clock.nsecsElapsed()) / 1e6);
    };
    // Growth per step in proportion to what changed: the second half is no dearer than the first.
    std::array<qint64, 2> bytes{};
    for (int i = 1; i < depth; ++i) {
        EdgeChoice edge;
        edge.which = EdgeChoice::Which::Picked;
        edge.picked = {{0, i % 12}};
        timed(commandMs, [&] { ASSERT_TRUE(d->crease(edge, 1.0 + 8.0 * (i % 1'000) / 1'000)); });
        if (i == depth / 2 || i == depth - 1) {
            ASSERT_TRUE(copy.flush());
            ASSERT_TRUE(d->save(folder.filePath("deep.edgewright")));
            bytes[i == depth / 2 ? 0 : 1] = QFileInfo(folder.filePath("deep.edgewright")).size();
        }
    }
    ASSERT_EQ(d->undoStack().count(), depth);
    EXPECT_LT(static_cast<double>(bytes[1]), 2.2 * static_cast<double>(bytes[0]));
    const auto opened = test::fakeDocument();
    clock.start();
    ASSERT_TRUE(opened->open(folder.filePath("deep.edgewright")));
    const auto openMs = static_cast<long long>(clock.elapsed());
    for (int i = 0; i < depth; ++i) timed(undoMs, [&] { ASSERT_TRUE(opened->undo()); });
    const auto median = [](std::vector<double> v) {
        std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
        return v[v.size() / 2];
    };
    std::printf("depth %d: command %.3f ms, undo %.3f ms (medians), open %lld ms\n", depth,
                median(commandMs), median(undoMs), openMs);
    EXPECT_LT(median(undoMs), 30.0);
}

}  // namespace
}  // namespace ew
