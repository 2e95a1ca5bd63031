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

}  // namespace
}  // namespace covaria::own_names_test
