// Parts in a folder: what is kept comes back exactly, and what is of others is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/file_io.h"
#include "core/parts/parts_folder.h"
#include "tests/fresh_folder.h"

namespace covaria::parts_test {
namespace {

namespace fs = std::filesystem;

const UnitWork work{"pose", "", "0123456789abcdef", 5};

using test::fresh_folder;

Part part_of(UnitRange range, const std::string& letter) {
    PartSection section{work, range, {}};
    for (std::uint64_t u = range.first; u < range.last; ++u)
        section.partials.push_back(letter + std::string(1, '\0') + std::to_string(u));
    return {{"/a/project.covaria", {"--trials", "50000"}}, {section}};
}

TEST(Bytes, NumbersComeBackExactly) {
    const std::vector<double> values{0.1, -0.0, std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::denorm_min(), std::nan("")};
    ByteWriter writer;
    writer.put_list(values);
    writer.put(std::uint64_t{7});
    const std::string bytes = writer.take();
    ByteReader reader(bytes);
    std::vector<double> read;
    reader.get_list(read);
    EXPECT_EQ(std::memcmp(read.data(), values.data(), values.size() * sizeof(double)), 0);
    EXPECT_EQ(reader.get<std::uint64_t>(), 7u);
    EXPECT_TRUE(reader.complete());
}

TEST(Bytes, WhatIsMissingIsNoticedAndAllocatesNothing) {
    ByteWriter writer;
    writer.put(std::numeric_limits<std::uint64_t>::max() / 2);  // the length of a list that is not there
    const std::string bytes = writer.take();
    ByteReader reader(bytes);
    std::vector<double> read{1.0};
    reader.get_list(read);
    EXPECT_TRUE(reader.is_short());
    EXPECT_FALSE(reader.complete());
    EXPECT_EQ(read.size(), 1u);
    const std::string longer = bytes + "x";
    ByteReader not_all(longer);
    not_all.get<std::uint64_t>();
    EXPECT_FALSE(not_all.complete());
}

TEST(Parts, UnitsAreFoundInWhicheverFileHasThem) {
    const fs::path path = fresh_folder("found");
    ASSERT_TRUE(write_part(path / "b.part", part_of({0, 2}, "b")));
    ASSERT_TRUE(write_part(path / "a.part", part_of({3, 4}, "a")));
    const auto folder = PartsFolder::open(path);
    ASSERT_TRUE(folder) << folder.error().message.english();
    EXPECT_EQ((*folder)->request().arguments, (std::vector<std::string>{"--trials", "50000"}));
    EXPECT_EQ((*folder)->find(work, 1), std::string("b\0001", 3));
    EXPECT_EQ((*folder)->find(work, 3), std::string("a\0003", 3));
    EXPECT_EQ((*folder)->find(work, 2), std::nullopt);
    EXPECT_EQ((*folder)->missing(work), "3, 5");
    ASSERT_TRUE((*folder)->add({}, part_of({4, 5}, "c").sections.front()));
    EXPECT_EQ((*folder)->missing(work), "3");
    EXPECT_EQ((*PartsFolder::open(path))->missing(work), "3");
}

TEST(Parts, OtherProgramsAndInstructionsAreRefusedByName) {
    ProgramIdentity other = this_program();
    other.program = "covaria 0.0.1 (compiler of old)";
    const fs::path path = fresh_folder("foreign");
    const auto refused = [&] {
        const auto folder = PartsFolder::open(path);
        return folder ? std::string() : folder.error().message.english();
    };
    ASSERT_TRUE(write_part(path / "x.part", part_of({0, 1}, "x"), other));
    EXPECT_NE(refused().find("x.part"), std::string::npos);
    EXPECT_NE(refused().find("covaria 0.0.1 (compiler of old)"), std::string::npos) << refused();
    other = this_program();
    other.instructions = "AVX-512, FMA";
    ASSERT_TRUE(write_part(path / "x.part", part_of({0, 1}, "x"), other));
    EXPECT_NE(refused().find("AVX-512, FMA"), std::string::npos) << refused();
    EXPECT_NE(refused().find(this_program().instructions), std::string::npos) << refused();
    ASSERT_TRUE(write_part(path / "x.part", part_of({0, 1}, "x")));
    EXPECT_EQ(refused(), "");
}

TEST(Parts, OtherStatesAreRefused) {
    const fs::path path = fresh_folder("states");
    ASSERT_TRUE(write_part(path / "x.part", part_of({0, 1}, "x")));
    const auto folder = PartsFolder::open(path);
    ASSERT_TRUE(folder);
    EXPECT_TRUE((*folder)->check({work}));
    UnitWork changed = work;
    changed.fingerprint = "fedcba9876543210";
    EXPECT_FALSE((*folder)->check({changed}));
    changed = work;
    changed.units = 6;
    EXPECT_FALSE((*folder)->check({changed}));
    changed = work;
    changed.study = "map";
    EXPECT_FALSE((*folder)->check({changed}));
}

TEST(Parts, ADamagedByteIsNoticedWhereverItIs) {
    const fs::path path = fresh_folder("damaged");
    const fs::path file = path / "x.part";
    ASSERT_TRUE(write_part(file, part_of({0, 3}, "x")));
    const std::string good = *read_file(file);
    for (std::size_t i = 0; i < good.size(); i += 7) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ 4);
        ASSERT_TRUE(write_file_atomically(file, bad));
        EXPECT_FALSE(read_part(file)) << "byte " << i;
        EXPECT_FALSE(PartsFolder::open(path)) << "byte " << i;
    }
    for (std::size_t size = 0; size < good.size(); size += 11) {
        ASSERT_TRUE(write_file_atomically(file, good.substr(0, size)));
        EXPECT_FALSE(read_part(file)) << size << " bytes";
    }
}

}  // namespace
}  // namespace covaria::parts_test
