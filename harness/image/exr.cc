#include "image/exr.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfVersion.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <stdexcept>

#include "base/check.h"

namespace etalon {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::array<const char*, kChannels> kNames = {"R", "G", "B", "A"};
constexpr const char* kGrey = "Y";

class Input : public Imf::IStream {
  public:
    explicit Input(std::string_view bytes) : IStream("memory"), bytes_(bytes) {}

    bool read(char to[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        if (size > bytes_.size() - at_) {
            throw std::runtime_error("the file ends too soon");
        }
        std::memcpy(to, bytes_.data() + at_, size);
        at_ += size;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t at) override {
        if (at > bytes_.size()) {
            throw std::runtime_error("the file ends too soon");
        }
        at_ = at;
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

class Output : public Imf::OStream {
  public:
    Output() : OStream("memory") {}

    void write(const char from[], int count) override {
        const auto size = static_cast<std::size_t>(std::max(count, 0));
        bytes_.resize(std::max(bytes_.size(), at_ + size));
        std::memcpy(bytes_.data() + at_, from, size);
        at_ += size;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t at) override { at_ = at; }

    std::string Take() { return std::move(bytes_); }

  private:
    std::string bytes_;
    std::size_t at_ = 0;
};

// Where channel `channel` of the image begins; a slice counts from the data window's origin.
Imf::Slice SliceOf(float* rgba, std::size_t channel, const Imath::Box2i& window,
                   std::uint32_t width, double absent) {
    constexpr std::size_t kTexel = kChannels * sizeof(float);
    return Imf::Slice::Make(Imf::FLOAT, rgba + channel, window, kTexel, kTexel * width, 1, 1,
                            absent);
}

Result<Image> Decode(std::string_view bytes) {
    Input stream(bytes);
    Imf::InputFile file(stream);
    const Imath::Box2i window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (std::max(width, height) > kMostImageSide ||
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) > kMostTexels) {
        return Error{"has " + std::to_string(width) + " x " + std::to_string(height) +
                     " texels, too many"};
    }
    const Imf::ChannelList& channels = file.header().channels();
    const bool is_grey = channels.findChannel(kGrey) != nullptr;
    const bool has_colour = std::any_of(kNames.begin(), kNames.end(), [&](const char* name) {
        return channels.findChannel(name) != nullptr;
    });
    if (!is_grey && !has_colour) {
        return Error{"has none of the channels R, G, B, A and Y"};
    }
    Image image;
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    image.rgba.resize(kChannels * static_cast<std::size_t>(width * height));
    Imf::FrameBuffer target;
    for (std::size_t k = 0; k < kChannels; ++k) {
        const char* const name = k < 3 && is_grey ? kGrey : kNames[k];
        const Imf::Channel* const channel = channels.findChannel(name);
        if (channel != nullptr && (channel->xSampling != 1 || channel->ySampling != 1)) {
            return Error{"has a channel of another resolution than the image's"};
        }
        if (k > 0 && k < 3 && is_grey) {
            continue;
        }
        target.insert(name, SliceOf(image.rgba.data(), k, window, image.width, k == 3 ? 1.0 : 0.0));
    }
    file.setFrameBuffer(target);
    file.readPixels(window.min.y, window.max.y);
    if (is_grey) {
        for (std::size_t texel = 0; texel < image.rgba.size(); texel += kChannels) {
            image.rgba[texel + 1] = image.rgba[texel + 2] = image.rgba[texel];
        }
    }
    return image;
}

std::string Encode(const Image& image) {
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer source;
    // The library takes no address of constants; it only reads.
    auto* const rgba = const_cast<float*>(image.rgba.data());
    for (std::size_t k = 0; k < kChannels; ++k) {
        header.channels().insert(kNames[k], Imf::Channel(Imf::FLOAT));
        source.insert(kNames[k], SliceOf(rgba, k, header.dataWindow(), image.width, 0));
    }
    Output stream;
    {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(source);
        file.writePixels(static_cast<int>(image.height));
    }
    return stream.Take();
}

// The library's messages may have several sentences and lines.
std::string Plain(const std::exception& error) {
    std::string reason = error.what();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    return reason;
}

}  // namespace

bool IsExr(std::string_view bytes) {
    return bytes.size() >= 4 && Imf::isImfMagic(bytes.data());
}

Result<Image> DecodeExr(std::string_view bytes) {
    try {
        return Decode(bytes);
    } catch (const std::exception& error) {
        return Error{"is not an OpenEXR image (" + Plain(error) + ")"};
    }
}

Result<std::string> EncodeExr(const Image& image) {
    ETALON_CHECK(IsWhole(image) && image.shape == ImageShape::kFlat);
    try {
        return Encode(image);
    } catch (const std::exception& error) {
        return Error{"cannot be written as OpenEXR (" + Plain(error) + ")"};
    }
}

}  // namespace etalon
