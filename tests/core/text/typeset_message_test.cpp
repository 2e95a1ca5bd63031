// Messages about a symbol: translated words, and the symbol typeset among them.
#include "core/text/typeset_message.h"

#include <gtest/gtest.h>

#include <string>

#include "core/text/symbol.h"

namespace covaria::typeset_message_test {
namespace {

DocumentLanguage bracketed() {
    return {"de", {","}, [](const std::string& english) { return "[" + english + "]"; }};
}

TEST(TypesetMessages, KeepTheirSymbolWithItsScripts) {
    const TypesetMessage title = TypesetMessage::of<"%1: estimate">(symbol_text("L_S"));
    EXPECT_EQ(title.in({}), symbol_text("L_S") + ": estimate");
    EXPECT_EQ(title.in(bracketed()), "[" + symbol_text("L_S") + ": estimate]");
    EXPECT_EQ(title.message().english(), symbol_to_unicode("L_S") + ": estimate");
    EXPECT_EQ(title.within<"%1, factor">().in({}), symbol_text("L_S") + ": estimate, factor");
}

TEST(TypesetMessages, LeaveNamesAsTheyAre) {
    const TypesetMessage title = Message("100 %1");
    EXPECT_EQ(to_unicode(title.in({})), "100 %1");
    EXPECT_EQ(to_unicode(title.within<"%1, added">().in({})), "100 %1, added");
}

TEST(TypesetMessages, NumbersOfAMessageAreWrittenAsTheReaderWritesThem) {
    const Message message = tell<"condition number %1">(Message::number("1.0289"));
    EXPECT_EQ(message.english(), "condition number 1.0289");
    EXPECT_EQ(bracketed().say(message), "[condition number 1,0289]");
    EXPECT_EQ(bracketed().say(tell<"p = %1">(Message::number("2.5e-05"))), "[p = 2,5×10⁻⁵]");
}

}  // namespace
}  // namespace covaria::typeset_message_test
