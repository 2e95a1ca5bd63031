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

namespace {

namespace fs = std::filesystem;

const fs::path root = COVARIA_SOURCE_DIR;

// The folders from the bottom up. Within core and within ui, a folder may include those above it in this
// list.
const std::vector<std::string> core_order = {
    "core/base",    "core/math",   "core/equation",    "core/random", "core/quantity",
    "core/model",   "core/result", "core/propagation", "core/assets", "core/models",
    "core/project", "core/made",   "core/study",       "core/report"};
const std::vector<std::string> ui_order = {"ui/theme",    "ui/charts",     "ui/print",  "ui/jobs",
                                           "ui/document", "ui/run",        "ui/export", "ui/models",
                                           "ui/forms",    "ui/scene_view", "ui/pages",  "ui/main_window"};

// core/models and core/assets know no engine, although it stands above them in the list.
const std::set<std::pair<std::string, std::string>> forbidden = {
    {"core/assets", "core/propagation"}, {"core/assets", "core/random"}, {"core/assets", "core/result"},
    {"core/models", "core/propagation"}, {"core/models", "core/random"}, {"core/models", "core/result"}};

std::string folder_of(const fs::path& relative) {
    auto part = relative.begin();
    const std::string top = part->string();
    if (top == "app" || top == "tests") return top;
    return top + "/" + std::next(part)->string();
}

bool at_or_before(const std::vector<std::string>& order, const std::string& user, const std::string& used) {
    const auto u = std::find(order.begin(), order.end(), user);
    const auto d = std::find(order.begin(), order.end(), used);
    return u != order.end() && d != order.end() && d <= u;
}

bool may_include(const std::string& user, const std::string& used) {
    if (user == used || user == "app") return true;
    if (forbidden.contains({user, used})) return false;
    if (user.starts_with("core/")) return at_or_before(core_order, user, used);
    if (user == "viz/scene") return used.starts_with("core/") && used != "core/report";
    if (user == "viz/vtk") return used == "viz/scene" || used.starts_with("core/base");
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
            EXPECT_TRUE(may_include(folder_of(relative), folder_of(include.text)))
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

TEST(Architecture, NoFileGrowsIntoAMonster) {
    for (const fs::path& file : source_files()) {
        std::ifstream in(file);
        const auto lines = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
        EXPECT_LE(lines, 600) << fs::relative(file, root) << ": which of its parts has a life of its own?";
    }
}

/// The ids in a registry.cpp's folder: text literals that follow `.id = ` or `.kind = `.
std::set<std::string> ids_defined_in(const std::string& folder) {
    static const std::regex pattern(R"re(\.(?:id|kind)\s*=\s*"([a-z][a-z0-9-]+)")re");
    std::set<std::string> ids;
    for (const auto& entry : fs::directory_iterator(root / folder)) {
        std::ifstream in(entry.path());
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
            ids.insert((*it)[1]);
    }
    return ids;
}

TEST(Architecture, OnlyModelsAndAssetsNameAModelOrAnAssetKind) {
    std::set<std::string> ids = ids_defined_in("core/models");
    ids.merge(ids_defined_in("core/assets"));
    EXPECT_GE(ids.size(), 3u)
        << "the ids were not found: does the pattern still fit core/models and core/assets?";
    for (const fs::path& file : source_files()) {
        const fs::path relative = fs::relative(file, root);
        const std::string folder = folder_of(relative);
        if (folder == "core/models" || folder == "core/assets" || relative == "app/main.cpp") continue;
        std::ifstream in(file);
        const std::string text((std::istreambuf_iterator<char>(in)), {});
        for (const std::string& id : ids)
            EXPECT_EQ(text.find("\"" + id + "\""), std::string::npos) << relative << " names " << id;
    }
}

}  // namespace
