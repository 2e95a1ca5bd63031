#include "app/terminal.h"

#include <unistd.h>

#include <cstdio>
#include <set>

#include "core/base/printable.h"
#include "core/text/numbers.h"

namespace covaria {
namespace {

bool progress_shown = false;

/// Replaces the text on the line. Goes past the stream, which shows control characters.
void put_on_line(const std::string& words) {
    const std::string text = "\r\x1b[K" + printable(words);
    std::fflush(stderr);
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

std::string place(const std::string& file, int line, const std::string& path) {
    std::string text;
    if (!file.empty()) text += file + (line > 0 ? ":" + std::to_string(line) : "") + ": ";
    if (!path.empty()) text += path + ": ";
    return text;
}

}  // namespace

void end_progress_line() {
    if (!progress_shown) return;
    put_on_line({});
    progress_shown = false;
}

void print_message(const std::string& message) {
    end_progress_line();
    std::fprintf(stderr, "covaria: %s\n", message.c_str());
}

void print_error(const Error& error) {
    print_message(place(error.file, error.line, error.path) + error.message.english());
}

void print_problems(const Problems& problems) {
    static std::set<std::string> warned;
    end_progress_line();
    for (const Problem& p : problems.items()) {
        const char* kind = p.severity == Severity::error ? "error: " : "warning: ";
        const std::string where =
            p.file.empty() ? "" : p.file + (p.line > 0 ? ":" + std::to_string(p.line) : "") + ": ";
        const std::string path = p.path.empty() ? "" : p.path + ": ";
        const std::string line = where + kind + path + p.message.english() + "\n";
        if (p.severity == Severity::warning && !warned.insert(line).second) continue;
        std::fputs(line.c_str(), stderr);
    }
}

std::function<void(const Progress&)> progress_line(const std::string& what) {
    if (!isatty(STDERR_FILENO)) return {};
    return [what](const Progress& p) {
        const double done =
            p.trials_planned > 0 ? 100.0 * double(p.trials_done) / double(p.trials_planned) : 0;
        const std::string percent = format_decimals(done, 0) + " %";
        show_progress(what + ": " +
                      (p.trials_planned > 0 ? percent : std::to_string(p.trials_done) + " trials"));
    };
}

void show_progress(const std::string& words) {
    if (!isatty(STDERR_FILENO)) return;
    progress_shown = true;
    put_on_line(words);
}

}  // namespace covaria
