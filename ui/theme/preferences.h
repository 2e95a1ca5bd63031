// The preferences of the user, whatever the project: the look of the window and the start of new analyses.
// Nothing here changes a result, a report or a file.
#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

#include "core/propagation/options.h"
#include "core/text/display_units.h"
#include "ui/theme/fonts.h"

namespace covaria::ui {

enum class NumberForm { system, point, comma };

struct Preferences {
    QString language = {};                     ///< code, for the next start; empty: the system's
    QString theme = QStringLiteral("system");  ///< or "light", "dark"
    FontChoice font = {};
    NumberForm numbers = NumberForm::system;
    // Units of results in the window, where the project does not state them.
    DisplayUnits units = {};
    int digits = 2;  ///< significant ones of uncertainties
    int autosave_seconds = 1;
    // Written into new analyses, which have them in the project's file from then on.
    std::optional<double> coverage_factor = {};  ///< empty: k from the degrees of freedom
    std::uint64_t trials = 1'000'000;

    bool operator==(const Preferences& other) const;
    /// Preferences of the last session; missing or senseless ones are as here.
    static Preferences stored();
    void store() const;
};

inline constexpr int smallest_font = 7, largest_font = 24;  ///< points
inline constexpr std::uint64_t fewest_trials = 1'000, most_trials = 1'000'000'000;
inline constexpr int longest_autosave = 600;  ///< seconds

/// Holds the preferences for all parts of the window, and tells them of a change.
class PreferenceStore : public QObject {
    Q_OBJECT
public:
    explicit PreferenceStore(QObject* parent = nullptr);
    const Preferences& now() const { return now_; }
    /// The options that a new analysis begins with.
    EvaluationOptions new_analysis() const;
    /// Remembers and applies them at once.
    void set(const Preferences& wanted);

signals:
    void changed();

private:
    Preferences now_;
};

}  // namespace covaria::ui
