// Names of the program among those that people give: English in files, translated for people.
#include "core/base/own_names.h"

#include <gtest/gtest.h>

#include <string>

namespace covaria::own_names_test {
namespace {

std::string in_brackets(const std::string& english) {
    return "[" + english + "]";
}

TEST(OwnNames, AreSaidInTheReadersLanguageAndOthersStay) {
    const std::string id = own_name<"test only: distances">();
    EXPECT_EQ(id, "test only: distances");
    EXPECT_EQ(said_name(id).in(in_brackets), "[test only: distances]");
    EXPECT_EQ(said_name(id).english(), id);
    EXPECT_EQ(said_name("pose 7").in(in_brackets), "pose 7");
    EXPECT_TRUE(said_name("").empty());
}

TEST(OwnNames, HaveANumberOrANameInThem) {
    EXPECT_EQ(own_name<"test only: place %1">(3), "test only: place 3");
    EXPECT_EQ(own_name<"test only: place of %1">(own_name<"test only: distances">()),
              "test only: place of test only: distances");
    EXPECT_EQ(said_name("test only: place 3").in(in_brackets), "[test only: place 3]");
    EXPECT_EQ(said_name("test only: place of B7").in(in_brackets), "[test only: place of B7]");
    EXPECT_EQ(said_name("test only: place of test only: distances").english(),
              "test only: place of test only: distances");
    EXPECT_EQ(said_name("test only: place ").in(in_brackets), "test only: place ");
}

}  // namespace
}  // namespace covaria::own_names_test
