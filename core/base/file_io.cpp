#include "core/base/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/file_mode.h"

namespace covaria {

namespace fs = std::filesystem;

namespace {

std::string reason(int number) {
    return std::generic_category().message(number);
}

// An open file descriptor that is closed in any case.
class Descriptor {
public:
    explicit Descriptor(int descriptor) : descriptor_(descriptor) {}
    ~Descriptor() {
        if (descriptor_ >= 0) ::close(descriptor_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return descriptor_; }
    /// Closing reports what a network file system could not write before.
    int close_now() {
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        return closed == 0 ? 0 : errno;
    }

private:
    int descriptor_;
};

/// 0, or the number of the system's reason.
int write_all(int descriptor, const std::string& bytes) {
    std::size_t written = 0;
    while (written < bytes.size()) {
        const ssize_t n = ::write(descriptor, bytes.data() + written, bytes.size() - written);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return errno;
        written += static_cast<std::size_t>(n);
    }
    return 0;
}

tl::unexpected<Error> io_failure(const fs::path& file, const Message& step, int number) {
    return fail(Error{ErrorCode::io,
                      tell<"'%1' was not written: %2: %3">(file.string(), step, reason(number)),
                      {},
                      file.string(),
                      0});
}

// ".covaria-HOST-PROCESS-NUMBER.tmp": short, whatever the file is called, and tells whether its writer lives.
constexpr std::string_view temporary_ending = ".tmp";

std::string temporary_beginning() {
    std::array<char, 256> host{};
    ::gethostname(host.data(), host.size() - 1);
    unsigned hash = 2166136261u;  // FNV-1a
    for (const char c : std::string_view(host.data()))
        hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
    return ".covaria-" + std::to_string(hash) + "-";
}

fs::path temporary_name(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return file.parent_path() / (temporary_beginning() + std::to_string(::getpid()) + "-" +
                                 std::to_string(counter++) + std::string(temporary_ending));
}

/// The process that made a temporary file of this machine; 0: none of ours.
pid_t writer_of(std::string_view name, const std::string& beginning) {
    if (!name.starts_with(beginning) || !name.ends_with(temporary_ending)) return 0;
    name.remove_prefix(beginning.size());
    pid_t process = 0;
    const auto [end, status] = std::from_chars(name.data(), name.data() + name.size(), process);
    return status == std::errc{} && *end == '-' ? process : 0;
}

// Temporary files that exist at the moment.
class Unfinished {
public:
    static Unfinished& all() {
        static Unfinished unfinished;
        return unfinished;
    }
    void add(const fs::path& file) {
        const std::lock_guard lock(mutex_);
        files_.push_back(file);
    }
    void drop(const fs::path& file) {
        const std::lock_guard lock(mutex_);
        std::erase(files_, file);
    }
    void remove() {
        const std::unique_lock lock(mutex_, std::try_to_lock);
        if (!lock.owns_lock()) return;
        for (const fs::path& file : files_) ::unlink(file.c_str());
    }

private:
    std::mutex mutex_;
    std::vector<fs::path> files_;
};

// Devices and pipes hold nothing that could be lost, and cannot be replaced by a file.
Result<void> write_in_place(const fs::path& file, const std::string& bytes) {
    Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (out.get() < 0) return io_failure(file, tell<"it cannot be opened">(), errno);
    if (const int number = write_all(out.get(), bytes))
        return io_failure(file, tell<"writing failed">(), number);
    if (const int number = out.close_now()) return io_failure(file, tell<"closing failed">(), number);
    return {};
}

Result<void> fill_temporary(const fs::path& temporary, const fs::path& file, const std::string& bytes,
                            std::optional<mode_t> mode) {
    Descriptor out(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode.value_or(0666)));
    if (out.get() < 0)
        return io_failure(
            file, tell<"a file cannot be created in its folder '%1'">(temporary.parent_path().string()),
            errno);
    struct stat old = {};
    if (!mode && ::stat(file.c_str(), &old) == 0 && ::fchmod(out.get(), old.st_mode & 07777) != 0)
        return io_failure(file, tell<"the permissions of the old file cannot be kept">(), errno);
    if (const int number = write_all(out.get(), bytes))
        return io_failure(file, tell<"writing failed">(), number);
    if (::fsync(out.get()) != 0) return io_failure(file, tell<"flushing to the disk failed">(), errno);
    if (const int number = out.close_now()) return io_failure(file, tell<"closing failed">(), number);
    return {};
}

// Makes the rename last through a power failure. The new file is in place already and whole, so a file system
// that cannot flush folders is no reason to report a failure.
void flush_folder(const fs::path& folder) {
    const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.get() >= 0) ::fsync(directory.get());
}

Result<void> replace_file(const fs::path& file, const std::string& bytes, std::optional<mode_t> mode) {
    const fs::path temporary = temporary_name(file);
    Unfinished::all().add(temporary);
    Result<void> filled = fill_temporary(temporary, file, bytes, mode);
    if (filled && ::rename(temporary.c_str(), file.c_str()) != 0)
        filled = io_failure(file, tell<"the new file cannot take its place">(), errno);
    if (!filled) ::unlink(temporary.c_str());
    Unfinished::all().drop(temporary);
    if (!filled) return filled;
    flush_folder(file.parent_path());
    return {};
}

/// Empty for a regular file.
Message other_kind(mode_t mode) {
    if (S_ISDIR(mode)) return tell<"a folder">();
    if (S_ISFIFO(mode)) return tell<"a pipe">();
    if (S_ISSOCK(mode)) return tell<"a socket">();
    return S_ISREG(mode) ? Message{} : tell<"a device">();
}

/// Up to one byte more than `largest_file`; errno is 0, or why reading ended before.
std::string read_all(int descriptor, std::size_t expected) {
    std::string text(expected + 1, '\0');
    std::size_t size = 0;
    errno = 0;
    while (size <= largest_file) {
        if (size == text.size()) text.resize(2 * text.size());
        const ssize_t n = ::read(descriptor, text.data() + size, text.size() - size);
        if (n < 0 && errno == EINTR) {
            errno = 0;
            continue;
        }
        if (n <= 0) break;
        size += static_cast<std::size_t>(n);
    }
    text.resize(size);
    return text;
}

}  // namespace

Result<std::string> read_file(const fs::path& file) {
    const auto failure = [&](ErrorCode code, const Message& why) {
        return fail(Error{code, tell<"'%1' cannot be read: %2">(file.string(), why), {}, file.string(), 0});
    };
    const auto refused = [&](int number) {
        return failure(number == ENOENT ? ErrorCode::not_found : ErrorCode::io, reason(number));
    };
    struct stat state = {};
    if (::stat(file.c_str(), &state) != 0) return refused(errno);
    if (const Message other = other_kind(state.st_mode); !other.empty())
        return failure(ErrorCode::io, tell<"it is %1, not a file">(other));
    Descriptor in(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    if (in.get() < 0) return refused(errno);
    // Once more, of what was opened: it may have changed meanwhile.
    if (::fstat(in.get(), &state) != 0) return refused(errno);
    if (!S_ISREG(state.st_mode)) return failure(ErrorCode::io, tell<"it is not a file">());
    const auto size = static_cast<std::uintmax_t>(std::max<off_t>(state.st_size, 0));
    std::string text;
    if (size <= largest_file) text = read_all(in.get(), static_cast<std::size_t>(size));
    if (size > largest_file || text.size() > largest_file)
        return failure(ErrorCode::io, tell<"it is too large: files of up to %1 MB are read, it has %2 MB">(
                                          largest_file / 1'000'000,
                                          std::max<std::uintmax_t>(size, text.size()) / 1'000'000));
    if (errno != 0) return refused(errno);
    return text;
}

Result<void> write_file_with_mode(const fs::path& file, const std::string& bytes, unsigned mode) {
    std::error_code ignored;
    return replace_file(fs::absolute(file, ignored), bytes, static_cast<mode_t>(mode));
}

Result<void> write_file_atomically(const fs::path& file, const std::string& bytes) {
    std::error_code ignored;
    fs::path target = fs::absolute(file, ignored);
    if (fs::is_symlink(target, ignored)) {  // the file that a link names is replaced, not the link
        const fs::path named = fs::weakly_canonical(target, ignored);
        if (!ignored && !named.empty()) target = named;
    }
    if (fs::is_directory(target, ignored)) return io_failure(file, tell<"it is a folder">(), EISDIR);
    if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
        return write_in_place(target, bytes);
    return replace_file(target, bytes, std::nullopt);
}

void remove_leftovers(const fs::path& folder) {
    const std::string beginning = temporary_beginning();
    std::error_code ignored;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, ignored), end; entry != end;
         entry.increment(ignored)) {
        const pid_t writer = writer_of(entry->path().filename().string(), beginning);
        if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH) ::unlink(entry->path().c_str());
    }
}

void remove_unfinished_files() {
    Unfinished::all().remove();
}

}  // namespace covaria
