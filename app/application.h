// The QApplication of the program, with a display or without.
#pragma once

#include <QApplication>
#include <memory>

namespace covaria {

enum class Platform { of_the_desktop, offscreen };

/// Named, versioned, and quiet: Qt finds a runtime folder where the system gave none.
std::unique_ptr<QApplication> make_application(Platform platform);

}  // namespace covaria
