// PNG files: round trip, errors.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/fresh_folder.h"
#include "viz/vtk/image.h"

namespace covaria::png_test {
namespace {

namespace fs = std::filesystem;

Image gradient() {
    Image image{5, 3, {}};
    for (int i = 0; i < 15; ++i)
        image.rgba.insert(image.rgba.end(),
                          {static_cast<std::uint8_t>(i * 16), static_cast<std::uint8_t>(255 - i), 7, 255});
    return image;
}

/// Temporary files that a failed or finished write has left.
bool has_hidden_files(const fs::path& where) {
    for (const auto& entry : fs::directory_iterator(where))
        if (entry.path().filename().string().front() == '.') return true;
    return false;
}

TEST(Png, ReadsBackWhatWasWritten) {
    const fs::path folder = covaria::test::fresh_folder();
    const fs::path file = folder / "gradient.png";
    ASSERT_TRUE(write_png(gradient(), file).has_value());
    const auto back = read_png(file);
    ASSERT_TRUE(back.has_value()) << back.error().message.english();
    EXPECT_EQ(*back, gradient());
    EXPECT_FALSE(has_hidden_files(folder));
}

TEST(Png, ErrorsNameTheFile) {
    const fs::path folder = covaria::test::fresh_folder();
    const auto no_folder = write_png(gradient(), folder / "absent" / "a.png");
    ASSERT_FALSE(no_folder.has_value());
    EXPECT_EQ(no_folder.error().code, ErrorCode::io);
    EXPECT_NE(no_folder.error().message.english().find("absent/a.png"), std::string::npos);
    const auto full = write_png(gradient(), "/dev/full/a.png");
    EXPECT_FALSE(full.has_value());
    EXPECT_EQ(write_png({}, folder / "empty.png").error().code, ErrorCode::bad_input);
    EXPECT_EQ(read_png(folder / "absent.png").error().code, ErrorCode::not_found);
    std::ofstream(folder / "text.png") << "not a picture";
    EXPECT_EQ(read_png(folder / "text.png").error().code, ErrorCode::io);
}

TEST(Png, AFailedWriteLeavesTheOldFile) {
    const fs::path folder = covaria::test::fresh_folder();
    const fs::path target = folder / "taken.png";
    fs::create_directories(target / "inside");  // a folder with content cannot be replaced by a file
    EXPECT_FALSE(write_png(gradient(), target).has_value());
    EXPECT_TRUE(fs::exists(target / "inside"));
    EXPECT_FALSE(has_hidden_files(folder));
    fs::remove_all(target);
}

}  // namespace
}  // namespace covaria::png_test
