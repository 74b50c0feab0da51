#include "bake/bake.h"

#include <optional>

#include "base/progress.h"
#include "cmd/command.h"
#include "cmd/options.h"
#include "image/read.h"
#include "image/write.h"

namespace etalon {
namespace {

class BakeCommand : public Command {
  public:
    explicit BakeCommand(CLI::App& app);

    int Run() override;

  private:
    std::string kind_;
    std::string heights_;
    std::string out_;
    bake::Plan plan_;
};

BakeCommand::BakeCommand(CLI::App& app)
    : Command(app.add_subcommand(
          "bake", "Make a map that a search of a relief reads, from an image of its heights")) {
    plan_.level = bake::kFileLevel;
    word_->add_option("KIND", kind_, "what to make")
        ->required()
        ->check(CLI::IsMember(
            std::vector<std::string>(bake::KindNames().begin(), bake::KindNames().end())));
    word_->add_option("HEIGHT", heights_, "the image; its red channel, repeating and bilinear")
        ->required();
    word_->add_option("-o,--out", out_, "the map, OpenEXR in binary32")
        ->required()
        ->type_name("OUT.exr");
    word_->add_option("--slices", plan_.slices, "of a distance map; default: 32")->type_name("N");
    word_->add_option("--bearings", plan_.bearings, "of a horizon map; default: 16")
        ->type_name("K");
    word_
        ->add_option("--texels-per-height", plan_.texels_per_height,
                     "texels as long as the relief's box is high; default: a tenth of the width")
        ->type_name("X");
    word_->add_option("--scale", plan_.scale, "z = scale * red + level, -0.5 to 0.5 in the box")
        ->capture_default_str()
        ->type_name("X");
    word_->add_option("--level", plan_.level, "see --scale")->capture_default_str()->type_name("X");
    word_->add_flag("--published", plan_.published,
                    "a distance or cone map as published, not safe between its points");
}

int BakeCommand::Run() {
    plan_.kind = *bake::KindNamed(kind_);
    const Result<Image> heights = ReadImage(heights_);
    if (!heights) {
        return Complain(heights.error().message);
    }
    std::optional<Progress> progress;
    const Result<Image> map = bake::Bake(*heights, plan_, [&](std::int64_t parts) {
        if (!progress) {
            progress.emplace(parts);
        }
        progress->Step(kind_);
    });
    if (progress) {
        progress->Clear();
    }
    if (!map) {
        return Complain(heights_ + ": " + map.error().message);
    }
    const Status<> written = WriteExr(out_, *map);
    return written ? 0 : Complain(written.error().message);
}

}  // namespace

std::unique_ptr<Command> AddBake(CLI::App& app) {
    return std::make_unique<BakeCommand>(app);
}

}  // namespace etalon
