// Reads every #include "..." of the source tree against the table of who may include whom, and every #include
// <...> against who may use Qt and VTK. ARCHITECTURE.md explains the table.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "core/kinds/registries.h"

namespace covaria::include_test {

namespace {

namespace fs = std::filesystem;

const fs::path root = COVARIA_SOURCE_DIR;

std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The names that follow `head` in a folder's CMakeLists.txt: its folders from the bottom up, as they are
/// built. Within core, its families and ui, a folder may include those before it.
std::vector<std::string> order_in(const std::string& folder, const std::string& head) {
    const std::regex list(head + R"(\s*([a-z_ ]+))"), name("[a-z_]+");
    const std::string text = text_of(root / folder / "CMakeLists.txt");
    std::vector<std::string> order;
    for (std::sregex_iterator found(text.begin(), text.end(), list), end; found != end; ++found) {
        const std::string names = (*found)[1];
        for (std::sregex_iterator one(names.begin(), names.end(), name); one != end; ++one)
            order.push_back(folder + "/" + one->str());
    }
    return order;
}

const std::vector<std::string> core_order = order_in("core", R"(set\(folders)");
const std::vector<std::string> family_order = order_in("core/kinds", R"(\ncovaria_family\()");
const std::vector<std::string> ui_order = order_in("ui", R"(foreach\(folder)");

// Formats of others, read or written, are known in the family that they are a part of; commands, windows and
// writers name it.
const std::set<std::string> readers = {"core/kinds/robot/urdf.h", "core/kinds/robot/arm_frames.h"};

// Families know no engine, although it stands above them in the list.
const std::set<std::string> unknown_to_kinds = {"core/propagation", "core/random", "core/result"};

/// "core/kinds/pose", "core/model", "app".
std::string folder_of(const fs::path& relative) {
    const std::string folder = relative.parent_path().generic_string();
    for (const char* whole : {"app", "tests"})
        if (folder.starts_with(whole)) return whole;
    return folder;
}

std::string floor_of(const std::string& folder) {
    return folder.starts_with("core/kinds/") ? "core/kinds" : folder;
}

bool at_or_before(const std::vector<std::string>& order, const std::string& user, const std::string& used) {
    const auto u = std::find(order.begin(), order.end(), user);
    const auto d = std::find(order.begin(), order.end(), used);
    return u != order.end() && d != order.end() && d <= u;
}

bool may_include(const std::string& user, const std::string& used) {
    if (user == used || user == "app") return true;
    if (floor_of(user) == "core/kinds" && unknown_to_kinds.contains(used)) return false;
    if (user.starts_with("core/kinds/") && floor_of(used) == "core/kinds")
        return at_or_before(family_order, user, used);
    // Who is above the families asks their list, not them.
    if (used.starts_with("core/kinds/") && user != "core/kinds") return false;
    if (user.starts_with("core/")) return at_or_before(core_order, floor_of(user), floor_of(used));
    if (user == "viz/scene")
        return used.starts_with("core/") && used != "core/report" && used != "core/document";
    if (user == "viz/vtk") return used == "viz/scene" || used == "core/text" || used == "core/base";
    if (user.starts_with("ui/"))
        return used.starts_with("core/") || used.starts_with("viz/") || at_or_before(ui_order, user, used);
    return false;
}

std::vector<fs::path> source_files() {
    std::vector<fs::path> files;
    for (const char* top : {"core", "viz", "ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(root / top))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
                files.push_back(entry.path());
    return files;
}

struct Include {
    std::string text;
    bool quoted;
    int line;
};

std::vector<Include> includes_of(const fs::path& file) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> found;
    std::ifstream in(file);
    std::string line;
    for (int number = 1; std::getline(in, line); ++number) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) found.push_back({match[2], match[1] == "\"", number});
    }
    return found;
}

TEST(Architecture, EveryFolderIncludesOnlyWhatItMay) {
    std::size_t checked = 0;
    for (const fs::path& file : source_files()) {
        const fs::path relative = fs::relative(file, root);
        for (const Include& include : includes_of(file)) {
            if (!include.quoted) continue;
            ++checked;
            EXPECT_TRUE(fs::exists(root / include.text))
                << relative << ":" << include.line << ": \"" << include.text
                << "\" is not a path from the root of the source tree";
            EXPECT_TRUE(readers.contains(include.text) ||
                        may_include(folder_of(relative), folder_of(include.text)))
                << relative << ":" << include.line << ": " << folder_of(relative) << " may not include "
                << include.text;
        }
    }
    EXPECT_GT(checked, 100u) << "the include statements were not found";
}

TEST(Architecture, QtAndVtkStayInTheirFolders) {
    static const std::regex qt("^Q[A-Z]|^Qt"), vtk("^vtk");
    for (const fs::path& file : source_files()) {
        const fs::path relative = fs::relative(file, root);
        const std::string folder = folder_of(relative);
        for (const Include& include : includes_of(file)) {
            if (std::regex_search(include.text, qt)) {
                EXPECT_TRUE(folder.starts_with("ui/") || folder == "app")
                    << relative << " includes " << include.text;
            }
            if (std::regex_search(include.text, vtk)) {
                EXPECT_EQ(folder, "viz/vtk") << relative << " includes " << include.text;
            }
        }
    }
}

TEST(Architecture, EveryFolderHasItsPlaceInTheOrder) {
    for (const fs::path& file : source_files()) {
        const std::string folder = folder_of(fs::relative(file, root));
        const auto& order = folder.starts_with("core/kinds/") ? family_order
                            : folder.starts_with("core/")     ? core_order
                                                              : ui_order;
        if (!folder.starts_with("core/") && !folder.starts_with("ui/")) continue;
        EXPECT_NE(std::find(order.begin(), order.end(), folder), order.end()) << folder;
    }
}

TEST(Architecture, NoFileGrowsIntoAMonster) {
    for (const fs::path& file : source_files()) {
        const std::string text = text_of(file);
        const auto lines = std::count(text.begin(), text.end(), '\n');
        EXPECT_LE(lines, 600) << fs::relative(file, root) << ": which of its parts has a life of its own?";
    }
}

TEST(Architecture, OnlyModelsAndAssetsNameAModelOrAnAssetKind) {
    std::set<std::string> ids;
    for (const ModelDescriptor& model : model_registry()) ids.insert(model.id);
    for (const AssetDescriptor& asset : asset_registry()) ids.insert(asset.kind);
    EXPECT_GE(ids.size(), 20u);
    for (const fs::path& file : source_files()) {
        const fs::path relative = fs::relative(file, root);
        const std::string floor = floor_of(folder_of(relative));
        // Readers say what a file becomes.
        if (floor == "core/kinds" || floor == "core/readers" || relative == "app/main.cpp") continue;
        const std::string text = text_of(file);
        for (const std::string& id : ids)
            EXPECT_EQ(text.find("\"" + id + "\""), std::string::npos) << relative << " names " << id;
    }
}

}  // namespace

}  // namespace covaria::include_test
