// The shipped library: enough of it, every figure with a source, every body with a picture.
#include "core/made/library.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "core/kinds/registries.h"
#include "core/made/made_project.h"

namespace covaria::library_test {
namespace {

Library shipped() {
    setenv("COVARIA_LIBRARY_DIR", "/nowhere", 1);
    return load_library();
}

TEST(ShippedLibrary, HasInstrumentsAndRobotsWithSources) {
    const Library library = shipped();
    EXPECT_TRUE(library.problems.empty());
    int robots = 0, others = 0;
    std::set<std::string> ids;
    for (const LibraryItem& item : library.items) {
        const AssetDescriptor* kind = find_asset_kind(item.asset.kind);
        ASSERT_NE(kind, nullptr) << item.asset.id;
        ++(kind->category == AssetCategory::robot ? robots : others);
        EXPECT_TRUE(ids.insert(item.asset.id).second) << item.asset.id;
        EXPECT_GT(item.asset.notes.size(), 40U) << item.asset.id << ": where do its figures come from?";
    }
    EXPECT_GE(robots, 12);
    EXPECT_GE(others, 20);
}

TEST(ShippedLibrary, EveryBodyHasAPicture) {
    for (const LibraryItem& item : shipped().items) {
        Project project;
        project.assets.push_back(item.asset);
        const auto made = MadeProject::make(std::move(project));
        const AssetLibrary::Entry* entry = made->assets().find(item.asset.id);
        ASSERT_TRUE(entry && entry->asset) << item.asset.id;
        const Layout layout = entry->asset->layout();
        EXPECT_EQ(item.picture.empty(), layout.bodies.empty() && layout.links.empty())
            << item.asset.id << ": scripts/pictures makes it";
    }
}

TEST(ShippedLibrary, ASearchWantsAllWordsInAnyCase) {
    const std::vector<std::string> texts{"Leica AT960", "Laser trackers"};
    EXPECT_TRUE(has_words(texts, "TRACKER leica"));
    EXPECT_FALSE(has_words(texts, "tracker faro"));
    EXPECT_TRUE(has_words(texts, "  "));
}

}  // namespace
}  // namespace covaria::library_test
