// The asset "context mesh": made, warned of, and without influence on any number.
#include <gtest/gtest.h>

#include "core/base/file_io.h"
#include "core/base/resource_path.h"
#include "core/made/load_project.h"
#include "core/project/linked_files.h"
#include "tests/fresh_folder.h"
#include "tests/stl_files.h"

namespace covaria::context_mesh_test {
namespace {

namespace fs = std::filesystem;

class ContextMeshTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(write_file_atomically(folder_ / "cell.stl",
                                          test::binary_stl(test::rectangle(0, 0, 2000, 1000, 500))));
    }

    AssetEntry cell(const std::string& file = "cell.stl") const {
        PoseValue placement;
        placement.position = {100, 200, 300};
        AssetEntry entry{"cell", "context-mesh", "Cell", {}, {}};
        entry.setup.values = {{"file", file},
                              {"placement", placement},
                              {"colour", std::string("blue")},
                              {"opacity", Quantity{40.0, Unit::of("%")}}};
        return entry;
    }
    Project project(std::vector<AssetEntry> assets) const {
        Project made;
        made.directory = folder_;
        made.assets = std::move(assets);
        return made;
    }
    static std::vector<LayoutMesh> meshes_of(const MadeProject& made) {
        const AssetLibrary::Entry* entry = made.assets().find("cell");
        return entry && entry->asset ? entry->asset->layout().meshes : std::vector<LayoutMesh>{};
    }
    static std::string warning(const MadeProject& made) {
        const Problems problems = made.problems();
        EXPECT_FALSE(problems.has_errors());
        EXPECT_EQ(problems.items().size(), 1U);
        if (problems.items().empty()) return {};
        EXPECT_EQ(problems.items().front().path, "/assets/0/setup/file");
        return problems.items().front().message.english();
    }

    fs::path folder_ = test::fresh_folder("context-mesh");
};

TEST_F(ContextMeshTest, IsWhereAndHowTheSetUpSays) {
    const auto made = MadeProject::make(project({cell()}));
    EXPECT_TRUE(made->problems().items().empty());
    const auto meshes = meshes_of(*made);
    ASSERT_EQ(meshes.size(), 1U);
    const LayoutMesh& mesh = meshes.front();
    EXPECT_EQ(mesh.triangles->triangles(), 2U);
    EXPECT_EQ(mesh.scale, 1e-3);
    EXPECT_TRUE(mesh.X_WM.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0.3)));
    EXPECT_EQ(mesh.colour, MeshColour::blue);
    EXPECT_DOUBLE_EQ(mesh.opacity, 0.4);
    EXPECT_EQ(mesh.source.path, "/placement");
}

TEST_F(ContextMeshTest, UnitsAreChosen) {
    for (const auto& [unit, metres] : {std::pair{"mm", 1e-3}, {"m", 1.0}, {"in", 0.0254}}) {
        AssetEntry entry = cell();
        entry.setup.values["unit"] = std::string(unit);
        EXPECT_EQ(meshes_of(*MadeProject::make(project({entry}))).front().scale, metres);
    }
}

TEST_F(ContextMeshTest, AFileThatCannotBeReadIsWarnedOf) {
    EXPECT_NE(warning(*MadeProject::make(project({cell("none.stl")}))).find("none.stl"), std::string::npos);
    ASSERT_TRUE(write_file_atomically(folder_ / "bad.stl",
                                      "solid s\n" + test::ascii_facet("0 0 0", "1 nan 0", "0 1 0")));
    const auto made = MadeProject::make(project({cell("bad.stl")}));
    EXPECT_EQ(warning(*made),
              "The mesh is not drawn: 'bad.stl': line 5, triangle 1 has a coordinate that is not a finite "
              "number");
    EXPECT_TRUE(meshes_of(*made).empty());
    EXPECT_NE(warning(*MadeProject::make(project({cell(".")}))), "") << "a folder";
}

TEST_F(ContextMeshTest, IsMadeAnewWhenItsFileChangesAndElseTakenOver) {
    const Project now = project({cell()});
    const auto first = MadeProject::make(now);
    const auto second = MadeProject::make(now, first);
    EXPECT_EQ(second->counts().assets, 0U);
    EXPECT_EQ(second->counts().taken, 1U);
    ASSERT_TRUE(write_file_atomically(folder_ / "cell.stl",
                                      test::binary_stl({test::rectangle(0, 0, 1, 1, 0).front()})));
    const auto third = MadeProject::make(now, second);
    EXPECT_EQ(third->counts().assets, 1U);
    EXPECT_EQ(meshes_of(*third).front().triangles->triangles(), 1U);
    AssetEntry red = cell();
    red.setup.values["colour"] = std::string("red");
    const auto fourth = MadeProject::make(project({red}), third);
    EXPECT_EQ(meshes_of(*fourth).front().triangles, meshes_of(*third).front().triangles)
        << "another colour reads no file";
}

TEST_F(ContextMeshTest, InfluencesNoNumber) {
    const LoadedProject loaded = load_project(data_directory() / "projects/stewart-platform.covaria");
    ASSERT_FALSE(loaded.problems.has_errors());
    Project with = loaded.project;
    with.assets.push_back(cell((folder_ / "cell.stl").string()));
    const auto made = MadeProject::make(with, loaded.made);
    EXPECT_EQ(made->counts().models, 0U) << "no analysis is made anew";
    for (const AnalysisEntry& entry : with.analyses) {
        const auto before = loaded.made->analysis(entry.id), after = made->analysis(entry.id);
        ASSERT_TRUE(before && after) << entry.id;
        EXPECT_TRUE(same_numbers(*before, *after));
        EXPECT_EQ(before->fingerprint(), after->fingerprint());
        auto run = [](const PreparedAnalysis& analysis) {
            PreparedAnalysis small = analysis;
            small.options.trials = 10'000;
            return run_analysis(small);
        };
        const auto a = run(*before), b = run(*after);
        ASSERT_TRUE(a && b);
        ASSERT_EQ(a->outputs.size(), b->outputs.size());
        for (std::size_t i = 0; i < a->outputs.size(); ++i) {
            EXPECT_EQ(a->outputs[i].estimate, b->outputs[i].estimate);
            EXPECT_EQ(a->outputs[i].expanded_uncertainty, b->outputs[i].expanded_uncertainty);
        }
    }
}

TEST_F(ContextMeshTest, ItsFileIsNamedOnceAmongThoseThatGoAlong) {
    Project two = project({cell(), cell("  ")});
    two.assets[1].id = "other";
    two.certificate.logo = "logo.png";
    EXPECT_EQ(context_files(two), (std::vector<std::string>{"cell.stl", "logo.png"}));
}

}  // namespace
}  // namespace covaria::context_mesh_test
