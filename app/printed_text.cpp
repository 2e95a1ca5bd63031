#include "app/printed_text.h"

#include <unistd.h>
#include <ext/stdio_sync_filebuf.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>

#include "app/terminal.h"
#include "core/base/printable.h"

namespace covaria {
namespace {

/// A stream that writes to a descriptor of the process.
struct Printer {
    explicit Printer(int to) : descriptor(to) {}
    int descriptor;
    int error = 0;        ///< errno of the first write that failed
    std::string pending;  ///< the beginning of what may be a control character
};

/// Bytes at the end of `text` whose meaning the next byte decides: a carriage return, half a character.
std::size_t undecided(std::string_view text) {
    return text.ends_with('\r') || text.ends_with('\xC2') ? 1 : 0;
}

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

ssize_t print(void* cookie, const char* data, std::size_t size) {
    Printer& printer = *static_cast<Printer*>(cookie);
    std::string text = std::move(printer.pending);
    text.append(data, size);
    const std::size_t end = text.size() - undecided(text);
    printer.pending = text.substr(end);
    if (write_all(printer.descriptor, printable(std::string_view(text).substr(0, end))))
        return static_cast<ssize_t>(size);
    if (printer.error == 0) printer.error = errno;
    return 0;  // how a failure is said
}

FILE* stream_of(Printer& printer, int buffering) {
    FILE* stream =
        fopencookie(&printer, "w", {.read = nullptr, .write = print, .seek = nullptr, .close = nullptr});
    if (stream) std::setvbuf(stream, nullptr, buffering, BUFSIZ);
    return stream;
}

// Never destroyed: streams are flushed after everything else has ended.
Printer& output() {
    static Printer& printer = *new Printer(STDOUT_FILENO);
    return printer;
}

Printer& errors() {
    static Printer& printer = *new Printer(STDERR_FILENO);
    return printer;
}

/// Sends the output of a C++ stream the same way.
void print_by(std::ostream& out, FILE* stream) {
    out.rdbuf(std::make_unique<__gnu_cxx::stdio_sync_filebuf<char>>(stream).release());  // never destroyed
}

}  // namespace

void show_control_characters() {
    if (FILE* stream = stream_of(output(), isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF)) stdout = stream;
    if (FILE* stream = stream_of(errors(), _IONBF)) stderr = stream;
    print_by(std::cout, stdout);
    print_by(std::cerr, stderr);
}

bool all_is_printed() {
    errno = 0;
    std::cout.flush();  // help is printed there
    const bool flushed = std::fflush(stdout) == 0 && std::cout.good();
    if (flushed && output().error == 0 && !std::ferror(stdout)) return true;
    const int why = output().error != 0 ? output().error : errno;
    print_message("standard output cannot be written" +
                  (why != 0 ? ": " + std::string(std::strerror(why)) : std::string()));
    return false;
}

}  // namespace covaria
