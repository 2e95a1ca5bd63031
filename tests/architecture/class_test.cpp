// Counts the lines of every class - its body and the definitions of its members, wherever they stand -
// against 200, or against its limit in large_classes.txt if it was longer when the rule came. That list
// may only shrink.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace covaria::class_test {
namespace {

namespace fs = std::filesystem;

const fs::path root = COVARIA_SOURCE_DIR;
constexpr std::size_t longest_class = 200;

std::vector<std::string> lines_of(const fs::path& file) {
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// Lines of "core/propagation/ReducedRun". Code is formatted by clang-format, so a class and a definition end
/// with a brace in the first column.
using Lengths = std::map<std::string, std::size_t>;

void count(const fs::path& file, Lengths& bodies, Lengths& definitions) {
    static const std::regex body(R"(^(?:class|struct) (\w+)(?: final)?(?: :[^:].*| \{)?$)"),
        definition(R"(^[A-Za-z].*?\b([A-Z]\w+)::~?\w+\()");
    const std::string folder = fs::relative(file, root).parent_path().generic_string() + "/";
    const std::vector<std::string> lines = lines_of(file);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch found;
        const bool is_body = std::regex_search(lines[i], found, body);
        if (!is_body && !std::regex_search(lines[i], found, definition)) continue;
        if (lines[i].ends_with(';')) continue;
        const std::size_t begin = i;
        while (i + 1 < lines.size() && !lines[i].starts_with("}")) ++i;
        (is_body ? bodies : definitions)[folder + found[1].str()] += i - begin + 1;
    }
}

Lengths lengths_of_classes() {
    Lengths bodies, definitions;
    for (const char* folder : {"core", "viz", "ui", "app"})
        for (const auto& entry : fs::recursive_directory_iterator(root / folder))
            if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
                count(entry.path(), bodies, definitions);
    for (auto& [name, length] : bodies)
        if (const auto more = definitions.find(name); more != definitions.end()) length += more->second;
    return bodies;
}

Lengths large_classes() {
    std::ifstream in(root / "tests/architecture/large_classes.txt");
    Lengths lengths;
    std::string name;
    for (std::size_t length = 0; in >> length >> name;) lengths[name] = length;
    return lengths;
}

TEST(Classes, AreNotLongerThanTheyMayBe) {
    const Lengths large = large_classes(), now = lengths_of_classes();
    ASSERT_GT(now.size(), 500u);
    for (const auto& [name, length] : now) {
        const auto listed = large.find(name);
        const std::size_t most = listed == large.end() ? longest_class : listed->second;
        EXPECT_LE(length, most) << name << ": which object with a life of its own is in it?";
    }
    for (const auto& [name, length] : large) {
        const auto found = now.find(name);
        EXPECT_TRUE(found != now.end() && found->second > longest_class)
            << name << " is short by now: take it off large_classes.txt";
    }
}

}  // namespace
}  // namespace covaria::class_test
