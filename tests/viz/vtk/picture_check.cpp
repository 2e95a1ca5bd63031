// Checks of pictures.
#include "tests/viz/vtk/picture_check.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace covaria::test {
namespace {

namespace fs = std::filesystem;

constexpr double largest_fraction = 0.01;
constexpr double largest_mean = 0.8;

}  // namespace

Difference difference(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.empty()) return {};
    double sum = 0.0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
        int worst = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const int d = std::abs(a.rgba[i + k] - b.rgba[i + k]);
            worst = std::max(worst, d);
            sum += d;
        }
        differing += worst > 24;
    }
    const double pixels = static_cast<double>(a.rgba.size()) / 4;
    return {static_cast<double>(differing) / pixels, sum / (3 * pixels)};
}

int coloured_near(const Image& image, Pixel at, int reach, int stronger, int weaker) {
    int count = 0;
    for (int y = static_cast<int>(at.y) - reach; y <= at.y + reach; ++y)
        for (int x = static_cast<int>(at.x) - reach; x <= at.x + reach; ++x) {
            const auto pixel = image.at(x, y);
            count +=
                pixel[static_cast<std::size_t>(stronger)] >= pixel[static_cast<std::size_t>(weaker)] + 30;
        }
    return count;
}

int dark_in(const Image& image, int x, int y, int width, int height) {
    int count = 0;
    for (int row = y; row < y + height; ++row)
        for (int column = x; column < x + width; ++column) {
            const auto pixel = image.at(column, row);
            count += pixel[3] == 255 && std::max({pixel[0], pixel[1], pixel[2]}) < 145;
        }
    return count;
}

std::string left_picture(const Image& image, const std::string& name) {
    const fs::path folder = fs::path(COVARIA_BINARY_DIR) / "failed-pictures";
    std::error_code ignored;
    fs::create_directories(folder, ignored);
    const fs::path file = folder / (name + ".png");
    return write_png(image, file) ? "picture left at " + file.string() : "picture could not be written";
}

testing::AssertionResult matches_baseline(const Image& image, const std::string& name) {
    return matches_baseline(image, fs::path(COVARIA_SOURCE_DIR) / "tests/viz/baselines" / (name + ".png"),
                            {largest_fraction, largest_mean});
}

testing::AssertionResult matches_baseline(const Image& image, const fs::path& file,
                                          const Difference& largest) {
    const std::string name = file.stem().string();
    const char* update = std::getenv("COVARIA_UPDATE_BASELINES");
    if (update && std::string(update) == "1") {
        std::error_code ignored;
        fs::create_directories(file.parent_path(), ignored);
        if (const auto written = write_png(image, file); !written)
            return testing::AssertionFailure() << written.error().message.english();
        return testing::AssertionSuccess();
    }
    const auto baseline = read_png(file);
    if (!baseline)
        return testing::AssertionFailure()
               << baseline.error().message.english() << "; " << left_picture(image, name)
               << "; look at it, and if it is right run this test with COVARIA_UPDATE_BASELINES=1 to keep it";
    const Difference d = difference(image, *baseline);
    if (d.fraction <= largest.fraction && d.mean <= largest.mean) return testing::AssertionSuccess();
    return testing::AssertionFailure() << 100 * d.fraction << " % of the pixels differ, mean difference "
                                       << d.mean << "; " << left_picture(image, name);
}

}  // namespace covaria::test
