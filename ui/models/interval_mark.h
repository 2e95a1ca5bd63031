// The look of U and k where the interval is stated in their place (JCGM 101 5.5).
#pragma once

#include <QVariant>

namespace covaria::ui {

/// Grey and in italics, which a selected row shows, too, with the reason as tooltip; empty for other roles.
QVariant interval_mark(int role);

}  // namespace covaria::ui
