// The list of readers: what recognises what, and how proposals enter a project.
#include <set>

#include "tests/core/readers/reading.h"

namespace covaria::readers_test {

namespace {

TEST(Readers, HaveNamesAndWords) {
    std::set<std::string> names;
    for (const Reader& reader : reader_registry()) {
        EXPECT_TRUE(names.insert(reader.name).second) << reader.name;
        EXPECT_FALSE(reader.title.empty() || reader.pattern.empty() || reader.takes.empty()) << reader.name;
        EXPECT_EQ(find_reader(reader.name), &reader);
    }
    EXPECT_EQ(find_reader("nothing"), nullptr);
}

TEST(Readers, EveryReaderRefusesWhatIsNothing) {
    for (const Reader& reader : reader_registry())
        for (const std::string& text : {std::string(), std::string("\n\n"), std::string(100, '\0')}) {
            const auto read = reader.read(text, {.file_name = "x"});
            ASSERT_FALSE(read) << reader.name;
            EXPECT_FALSE(read.error().message.empty()) << reader.name;
        }
}

TEST(Readers, TheFileIsRecognised) {
    EXPECT_EQ((*reader_for(data("sa-groups.txt"), "jig.txt"))->name, "spatialanalyzer");
    EXPECT_EQ((*reader_for("\xEF\xBB\xBF" + data("points.csv"), "points.csv"))->name, "points");
    const auto none = reader_for("Dear reader,\nthis is a letter.\n", "letter.txt");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, ErrorCode::usage);
}

TEST(Readers, ProposalsGetIdsOfTheirOwn) {
    Project project;
    const auto read = read_with("spatialanalyzer", data("sa-groups.txt"), {.chosen = true});
    ASSERT_TRUE(read);
    add_to_project(project, *read);
    add_to_project(project, *read);
    ASSERT_EQ(project.assets.size(), 4u);
    EXPECT_EQ(project.assets[2].id, "jig-2");
    EXPECT_FALSE(MadeProject::make(project)->problems().has_errors());
}

}  // namespace

}  // namespace covaria::readers_test
