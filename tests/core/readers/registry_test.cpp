// The list of readers: what recognises what, and how proposals enter a project.
#include <set>

#include "core/readers/text_encoding.h"
#include "core/readers/unstated_units.h"
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
            EXPECT_FALSE(read.error().message.english().empty()) << reader.name;
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

TEST(TextForReaders, EncodingsOfOtherSystemsBecomeUtf8) {
    const std::string text = "K\xC3\xBCvette \xE2\x82\xAC \xF0\x9D\x9B\xBC\n";
    EXPECT_EQ(text_for_readers(text), text);
    EXPECT_EQ(text_for_readers(std::string("\xFF\xFEK\0\xFC\0\x35\xD8\xFC\xDE", 10)),
              "K\xC3\xBC\xF0\x9D\x9B\xBC");
    EXPECT_EQ(text_for_readers(std::string("\xFE\xFF\0K\xD8\x35", 6)), "K?") << "half a pair";
    EXPECT_EQ(text_for_readers("K\xFCvette \x80\n"), "K\xC3\xBCvette \xE2\x82\xAC\n");
    EXPECT_EQ(text_for_readers("a\rb\r"), "a\nb\n");
    for (const std::string kept :
         {"<?xml version='1.0' encoding='ISO-8859-1'?><a>\xFC</a>\n", "PK\x03\x04\xFC\r",
          "110001+0000\xFC"
          "100 21.322+00000000\n"})
        EXPECT_EQ(text_for_readers(kept), kept);
}

TEST(UnstatedUnits, AreListedAndCheckedByName) {
    Proposals proposals;
    ReadChoice choice;
    EXPECT_EQ(unstated_unit(choice, "T", "temperature", Unit(), proposals), Unit());
    choice.units.emplace("T", Unit::of("K"));
    EXPECT_EQ(unstated_unit(choice, "T", "temperature", Unit(), proposals), Unit::of("K"));
    EXPECT_EQ(proposals.unstated.size(), 1u);
    EXPECT_TRUE(check_stated_units(choice, proposals));
    choice.units.emplace("F", Unit::of("N"));
    const auto checked = check_stated_units(choice, proposals);
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().code, ErrorCode::usage);
    EXPECT_NE(checked.error().message.english().find("'F'"), std::string::npos);
}

}  // namespace

}  // namespace covaria::readers_test
