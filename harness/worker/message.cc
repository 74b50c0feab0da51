#include "worker/message.h"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstring>
#include <type_traits>
#include <utility>

namespace etalon {
namespace {

template <typename T, typename Plain>
concept Is = std::same_as<std::remove_const_t<T>, Plain>;

template <typename T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// The fields of each structure, listed once for both directions. A program's line_names stay with
// the client: no device looks at them.
void Fields(auto& archive, Is<Nothing> auto&) {
    archive();
}
void Fields(auto& archive, Is<RunTime> auto& time) {
    archive(time.seconds, time.clock, time.processor_seconds);
}
void Fields(auto& archive, Is<Batch> auto& batch) {
    archive(batch.rows, batch.input_words, batch.output_words);
}
void Fields(auto& archive, Is<RunRequest> auto& request) {
    archive(request.handle, request.batch, request.is_timed);
}
void Fields(auto& archive, Is<Candidate> auto& candidate) {
    archive(candidate.backend, candidate.hint, candidate.index, candidate.attempt, candidate.driver,
            candidate.environment);
}
void Fields(auto& archive, Is<OpenRequest> auto& request) {
    archive(request.candidate, request.memory_bytes);
}
void Fields(auto& archive, Is<Image> auto& image) {
    archive(image.width, image.height, image.levels, image.shape, image.rgba);
}
void Fields(auto& archive, Is<Sampling> auto& sampling) {
    archive(sampling.filter, sampling.wrap);
}
void Fields(auto& archive, Is<BoundImage> auto& bound) {
    archive(bound.name, bound.image, bound.sampling);
}
void Fields(auto& archive, Is<Program> auto& program) {
    archive(program.stage, program.form, program.glsl, program.spirv, program.input_words,
            program.output_words, program.images);
}
void Fields(auto& archive, Is<DeviceInfo> auto& info) {
    archive(info.name, info.description, info.driver, info.version, info.api, info.compiler,
            info.features, info.float_controls, info.glsl_version, info.max_rows, info.siblings,
            info.on_host, info.slow);
}
void Fields(auto& archive, Is<DeviceFailure> auto& failure) {
    archive(failure.kind, failure.reason);
}

class Writer {
  public:
    void operator()(const auto&... values) { (Put(values), ...); }

    std::string Frame() {
        const std::uint64_t size = text_.size() - kFrameBytes;
        std::memcpy(text_.data(), &size, sizeof size);
        return std::move(text_);
    }

  private:
    void Append(const void* data, std::size_t size) {
        text_.append(static_cast<const char*>(data), size);
    }
    void Put(Scalar auto value) { Append(&value, sizeof value); }
    void Put(const std::string& text) {
        Put(text.size());
        Append(text.data(), text.size());
    }
    template <typename T>
    void Put(const std::vector<T>& values) {
        Put(values.size());
        if constexpr (Scalar<T>) {
            Append(values.data(), values.size() * sizeof(T));
        } else {
            for (const T& value : values) {
                Put(value);
            }
        }
    }
    void Put(const std::map<std::string, std::string>& pairs) {
        Put(pairs.size());
        for (const auto& [name, value] : pairs) {
            Put(name);
            Put(value);
        }
    }
    void Put(const std::shared_ptr<const Image>& image) {
        ETALON_CHECK(image != nullptr);
        Put(*image);
    }
    template <typename T>
    requires std::is_class_v<T>
    void Put(const T& structure) { Fields(*this, structure); }

    std::string text_ = std::string(kFrameBytes, '\0');
};

class Reader {
  public:
    // `printable`: for text from a worker.
    Reader(std::string_view rest, bool printable) : rest_(rest), printable_(printable) {}

    void operator()(auto&... values) { (Get(values), ...); }

    // True if the message held what was asked of it, and no more.
    bool Complete() const { return good_ && rest_.empty(); }

  private:
    // The next `size` bytes; none, and never again any, where the message is shorter.
    std::string_view Cut(std::size_t size) {
        if (size > rest_.size()) {
            good_ = false;
            rest_ = {};
        }
        const std::string_view cut = rest_.substr(0, size);
        rest_.remove_prefix(cut.size());
        return cut;
    }
    // A number of elements of at least `bytes` each.
    std::size_t Count(std::size_t bytes) {
        std::size_t count = 0;
        Get(count);
        if (count > rest_.size() / bytes) {
            good_ = false;
            return 0;
        }
        return count;
    }
    template <Scalar T>
    void Get(T& value) {
        if (const std::string_view bytes = Cut(sizeof value); bytes.size() == sizeof value) {
            std::memcpy(&value, bytes.data(), sizeof value);
        }
    }
    // Another value than 0 and 1 is undefined in a bool.
    void Get(bool& value) {
        std::uint8_t byte = 0;
        Get(byte);
        good_ = good_ && byte <= 1;
        value = byte == 1;
    }
    void Get(std::string& text) {
        const std::string_view bytes = Cut(Count(1));
        text = printable_ ? Printable(bytes) : std::string(bytes);
    }
    template <typename T>
    void Get(std::vector<T>& values) {
        if constexpr (Scalar<T>) {
            values.resize(Count(sizeof(T)));
            const std::string_view bytes = Cut(values.size() * sizeof(T));
            std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(values.data()));
        } else {
            values.resize(Count(1));
            for (T& value : values) {
                Get(value);
            }
        }
    }
    void Get(std::map<std::string, std::string>& pairs) {
        for (std::size_t left = Count(1); left > 0; --left) {
            std::pair<std::string, std::string> pair;
            Get(pair.first);
            Get(pair.second);
            pairs.insert(std::move(pair));
        }
    }
    void Get(std::shared_ptr<const Image>& image) {
        auto fresh = std::make_shared<Image>();
        Get(*fresh);
        image = std::move(fresh);
    }
    template <typename T>
    requires std::is_class_v<T>
    void Get(T& structure) { Fields(*this, structure); }

    std::string_view rest_;
    bool printable_;
    bool good_ = true;
};

enum class RequestKind : std::uint8_t { kOpen, kLoad, kRun };

std::string EncodeRequest(RequestKind kind, const auto& request) {
    Writer writer;
    writer(kind, request);
    return writer.Frame();
}

bool IsSound(const auto&) {
    return true;
}
bool IsSound(const RunTime& time) {
    return std::isfinite(time.seconds) && time.seconds >= 0 &&
           std::isfinite(time.processor_seconds) && time.processor_seconds >= 0 &&
           time.clock <= RunTime::Clock::kDevice;
}
bool IsSound(const Program& program) {
    return std::all_of(program.images.begin(), program.images.end(), [](const BoundImage& bound) {
        return IsWhole(*bound.image) && bound.sampling.filter <= Filter::kNearest &&
               bound.sampling.wrap <= Wrap::kClamp;
    });
}

template <typename T>
std::optional<Request> ReadRequest(Reader& reader) {
    T request;
    reader(request);
    if (!reader.Complete() || !IsSound(request)) {
        return std::nullopt;
    }
    return request;
}

}  // namespace

std::uint64_t FramedSize(std::string_view text) {
    std::uint64_t size = 0;
    ETALON_CHECK(text.size() >= sizeof size);
    std::memcpy(&size, text.data(), sizeof size);
    return size;
}

std::string Encode(const OpenRequest& request) {
    return EncodeRequest(RequestKind::kOpen, request);
}

std::string Encode(const Program& request) {
    return EncodeRequest(RequestKind::kLoad, request);
}

std::string Encode(const RunRequest& request) {
    return EncodeRequest(RequestKind::kRun, request);
}

std::optional<Request> DecodeRequest(std::string_view message) {
    Reader reader(message, false);
    RequestKind kind = {};
    reader(kind);
    switch (kind) {
        case RequestKind::kOpen:
            return ReadRequest<OpenRequest>(reader);
        case RequestKind::kLoad:
            return ReadRequest<Program>(reader);
        case RequestKind::kRun:
            return ReadRequest<RunRequest>(reader);
    }
    return std::nullopt;
}

template <typename T>
std::string EncodeAnswer(const DeviceResult<T>& answer) {
    Writer writer;
    writer(answer.ok());
    if (answer.ok()) {
        writer(*answer);
    } else {
        writer(DeviceFailure{answer.error().kind, answer.error().reason.substr(0, kLongestReason)});
    }
    return writer.Frame();
}

template <typename T>
std::optional<DeviceResult<T>> DecodeAnswer(std::string_view message) {
    Reader reader(message, true);
    std::uint8_t good = 0;  // no bool: another value than 0 and 1 is undefined in one
    reader(good);
    if (good == 1) {
        T value = {};
        reader(value);
        if (reader.Complete() && IsSound(value)) {
            return value;
        }
        return std::nullopt;
    }
    DeviceFailure failure;
    reader(failure);
    if (good != 0 || !reader.Complete() || failure.kind > DeviceFailure::Kind::kLost) {
        return std::nullopt;
    }
    return failure;
}

template std::string EncodeAnswer(const DeviceResult<DeviceInfo>&);
template std::string EncodeAnswer(const DeviceResult<std::uint32_t>&);
template std::string EncodeAnswer(const DeviceResult<RunTime>&);
template std::optional<DeviceResult<DeviceInfo>> DecodeAnswer(std::string_view);
template std::optional<DeviceResult<std::uint32_t>> DecodeAnswer(std::string_view);
template std::optional<DeviceResult<RunTime>> DecodeAnswer(std::string_view);

std::string Printable(std::string_view text) {
    std::string clean(text);
    std::replace_if(
        clean.begin(), clean.end(),
        [](char c) { return (c < ' ' || c > '~') && c != '\n' && c != '\t'; }, '?');
    return clean;
}

}  // namespace etalon
