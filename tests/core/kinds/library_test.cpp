// The library of assets: what is shipped, and what users add.
#include "core/made/library.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "core/kinds/registries.h"
#include "tests/core/made.h"

namespace covaria::library_test {
namespace {

namespace fs = std::filesystem;

/// A folder of its own as the user's library.
class OwnLibrary : public testing::Test {
protected:
    OwnLibrary() : folder_(fs::temp_directory_path() / ("covaria-library-" + std::to_string(::getpid()))) {
        fs::remove_all(folder_);
        ::setenv("COVARIA_LIBRARY_DIR", folder_.c_str(), 1);
    }
    ~OwnLibrary() override {
        ::unsetenv("COVARIA_LIBRARY_DIR");
        fs::remove_all(folder_);
    }
    static std::vector<LibraryItem> own_items() {
        Library library = load_library();
        std::erase_if(library.items, [](const LibraryItem& item) { return !item.own; });
        return library.items;
    }
    static AssetEntry shipped(const std::string& id) {
        for (const LibraryItem& item : load_library().items)
            if (item.asset.id == id) return item.asset;
        ADD_FAILURE() << "no " << id << " in the library";
        return {};
    }
    fs::path folder_;
};

TEST_F(OwnLibrary, ShippedAssetsAreCompleteAndSayWhereTheyComeFrom) {
    const Library library = load_library();
    EXPECT_TRUE(library.problems.empty());
    EXPECT_GE(library.items.size(), 12u);
    Project project;
    std::set<std::string> names;
    for (const LibraryItem& item : library.items) {
        EXPECT_FALSE(item.own);
        EXPECT_GT(item.asset.notes.size(), 40u) << item.asset.name << " does not state its source";
        EXPECT_TRUE(names.insert(item.asset.name).second) << item.asset.name << " is there twice";
        project.assets.push_back(item.asset);
        project.assets.back().id = "a" + std::to_string(project.assets.size());
    }
    Problems problems;
    const AssetLibrary assets = made_assets(project, problems);
    EXPECT_FALSE(problems.has_errors());
    for (const AssetEntry& entry : project.assets) {
        ASSERT_NE(assets.find(entry.id), nullptr) << entry.name;
        EXPECT_NE(assets.find(entry.id)->asset, nullptr) << entry.name;
    }
}

TEST_F(OwnLibrary, KeepsAndReplacesByName) {
    EXPECT_TRUE(own_items().empty());
    AssetEntry asset = shipped("leica-at500");
    asset.name = "Tracker of hall 3";
    ASSERT_TRUE(add_to_own_library(asset));
    asset.notes = "certificate of 2026-05-04";
    ASSERT_TRUE(add_to_own_library(asset));
    AssetEntry other = asset;
    other.name = "Tracker of hall 4";
    ASSERT_TRUE(add_to_own_library(other));
    const std::vector<LibraryItem> items = own_items();
    ASSERT_EQ(items.size(), 2u);
    EXPECT_EQ(items[0].asset, asset);
    EXPECT_EQ(items[1].asset.name, "Tracker of hall 4");
    EXPECT_NE(items[1].asset.id, items[0].asset.id);
    EXPECT_EQ(items[0].collection, "My library");
}

TEST_F(OwnLibrary, RefusesAssetsThatReferToOthers) {
    const AssetDescriptor* network = find_asset_kind("sensor-network");
    ASSERT_NE(network, nullptr);
    AssetEntry entry{"net", "sensor-network", "Network", "", {}};
    SetupTable sensors;
    sensors.units = {Unit{}};
    sensors.rows = {{std::string("tracker")}};
    entry.setup.values["sensors"] = sensors;
    const Result<void> kept = add_to_own_library(entry);
    ASSERT_FALSE(kept);
    EXPECT_NE(kept.error().message.english().find("Network refers to other assets"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(OwnLibrary, BrokenFilesAreNamedAndLeftAlone) {
    fs::create_directories(folder_);
    std::ofstream(folder_ / "my-library.covaria") << "{ broken";
    const Library library = load_library();
    EXPECT_GE(library.items.size(), 12u) << "the rest is still there";
    ASSERT_TRUE(library.problems.has_errors());
    EXPECT_NE(library.problems.items().front().message.english().find("my-library.covaria"),
              std::string::npos);
    EXPECT_FALSE(add_to_own_library(shipped("leica-ts60")));
    std::ifstream in(folder_ / "my-library.covaria");
    EXPECT_EQ(std::string((std::istreambuf_iterator<char>(in)), {}), "{ broken");
}

}  // namespace
}  // namespace covaria::library_test
