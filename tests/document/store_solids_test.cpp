// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_solids.h"

#include <gtest/gtest.h>

#include <QUndoStack>
#include <memory>
#include <optional>

#include "tests/document/fixtures.h"
#include "tests/document/store_rows.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;
using test::withRow;

/// A document whose solid was deleted again, so that what is shown first has none.
std::unique_ptr<Document> afterASolid() {
    auto d = fakeDocument();
    EXPECT_TRUE(d->addStroke(line({0, 0}, {5, 5})));
    EXPECT_TRUE(d->apply());
    EXPECT_TRUE(d->deleteBodies());
    return d;
}

TEST(StoreSolids, SolidsThatAreNotShownAreReadWhenSomebodyGoesThere) {
    const auto bytes = writeDocument(afterASolid()->contents());
    const auto file = readDocument(*bytes, test::smallLibrary(), {.whole = false});
    ASSERT_TRUE(file);
    const Solid& solid = file->commands[0].after->bodies[0].solid;
    EXPECT_FALSE(solid.isLoaded());
    EXPECT_TRUE(*writeDocument(*file) == *bytes);
    EXPECT_FALSE(solid.isLoaded()) << "to write it again, nothing need be read";
    const auto d = fakeDocument();
    d->restore(*file, {});
    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(solid.isLoaded());
    EXPECT_EQ(d->state().bodies[0].solid.faces().size(), 6U);
    EXPECT_TRUE(*writeDocument(*file) == *bytes);

    const auto shown =
        readDocument(*writeDocument(d->contents()), test::smallLibrary(), {.whole = false});
    ASSERT_TRUE(shown);
    EXPECT_TRUE(shown->stateAt(1)->bodies[0].solid.isLoaded()) << "what is shown is there";
}

TEST(StoreSolids, ASolidThatIsNoneKeepsFromGoingThereAndFromNothingElse) {
    const auto bytes = writeDocument(afterASolid()->contents());
    const std::string broken = "edgewright-solid 1\nvertices 1\n0 0 0\nfaces 0\n";
    std::size_t number = 0;
    std::optional<std::size_t> found;
    auto db = Database::overBytes(*bytes, schema::kKind);
    ASSERT_TRUE(db->each(schema::kBlob, [&](const Row& row) -> Result<void> {
        const auto text = unpackBlob({std::get<Bytes>(row[1]).data, std::get<Bytes>(row[4]).data,
                                      static_cast<std::size_t>(std::get<std::int64_t>(row[2])),
                                      std::get<std::int64_t>(row[3]) == 1});
        if (text && text->starts_with("edgewright-solid")) found = number;
        ++number;
        return {};
    }));
    ASSERT_TRUE(found);
    const std::string bad = withRow(*bytes, schema::kBlob, *found, [&](Row& row) {
        const auto [data, packed] = packBlob(broken);
        row[1] = Bytes{contentHash(broken)};
        row[2] = static_cast<std::int64_t>(broken.size());
        row[3] = std::int64_t{packed ? 1 : 0};
        row[4] = Bytes{data};
    });
    EXPECT_FALSE(readDocument(bad, test::smallLibrary()));
    const auto file = readDocument(bad, test::smallLibrary(), {.whole = false});
    ASSERT_TRUE(file) << file.error().message;
    const auto d = fakeDocument();
    d->restore(*file, {});
    for (int i = 0; i < 2; ++i) {
        const auto undone = d->undo();
        ASSERT_FALSE(undone);
        EXPECT_EQ(undone.error().code, Errc::Damaged);
        EXPECT_FALSE(d->goToStep(0));
        EXPECT_EQ(d->undoStack().index(), 2);
        EXPECT_TRUE(d->state().bodies.empty());
    }
    EXPECT_TRUE(*writeDocument(d->contents()) == *writeDocument(*file)) << "nothing is lost";
}

}  // namespace
}  // namespace ew
