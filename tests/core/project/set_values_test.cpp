// Values set from outside: where they go, and what is refused.
#include "core/project/set_values.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace covaria::set_values_test {
namespace {

using nlohmann::json;

const std::string project =
    R"json({"title": "t", "assets": [{"id": "plate", "setup": {"temperature": {"value": 20, "unit": "degC"},
  "points": {"columns": ["point", "x [mm]"], "rows": [["A", 1.5], ["B", 2.5]]}}}]})json";

json changed(const std::string& pointer, const std::string& value) {
    const auto text = with_values(project, {{pointer, value}});
    EXPECT_TRUE(text.has_value()) << pointer << ": " << (text ? "" : text.error().message.english());
    return text ? json::parse(*text) : json();
}

std::string refusal(const std::string& pointer, const std::string& value) {
    const auto text = with_values(project, {{pointer, value}});
    EXPECT_FALSE(text.has_value()) << pointer;
    return text ? "" : text.error().path + ": " + text.error().message.english();
}

TEST(SetValues, ANumberTakesTheUnitThatStandsThere) {
    const json expected = {{"value", 23.5}, {"unit", "degC"}};
    EXPECT_EQ(changed("/assets/0/setup/temperature", "23.5")["assets"][0]["setup"]["temperature"], expected);
    EXPECT_EQ(changed("/assets/plate/setup/temperature", "23.5")["assets"][0]["setup"]["temperature"],
              expected);
}

TEST(SetValues, CellsAreFoundByIndexAndByName) {
    for (const char* pointer : {"/assets/0/setup/points/rows/1/1", "/assets/plate/setup/points/rows/B/x"})
        EXPECT_EQ(changed(pointer, "-4")["assets"][0]["setup"]["points"]["rows"][1][1], -4) << pointer;
}

TEST(SetValues, TextsAndNewKeys) {
    EXPECT_EQ(changed("/title", "No. 7")["title"], "No. 7");
    EXPECT_EQ(changed("/notes", "[1, 2]")["notes"], "[1, 2]") << "lists are not put in";
    EXPECT_EQ(changed("/assets/plate/name", "true")["assets"][0]["name"], true);
}

TEST(SetValues, WhatIsNotThereIsNamed) {
    EXPECT_NE(refusal("/assets/plat/setup/temperature", "1").find("did you mean 'plate'"), std::string::npos);
    EXPECT_NE(refusal("/assets/plate/setup/points/rows/B/xx/1", "1").find("'xx'"), std::string::npos);
    EXPECT_NE(refusal("/assets/7/setup/temperature", "1").find("'7'"), std::string::npos);
    EXPECT_NE(refusal("/assets", "1").find("/assets: there is no single value"), std::string::npos);
    EXPECT_NE(refusal("/title/deeper", "1").find("'deeper'"), std::string::npos);
}

TEST(SetValues, WhatIsNoTextIsRefused) {
    EXPECT_NE(refusal("/title", "\xff").find("UTF-8"), std::string::npos);
    EXPECT_NE(refusal("/ti\xfftle", "1").find("UTF-8"), std::string::npos);
    EXPECT_EQ(changed("/title", "1e999")["title"], "1e999") << "no number";
}

TEST(SetValues, TheFormIsPlaceEqualsValue) {
    const auto read = value_at("/assets/0/name=a=b");
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->pointer, "/assets/0/name");
    EXPECT_EQ(read->value, "a=b");
    for (const char* wrong : {"", "title=x", "/title"})
        EXPECT_EQ(value_at(wrong).error().code, ErrorCode::usage) << wrong;
}

TEST(SetValues, WhatIsNoJsonIsLeftToTheReader) {
    EXPECT_EQ(with_values("{", {{"/title", "x"}}).value(), "{");
}

}  // namespace
}  // namespace covaria::set_values_test
