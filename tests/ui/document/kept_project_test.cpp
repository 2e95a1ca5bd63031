// A project in the history: whole, and with its neighbours' entries in common.
#include "ui/document/kept_project.h"

#include <gtest/gtest.h>

#include "core/base/resource_path.h"
#include "core/made/load_project.h"

namespace covaria::ui::kept_project_test {
namespace {

Project chain() {
    return load_project(data_directory() / "projects/chain.covaria").project;
}

TEST(KeptProject, ComesBackAsItWas) {
    const Project project = chain();
    const Project back = KeptProject::keep(project, nullptr)->project();
    EXPECT_EQ(back, project);
    EXPECT_EQ(back.directory, project.directory);
}

TEST(KeptProject, HasAllButTheChangedEntryInCommonWithItsNeighbour) {
    Project project = chain();
    const std::size_t entries = project.assets.size() + project.analyses.size();
    ASSERT_GT(entries, 4u);
    const auto before = KeptProject::keep(project, nullptr);
    project.analyses[1].name = "another name";
    const auto after = KeptProject::keep(project, before.get());
    EXPECT_EQ(after->project(), project);
    EXPECT_EQ(after->shared_with(*before), entries - 1);
    project.title = "another title";
    std::swap(project.assets[0], project.assets[1]);
    const auto moved = KeptProject::keep(project, after.get());
    EXPECT_EQ(moved->project(), project);
    EXPECT_EQ(moved->shared_with(*after), entries);
    EXPECT_FALSE(*moved == *after);
    EXPECT_TRUE(*KeptProject::keep(project, nullptr) == *moved);
}

}  // namespace
}  // namespace covaria::ui::kept_project_test
