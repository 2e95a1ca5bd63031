// Saving leaves the old file or the new one, and no temporary file, whatever fails.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "tests/core/project/test_kinds.h"

namespace covaria::test::atomic_write_test {

namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

// Files may not grow beyond `bytes` while this lives: what a full disk does, for root too.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_ = {};
    void (*handler_)(int) = nullptr;
};

}  // namespace

TEST(AtomicWrite, WritesAndReplaces) {
    const fs::path folder = fresh_folder("write");
    ASSERT_TRUE(write_file_atomically(folder / "a.txt", "one"));
    EXPECT_EQ(bytes_of(folder / "a.txt"), "one");
    ASSERT_TRUE(write_file_atomically(folder / "a.txt", std::string(100000, 'x') + '\0'));
    EXPECT_EQ(bytes_of(folder / "a.txt"), std::string(100000, 'x') + '\0');
    EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicWrite, RelativeNames) {
    const fs::path folder = fresh_folder("relative");
    const fs::path before = fs::current_path();
    fs::current_path(folder);
    const auto written = write_file_atomically("a.txt", "one");
    fs::current_path(before);
    ASSERT_TRUE(written) << written.error().message.english();
    EXPECT_EQ(bytes_of(folder / "a.txt"), "one");
}

TEST(AtomicWrite, KeepsPermissionsAndLinks) {
    const fs::path folder = fresh_folder("permissions");
    put_bytes(folder / "a.txt", "old");
    fs::permissions(folder / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink("a.txt", folder / "link.txt");
    ASSERT_TRUE(write_file_atomically(folder / "link.txt", "new"));
    EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
    EXPECT_EQ(bytes_of(folder / "a.txt"), "new");
    EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicWrite, FullDiskLeavesTheOldFile) {
    const fs::path folder = fresh_folder("full");
    put_bytes(folder / "a.txt", "old");
    Result<void> written;
    {
        const FileSizeLimit limit(4096);
        written = write_file_atomically(folder / "a.txt", std::string(100000, 'x'));
    }
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, ErrorCode::io);
    EXPECT_NE(written.error().message.english().find("writing failed: File too large"), std::string::npos)
        << written.error().message.english();
    EXPECT_EQ(bytes_of(folder / "a.txt"), "old");
    EXPECT_EQ(files_in(folder), 1u);
}

TEST(AtomicWrite, DevicesAreWrittenInPlace) {
    const auto full = write_file_atomically("/dev/full", "x");
    ASSERT_FALSE(full);
    EXPECT_NE(full.error().message.english().find("No space left on device"), std::string::npos)
        << full.error().message.english();
    EXPECT_TRUE(write_file_atomically("/dev/null", "x"));
    EXPECT_FALSE(fs::is_regular_file("/dev/null"));
}

TEST(AtomicWrite, FoldersThatTakeNoFile) {
    const fs::path folder = fresh_folder("refused");
    put_bytes(folder / "file", "old");
    for (const fs::path& file :
         {folder / "file" / "a.txt", folder / "none" / "a.txt", fs::path("/proc/a.txt")}) {
        const auto written = write_file_atomically(file, "new");
        ASSERT_FALSE(written) << file;
        EXPECT_EQ(written.error().code, ErrorCode::io);
        EXPECT_NE(written.error().message.english().find("cannot be created in its folder"),
                  std::string::npos)
            << written.error().message.english();
        EXPECT_EQ(written.error().file, file.string());
    }
    EXPECT_EQ(bytes_of(folder / "file"), "old");
    const auto onto_folder = write_file_atomically(folder, "new");
    ASSERT_FALSE(onto_folder);
    EXPECT_NE(onto_folder.error().message.english().find("it is a folder"), std::string::npos);
}

TEST(SaveProject, SavesCanonicalText) {
    const fs::path file = fresh_folder("save") / "p.covaria";
    const Project project = parse(whole_project).project;
    ASSERT_TRUE(save_project(project, file));
    EXPECT_EQ(bytes_of(file), whole_project);
    const LoadedProject loaded = load_project(file);
    EXPECT_TRUE(loaded.problems.empty());
    EXPECT_TRUE(loaded.project == project);
    EXPECT_EQ(loaded.project.directory, file.parent_path());
}

}  // namespace covaria::test::atomic_write_test
