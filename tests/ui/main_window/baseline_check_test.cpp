// The check of screenshots: what it forgives, what not, and what it says without a picture to compare with.
#include "tests/ui/main_window/baseline_check.h"

#include <QFile>
#include <QPainter>
#include <QTemporaryDir>

namespace covaria::ui::baseline_check_test {
namespace {

class BaselineCheck : public testing::Test {
protected:
    ~BaselineCheck() override { qunsetenv("COVARIA_UPDATE_BASELINES"); }
    static QImage picture(const QString& words, int shift = 0) {
        QImage image(1280, 800, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.drawText(100 + shift, 100, words);
        painter.fillRect(300, 300, 400, 200, Qt::lightGray);
        return image;
    }
    void keep(const QImage& image) {
        qputenv("COVARIA_UPDATE_BASELINES", "1");
        ASSERT_TRUE(matches_screenshot(image, folder_.path(), QStringLiteral("check")));
        qunsetenv("COVARIA_UPDATE_BASELINES");
    }
    testing::AssertionResult check(const QImage& image) const {
        return matches_screenshot(image, folder_.path(), QStringLiteral("check"));
    }
    QTemporaryDir folder_;
};

TEST_F(BaselineCheck, WithoutAPictureSaysHowToMakeIt) {
    const auto result = check(picture(QStringLiteral("words")));
    EXPECT_FALSE(result);
    EXPECT_NE(std::string(result.message()).find("COVARIA_UPDATE_BASELINES=1"), std::string::npos);
    EXPECT_NE(std::string(result.message()).find("failed-pictures"), std::string::npos);
}

TEST_F(BaselineCheck, ForgivesTheSmoothingOfLettersOnly) {
    keep(picture(QStringLiteral("words")));
    EXPECT_EQ(QImage(folder_.filePath(QStringLiteral("check.png"))).size(), QSize(320, 200));
    EXPECT_TRUE(check(picture(QStringLiteral("words"))));
    EXPECT_TRUE(check(picture(QStringLiteral("words"), 1)));
    QImage other = picture(QStringLiteral("words"));
    QPainter(&other).fillRect(300, 300, 400, 200, Qt::white);
    EXPECT_FALSE(check(other)) << "a pane without its contents";
    EXPECT_FALSE(check(picture(QStringLiteral("words")).scaled(1000, 800))) << "another size";
}

}  // namespace
}  // namespace covaria::ui::baseline_check_test
