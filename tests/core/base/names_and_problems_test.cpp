// Names of files, UTF-8, problems that are counted, and files that are written whole or not at all.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "core/base/counted_problems.h"
#include "core/base/file_io.h"
#include "core/base/file_names.h"
#include "core/base/guarded.h"
#include "core/base/utf8.h"
#include "tests/fresh_folder.h"

namespace covaria::names_and_problems_test {
namespace {

namespace fs = std::filesystem;

using test::fresh_folder;

TEST(FileNames, StayReadableAndStayInTheFolder) {
    EXPECT_EQ(file_name_part("pose 7"), "pose-7");
    EXPECT_EQ(file_name_part("../../etc/x"), "etc-x");
    EXPECT_EQ(file_name_part("左 2"), "左-2");
    EXPECT_EQ(file_name_part("\xE2\x80\xAE"
                             "gnp"),
              "gnp");  // the mark that turns the direction of writing
    EXPECT_EQ(file_name_part("a\xFFz"), "a-z");
    EXPECT_EQ(file_name_part(".."), "");
}

TEST(FileNames, AreUniqueAndShort) {
    FileNames names;
    EXPECT_EQ(names.unique("a", ".png"), "a.png");
    EXPECT_EQ(names.unique("A", ".png"), "A-2.png");
    EXPECT_EQ(names.unique("a", ".csv"), "a.csv");
    std::string stem;
    for (int i = 0; i < 100; ++i) stem += "左";
    const std::string long_name = names.unique(stem, ".png");
    EXPECT_LE(long_name.size(), 210u);
    EXPECT_EQ(valid_utf8(long_name), long_name.size());
    EXPECT_NE(names.unique(stem, ".png"), long_name);
}

TEST(Utf8, ValidAndNot) {
    EXPECT_EQ(valid_utf8("aä左😀"), std::string("aä左😀").size());
    for (const std::string bad :
         {"\x80", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x82"})
        EXPECT_EQ(valid_utf8("ab" + bad), 2u);
}

TEST(CountedProblems, OfAKindAreCountedBeyondAHundred) {
    Problems problems;
    for (const char* asset : {"/assets/0", "/assets/1"}) {
        for (int i = 0; i < 250; ++i)
            problems.error(asset + std::string("/t/rows/") + std::to_string(i) + "/x", "wrong");
        for (int i = 0; i < 3; ++i)
            problems.error(asset + std::string("/t/rows/") + std::to_string(i) + "/y", "wrong");
    }
    count_beyond_a_hundred(problems);
    ASSERT_EQ(problems.items().size(), 2 * 103u + 2u);
    EXPECT_EQ(problems.items().back().message.english(), "and 150 more like these");
    EXPECT_EQ(problems.items().back().path, "/assets/1/t/rows/100/x");
}

TEST(Guarded, MakesErrorsOfWhatIsThrown) {
    const auto impossible = guarded([]() -> int { throw ImpossibleValue("negative width"); });
    EXPECT_EQ(impossible.error().code, ErrorCode::bad_input);
    const auto memory = guarded([]() -> int { throw std::bad_alloc(); });
    EXPECT_NE(memory.error().message.english().find("memory"), std::string::npos);
    EXPECT_EQ(*guarded([] { return 7; }), 7);
}

TEST(FileIo, ReadsFilesAndNothingElse) {
    const fs::path folder = fresh_folder("file-io");
    ASSERT_TRUE(write_file_atomically(folder / "a", std::string("x\0y", 3)));
    EXPECT_EQ(*read_file(folder / "a"), std::string("x\0y", 3));
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const fs::path& other : {folder / "pipe", folder, fs::path("/dev/null")})
        EXPECT_EQ(read_file(other).error().code, ErrorCode::io);
    EXPECT_EQ(read_file(folder / "none").error().code, ErrorCode::not_found);
}

/// A process that gets no further than the middle of a file, and waits there.
pid_t stuck_writer(const fs::path& file) {
    const pid_t child = fork();
    if (child != 0) return child;
    signal(SIGXFSZ, [](int) { pause(); });
    const rlimit small{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &small);
    static_cast<void>(write_file_atomically(file, std::string(100'000, 'x')));
    _exit(0);
}

std::ptrdiff_t files_in(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

TEST(FileIo, LeftoversOfTheDeadAreRemovedAndThoseOfTheLivingStay) {
    const fs::path folder = fresh_folder("leftovers");
    ASSERT_TRUE(write_file_atomically(folder / "project", "old"));
    std::ofstream(folder / "mine.tmp") << "not ours";
    const pid_t child = stuck_writer(folder / "project");
    while (files_in(folder) < 3) usleep(1000);
    remove_leftovers(folder);
    EXPECT_EQ(files_in(folder), 3);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    remove_leftovers(folder);
    EXPECT_EQ(files_in(folder), 2);
    EXPECT_EQ(*read_file(folder / "project"), "old");
}

}  // namespace
}  // namespace covaria::names_and_problems_test
