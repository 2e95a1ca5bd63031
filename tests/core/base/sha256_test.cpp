// SHA-256 against the examples of FIPS 180-4 and of its secure hash standard validation; days of the
// calendar.
#include "core/base/sha256.h"

#include <gtest/gtest.h>

#include "core/base/dates.h"

namespace covaria::sha256_test {
namespace {

TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256_of(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_of(std::string(1'000'000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, IsRecognisedByItsDigits) {
    EXPECT_TRUE(is_sha256(sha256_of("x")));
    EXPECT_FALSE(is_sha256(std::string(64, 'g')));
    EXPECT_FALSE(is_sha256(std::string(63, '0')));
}

TEST(Dates, AreThoseOfTheCalendar) {
    EXPECT_TRUE(date_of("2024-02-29"));
    for (const char* none :
         {"2026-02-29", "2026-4-17", "2026-04-31", "17.04.2026", "", "2026-13-01", "abcd-ef-gh"})
        EXPECT_FALSE(date_of(none)) << none;
    EXPECT_EQ(*date_of("2026-03-01") - *date_of("2026-02-28"), std::chrono::days(1));
    const auto both = period_of("2026-04-16/2026-04-17");
    ASSERT_TRUE(both);
    EXPECT_EQ(both->last - both->first, std::chrono::days(1));
    EXPECT_FALSE(period_of("2026-04-17/2026-04-16"));
    EXPECT_FALSE(period_of("2026-04-17/"));
}

}  // namespace
}  // namespace covaria::sha256_test
