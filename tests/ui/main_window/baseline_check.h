// Screenshots against the pictures that were looked at.
#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <QString>

namespace covaria::ui {

/// Compares at quarter size, where letters smoothed differently by machines do not matter: the screenshot
/// equals `folder`/NAME.png up to small differences. Otherwise the small picture is left in
/// COVARIA_BINARY_DIR/failed-pictures. COVARIA_UPDATE_BASELINES=1 writes the file.
testing::AssertionResult matches_screenshot(const QImage& image, const QString& folder, const QString& name);

}  // namespace covaria::ui
