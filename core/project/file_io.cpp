// Reading a file whole; replacing one so that a crash leaves the old or the new.
#include "core/project/file_io.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <sstream>

#include "core/project/project_file.h"

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

tl::unexpected<Error> io_failure(const fs::path& file, const std::string& step, int number) {
    return fail(Error{ErrorCode::io,
                      "'" + file.string() + "' was not written: " + step + ": " + reason(number),
                      {},
                      file.string(),
                      0});
}

fs::path temporary_name(const fs::path& file) {
    static std::atomic<unsigned> counter{0};
    return file.parent_path() / ("." + file.filename().string() + "." + std::to_string(::getpid()) + "-" +
                                 std::to_string(counter++) + ".tmp");
}

// Devices and pipes hold nothing that could be lost, and cannot be replaced by a file.
Result<void> write_in_place(const fs::path& file, const std::string& bytes) {
    Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (out.get() < 0) return io_failure(file, "it cannot be opened", errno);
    if (const int number = write_all(out.get(), bytes)) return io_failure(file, "writing failed", number);
    if (const int number = out.close_now()) return io_failure(file, "closing failed", number);
    return {};
}

Result<void> fill_temporary(const fs::path& temporary, const fs::path& file, const std::string& bytes) {
    Descriptor out(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.get() < 0)
        return io_failure(
            file, "a file cannot be created in its folder '" + temporary.parent_path().string() + "'", errno);
    struct stat old = {};
    if (::stat(file.c_str(), &old) == 0 && ::fchmod(out.get(), old.st_mode & 07777) != 0)
        return io_failure(file, "the permissions of the old file cannot be kept", errno);
    if (const int number = write_all(out.get(), bytes)) return io_failure(file, "writing failed", number);
    if (::fsync(out.get()) != 0) return io_failure(file, "flushing to the disk failed", errno);
    if (const int number = out.close_now()) return io_failure(file, "closing failed", number);
    return {};
}

// Makes the rename last through a power failure. The new file is in place already and whole, so a file system
// that cannot flush folders is no reason to report a failure.
void flush_folder(const fs::path& folder) {
    const Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.get() >= 0) ::fsync(directory.get());
}

Result<void> replace_file(const fs::path& file, const std::string& bytes) {
    const fs::path temporary = temporary_name(file);
    Result<void> filled = fill_temporary(temporary, file, bytes);
    if (filled && ::rename(temporary.c_str(), file.c_str()) != 0)
        filled = io_failure(file, "the new file cannot take its place", errno);
    if (!filled) {
        ::unlink(temporary.c_str());
        return filled;
    }
    flush_folder(file.parent_path());
    return {};
}

}  // namespace

Result<std::string> read_file(const fs::path& file) {
    const auto failure = [&](int number) {
        const ErrorCode code = number == ENOENT ? ErrorCode::not_found : ErrorCode::io;
        return fail(
            Error{code, "'" + file.string() + "' cannot be read: " + reason(number), {}, file.string(), 0});
    };
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) return failure(EISDIR);
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    if (!in) return failure(errno ? errno : EIO);
    std::ostringstream text;
    text << in.rdbuf();
    if (in.bad()) return failure(EIO);
    return std::move(text).str();
}

Result<void> write_file_atomically(const fs::path& file, const std::string& bytes) {
    std::error_code ignored;
    fs::path target = fs::absolute(file, ignored);
    if (fs::is_symlink(target, ignored)) {  // what the link names is replaced, not the link
        const fs::path named = fs::weakly_canonical(target, ignored);
        if (!ignored && !named.empty()) target = named;
    }
    if (fs::is_directory(target, ignored)) return io_failure(file, "it is a folder", EISDIR);
    if (fs::exists(target, ignored) && !fs::is_regular_file(target, ignored))
        return write_in_place(target, bytes);
    return replace_file(target, bytes);
}

}  // namespace covaria
