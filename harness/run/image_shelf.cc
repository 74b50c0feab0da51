#include "run/image_shelf.h"

#include <deque>
#include <map>
#include <mutex>
#include <string>

#include "numeric/number_text.h"
#include "run/images.h"

namespace etalon {
namespace {

constexpr std::size_t kMostBytes = std::size_t{256} << 20;

using Held = std::shared_ptr<const Image>;

std::size_t BytesOf(const Image& image) {
    return image.rgba.size() * sizeof(float);
}

// Two computed images with the same text are the same. How they are sampled is no part of them.
std::string TextOf(const ImageSource& source) {
    std::string text = std::to_string(source.width) + " " + std::to_string(source.height) + " " +
                       std::to_string(static_cast<int>(source.shape)) + " " +
                       std::to_string(static_cast<int>(source.levels));
    if (source.bake) {
        const bake::Plan& plan = *source.bake;
        text += " " + std::to_string(static_cast<int>(plan.kind)) + " " +
                std::to_string(plan.slices.value_or(0)) + " " +
                std::to_string(plan.bearings.value_or(0)) + " " +
                Shortest(plan.texels_per_height.value_or(0)) + " " +
                std::to_string(static_cast<int>(plan.published)) + " " + Shortest(plan.scale) +
                " " + Shortest(plan.level);
    }
    for (const Expression& channel : source.channels) {
        text += "\n" + channel.text();
    }
    return text;
}

class Shelf {
  public:
    Held Find(const std::string& text) {
        const std::lock_guard lock(mutex_);
        const auto known = known_.find(text);
        return known == known_.end() ? nullptr : known->second.lock();
    }

    void Put(const std::string& text, const Held& image) {
        const std::lock_guard lock(mutex_);
        known_[text] = image;
        latest_.push_back(image);
        bytes_ += BytesOf(*image);
        while (bytes_ > kMostBytes) {
            bytes_ -= BytesOf(*latest_.front());
            latest_.pop_front();
        }
    }

  private:
    std::mutex mutex_;
    std::map<std::string, std::weak_ptr<const Image>> known_;
    std::deque<Held> latest_;
    std::size_t bytes_ = 0;
};

}  // namespace

Result<std::shared_ptr<const Image>> SharedImage(const ImageSource& source,
                                                 const std::filesystem::path& base) {
    static Shelf shelf;
    const bool is_computed = source.files.empty();
    const std::string text = is_computed ? TextOf(source) : "";
    if (is_computed) {
        if (Held image = shelf.Find(text)) {
            return image;
        }
    }
    ETALON_TRY(made, MakeImage(source, base));
    Held image = std::make_shared<const Image>(std::move(made));
    if (is_computed) {
        shelf.Put(text, image);
    }
    return image;
}

}  // namespace etalon
