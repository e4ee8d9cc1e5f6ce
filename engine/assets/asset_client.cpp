// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/asset_client.h"

#include <map>
#include <mutex>
#include <optional>
#include <system_error>
#include <utility>

#include "assets/files_session.h"
#include "assets/image_block.h"
#include "assets/job_queue.h"
#include "assets/mesh_block.h"
#include "assets/shared_block.h"
#include "assets/sibling_program.h"
#include "assets/text_block.h"
#include "core/ordinary_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

class MappedMesh final : public SharedMesh {
  public:
    MappedMesh(SharedBlock block, std::vector<MeshPartView> parts, std::string remarks)
        : block_(std::move(block)), parts_(std::move(parts)), remarks_(std::move(remarks)) {}

    const std::vector<MeshPartView>& parts() const override { return parts_; }
    const std::string& remarks() const override { return remarks_; }

  private:
    SharedBlock block_;
    std::vector<MeshPartView> parts_;
    std::string remarks_;
};

AssetClient::Options completed(AssetClient::Options options) {
    if (options.program.empty()) {
        options.program = siblingProgram("patina-files");
    }
    return options;
}

/// Returns an absolute path, since the working folder of the process may be another one.
std::string fullPath(const fs::path& file) {
    std::error_code failed;
    const fs::path full = fs::absolute(file, failed);
    return (failed ? file : full).string();
}

Result<FileHandle> sharedImage(const fs::path& file, const Image& image) {
    const std::size_t size = ImageBlock::sizeFor(image.width, image.height, image.channels);
    const std::size_t count =
        std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels);
    if (size == 0 || image.pixels.size() != count) {
        return tl::unexpected(Error{file.string(), 0, 0,
                                    "the image to write has no pixels, or too many",
                                    "1, 3 or 4 channels and at most 1 GiB"});
    }
    auto block = SharedBlock::create(size);
    if (!block) {
        return tl::unexpected(block.error());
    }
    ImageBlock::write(block->bytes(), image);
    return SharedBlock::seal(std::move(*block));
}

} // namespace

class AssetClient::Implementation {
  public:
    explicit Implementation(Options options) : session_(completed(std::move(options))) {}

    /// Sends the request on the queue's thread, because the process ends with the thread that
    /// started it. There `interpret` turns the answer into a Result<Answer>; its error ends the
    /// process.
    template <class Answer>
    Result<Answer> ask(const FilesSession::Request& request, auto interpret) {
        Result<Answer> result =
            tl::unexpected(Error{request.file.string(), 0, 0, "cancelled before it began", {}});
        const auto work = [&] {
            auto answer = session_.ask(request);
            if (request.message.kind == MessageKind::readMesh) {
                const std::scoped_lock lock(mutex_);
                refusedLinks_[request.file] = session_.refusedLinks();
            }
            if (!answer) {
                result = tl::unexpected(answer.error());
                return;
            }
            result = interpret(std::move(*answer)).map_error([&](const Error& error) {
                return session_.refuse(request, error.problem);
            });
        };
        queue_.run(work, request.progress != nullptr ? &request.progress->cancelled : nullptr);
        return result;
    }

    void setRights(FileRights rights) {
        const std::scoped_lock lock(mutex_);
        rights_ = std::move(rights);
    }

    FileRights rights() const {
        const std::scoped_lock lock(mutex_);
        return rights_;
    }

    std::vector<std::string> refusedLinks(const fs::path& mesh) const {
        const std::scoped_lock lock(mutex_);
        const auto found = refusedLinks_.find(mesh);
        return found == refusedLinks_.end() ? std::vector<std::string>() : found->second;
    }

    std::optional<Error> reasonNotReadable(const fs::path& file) {
        {
            const std::scoped_lock lock(mutex_);
            if (rights_.withheld.contains(file.generic_string())) {
                return Error{file.string(),
                             0,
                             0,
                             "lies outside the folder of the file that names it and is not read",
                             {}};
            }
        }
        const auto opened = OrdinaryFile::open(file, maxAssetBytes);
        return opened ? std::nullopt : std::optional(opened.error());
    }

    void warmUp(bool images) {
        queue_.post([this, images] { session_.warmUp(images); });
    }

  private:
    mutable std::mutex mutex_; // guards rights_ and refusedLinks_
    FileRights rights_;
    std::map<fs::path, std::vector<std::string>> refusedLinks_;
    FilesSession session_;
    JobQueue queue_; // last, so that its thread ends before the session does
};

AssetClient::AssetClient(Options options)
    : implementation_(std::make_unique<Implementation>(std::move(options))) {}
AssetClient::AssetClient() : AssetClient(Options{}) {}
AssetClient::~AssetClient() = default;

void AssetClient::setRights(FileRights rights) {
    implementation_->setRights(std::move(rights));
}

std::vector<std::string> AssetClient::refusedLinks(const fs::path& mesh) const {
    return implementation_->refusedLinks(mesh);
}

Result<std::shared_ptr<const SharedMesh>> AssetClient::loadMesh(const MeshRequest& mesh,
                                                                Progress* progress) {
    if (auto reason = implementation_->reasonNotReadable(mesh.file)) {
        return tl::unexpected(std::move(*reason));
    }
    const FileRights rights = implementation_->rights();
    const std::vector<double> numbers{mesh.scale, mesh.fitUnitBox ? 1.0 : 0.0,
                                      mesh.flipNormals ? 1.0 : 0.0, mesh.byMaterial ? 1.0 : 0.0,
                                      rights.allowsEveryLink ? 1.0 : 0.0};
    const std::vector<std::string> links(rights.links.begin(), rights.links.end());
    const std::vector<std::string> texts{fullPath(mesh.file), joinedPaths(links)};
    const FilesSession::Request request{
        {MessageKind::readMesh, numbers, texts}, mesh.file, "reading", {}, progress};
    using Shared = std::shared_ptr<const SharedMesh>;
    return implementation_->ask<Shared>(request, [](FilesSession::Answer answer) -> Result<Shared> {
        auto block = SharedBlock::open(std::move(answer.attachment));
        if (!block) {
            return tl::unexpected(block.error());
        }
        auto parts = MeshBlock::checked(std::as_const(*block).bytes());
        if (!parts) {
            return tl::unexpected(parts.error());
        }
        return std::make_shared<MappedMesh>(std::move(*block), std::move(*parts),
                                            std::move(answer.remarks));
    });
}

Result<Image> AssetClient::loadImage(const fs::path& file, Progress* progress) {
    if (auto reason = implementation_->reasonNotReadable(file)) {
        return tl::unexpected(std::move(*reason));
    }
    const FilesSession::Request request{
        {MessageKind::readImage, {}, {fullPath(file)}}, file, "reading", {}, progress};
    return implementation_->ask<Image>(request, [](FilesSession::Answer answer) {
        return SharedBlock::open(std::move(answer.attachment))
            .and_then([](const SharedBlock& block) { return ImageBlock::checked(block.bytes()); });
    });
}

Result<std::shared_ptr<const TexturePicture>>
AssetClient::loadTexture(const fs::path& file, TextureDecoding decoding, Progress* progress) {
    if (auto reason = implementation_->reasonNotReadable(file)) {
        return tl::unexpected(std::move(*reason));
    }
    const FilesSession::Request request{
        {MessageKind::readImage, {1.0}, {fullPath(file)}}, file, "reading", {}, progress};
    auto numbers = implementation_->ask<FileImage>(request, [](FilesSession::Answer answer) {
        return SharedBlock::open(std::move(answer.attachment))
            .and_then([](const SharedBlock& block) {
                return ImageBlock::checked(block.bytes()).map([&block](Image image) {
                    return FileImage{std::move(image), ImageBlock::bits(block.bytes())};
                });
            });
    });
    if (!numbers) {
        return tl::unexpected(numbers.error());
    }
    const auto cancelled = [progress] { return progress != nullptr && progress->cancelled; };
    auto picture = madeTexture(*numbers, decoding, cancelled);
    if (cancelled()) {
        return tl::unexpected(Error{file.string(), 0, 0, "cancelled while reading", {}});
    }
    return std::make_shared<const TexturePicture>(std::move(picture));
}

Result<void> AssetClient::saveImage(const fs::path& file, const Image& image, Progress* progress) {
    auto pixels = sharedImage(file, image);
    if (!pixels) {
        return tl::unexpected(pixels.error());
    }
    const FilesSession::Request request{{MessageKind::writeImage, {}, {fullPath(file)}},
                                        file,
                                        "writing",
                                        std::move(*pixels),
                                        progress};
    return implementation_->ask<void>(
        request, [](const FilesSession::Answer&) -> Result<void> { return {}; });
}

Result<std::string> AssetClient::encodeImage(const std::string& extension, const Image& image) {
    auto pixels = sharedImage(extension, image);
    if (!pixels) {
        return tl::unexpected(pixels.error());
    }
    const FilesSession::Request request{{MessageKind::encodeImage, {}, {extension}},
                                        extension,
                                        "writing",
                                        std::move(*pixels),
                                        nullptr};
    return implementation_->ask<std::string>(request, [](FilesSession::Answer answer) {
        return SharedBlock::open(std::move(answer.attachment))
            .and_then([](const SharedBlock& block) { return TextBlock::checked(block.bytes()); });
    });
}

void AssetClient::warmUp(Formats formats) {
    implementation_->warmUp(formats == Formats::images);
}

} // namespace patina
