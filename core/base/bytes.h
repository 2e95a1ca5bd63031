// Numbers as bytes and back, exactly: for files that the same program on the same kind of machine reads
// again.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace covaria {

class ByteWriter {
public:
    template <class T>
    void put(T value) {
        static_assert(std::is_arithmetic_v<T>);
        put_all(std::span<const T>(&value, 1));
    }
    template <class T>
    void put_all(std::span<const T> values) {
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }
    /// Writes a list with the number of its values before them. `Values`: contiguous, of arithmetic type.
    template <class Values>
    void put_list(const Values& values) {
        put(static_cast<std::uint64_t>(values.size()));
        put_all(std::span<const typename Values::value_type>(values.data(), values.size()));
    }
    std::string take() { return std::move(bytes_); }

private:
    std::string bytes_;
};

/// Reader of what a ByteWriter wrote, in the same order. Whoever has read all asks `complete`: where bytes
/// were missing, zeros were read, and lists were left as they were.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    T get() {
        T value{};
        get_all(std::span<T>(&value, 1));
        return value;
    }
    template <class T>
    void get_all(std::span<T> values) {
        if (const char* from = next(values.size(), sizeof(T)))
            if (!values.empty()) std::memcpy(values.data(), from, values.size_bytes());
    }
    template <class Values>
    void get_list(Values& values) {
        using T = typename Values::value_type;
        const auto size = get<std::uint64_t>();
        const char* from = next(size, sizeof(T));
        if (!from) return;
        values.resize(static_cast<std::size_t>(size));
        if (size > 0) std::memcpy(values.data(), from, static_cast<std::size_t>(size) * sizeof(T));
    }
    bool is_short() const { return short_; }
    /// Treats what was read as missing bytes, as it cannot be true.
    void refuse() { short_ = true; }
    /// Whether everything was there, and nothing is left.
    bool complete() const { return !short_ && bytes_.empty(); }

private:
    const char* next(std::uint64_t count, std::size_t size) {
        short_ = short_ || count > bytes_.size() / size;
        if (short_) return nullptr;
        const char* from = bytes_.data();
        bytes_.remove_prefix(static_cast<std::size_t>(count) * size);
        return from;
    }

    std::string_view bytes_;
    bool short_ = false;
};

}  // namespace covaria
