// Messages: worded in English and through a catalogue, each text in the list that catalogues are filled from.
#include "core/base/message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace covaria::message_test {
namespace {

std::string in_brackets(const std::string& english) {
    return "[" + english + "]";
}

TEST(Messages, HaveTheirArgumentsInPlace) {
    const Message message = tell<"'%2' has %1 rows">(3, "table");
    EXPECT_EQ(message.english(), "'table' has 3 rows");
    EXPECT_EQ(message.in(in_brackets), "['table' has 3 rows]");
    EXPECT_EQ(tell<"%1 and again %1">("a").english(), "a and again a");
    EXPECT_EQ(tell<"%1">("%1 of 50 %").english(), "%1 of 50 %") << "what stands in an argument stays";
    EXPECT_EQ(tell<"the sign %1">(',').english(), "the sign ,");
}

TEST(Messages, TranslateTheirOwnWordsOnly) {
    const std::string name = "as typed";
    EXPECT_EQ(Message(name).in(in_brackets), "as typed");
    EXPECT_EQ(Message::declared("a title").in(in_brackets), "[a title]");
    EXPECT_EQ(tell<"%1: %2">(name, tell<"no value">()).in(in_brackets), "[as typed: [no value]]");
    EXPECT_EQ((name + ": " + tell<"no value">()).in(in_brackets), "as typed: [no value]");
    EXPECT_EQ(Message().in(in_brackets), "");
}

TEST(Messages, OrderOfWordsIsThatOfTheLanguage) {
    const Message message = tell<"%1 of %2">("3", "7");
    EXPECT_EQ(message.in([](const std::string&) { return "%2 % %1"; }), "7 % 3");
}

TEST(Messages, JoinedAreOneMessage) {
    Message message = tell<"first">();
    message += ", ";
    message += tell<"second">();
    EXPECT_EQ(message.in(in_brackets), "[first], [second]");
    EXPECT_EQ(Message() + message, message);
    EXPECT_EQ(message + Message(), message);
}

/// Never called: its text is known by being in the program.
[[maybe_unused]] Message unsaid() {
    return tell<"test only: said by nobody">();
}

TEST(Messages, AreKnownWithoutBeingSaid) {
    std::set<std::string> known;
    for (const char* words : Message::all_words())
        EXPECT_TRUE(known.insert(words).second) << words << " stands twice";
    EXPECT_TRUE(known.contains("test only: said by nobody"));
    EXPECT_TRUE(known.contains("'%2' has %1 rows"));
}

TEST(Messages, ATextThatIsKeptAsOneIsInTheListToo) {
    EXPECT_EQ(known_text<"the head of a table in a test">(), "the head of a table in a test");
    EXPECT_TRUE(std::ranges::any_of(Message::all_words(), [](const char* words) {
        return std::string(words) == "the head of a table in a test";
    }));
}

}  // namespace
}  // namespace covaria::message_test
