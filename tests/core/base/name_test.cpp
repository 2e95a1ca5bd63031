// Names of the program among those that people give: English in files, translated for people.
#include "core/base/name.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace covaria::name_test {
namespace {

std::string in_brackets(const std::string& english) {
    return "[" + english + "]";
}

TEST(OwnNames, AreSaidInTheReadersLanguageAndOthersStay) {
    const Name name = own_name<"test only: distances">();
    EXPECT_EQ(name, "test only: distances");
    EXPECT_EQ(said_name(name).in(in_brackets), "[test only: distances]");
    EXPECT_EQ(said_name(name).english(), name);
    EXPECT_EQ(said_name(Name("pose 7")).in(in_brackets), "pose 7");
    EXPECT_TRUE(said_name(Name()).empty());
}

// Somebody calls a pose as the program calls something: equal in files, and never translated.
TEST(OwnNames, AWordThatSomebodyTypedIsNotTranslatedForBeingEqual) {
    const Name own = own_name<"test only: flange">();
    const Name typed = std::string("test only: flange");
    EXPECT_EQ(own, typed);
    EXPECT_EQ(said_name(typed).in(in_brackets), "test only: flange");
    Name written_over = own;
    written_over += " 2";
    EXPECT_EQ(said_name(written_over).in(in_brackets), "test only: flange 2");
    Name taken = typed;
    taken = own;
    EXPECT_EQ(said_name(taken).in(in_brackets), "[test only: flange]");
}

TEST(OwnNames, HaveANumberOrANameInThem) {
    EXPECT_EQ(own_name<"test only: place %1">(3), "test only: place 3");
    const Name of_own = own_name<"test only: place of %1">(said_name(own_name<"test only: distances">()));
    EXPECT_EQ(of_own, "test only: place of test only: distances");
    EXPECT_EQ(said_name(of_own).in(in_brackets), "[test only: place of [test only: distances]]");
    EXPECT_EQ(said_name(own_name<"test only: place of %1">(std::string("B7"))).in(in_brackets),
              "[test only: place of B7]");
    EXPECT_EQ(said_name(Name("test only: place 3")).in(in_brackets), "test only: place 3");
}

}  // namespace
}  // namespace covaria::name_test
