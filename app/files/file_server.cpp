// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_server.h"

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "assets/image_block.h"
#include "assets/mesh_block.h"
#include "assets/text_block.h"
#include "core/atomic_file.h"
#include "io/mesh_folder.h"
#include "io/mesh_reader.h"
#include "io/png_writer.h"

namespace patina {
namespace {

namespace fs = std::filesystem;
constexpr std::chrono::milliseconds forEver{-1};
constexpr std::chrono::milliseconds betweenReports{30};

Error named(Error error, const fs::path& file) {
    error.file = file.string();
    return error;
}

/// Sends the client the progress, but not more often than anyone could see.
class Reporter {
  public:
    explicit Reporter(const Channel& channel) : channel_(channel) {}

    void operator()(double done) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ >= betweenReports) {
            last_ = now;
            channel_.send({MessageKind::progress, {done}, {}});
        }
    }

  private:
    const Channel& channel_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

/// Returns a duplicate of a handle, because a delivery is const here and the block has to own its
/// descriptor.
FileHandle duplicate(const FileHandle& handle) {
    return FileHandle(handle ? ::fcntl(handle.get(), F_DUPFD_CLOEXEC, 0) : -1);
}

} // namespace

FileServer::FileServer(Channel channel) : channel_(std::move(channel)) {}

int FileServer::run() {
    while (true) {
        const auto request = channel_.receive(forEver);
        if (!request) {
            return request.error() == Channel::Fault::closed ? 0 : 1;
        }
        if (!request->has_value()) {
            continue; // a signal woke it
        }
        if ((*request)->message.kind == MessageKind::warmImages) {
            images_.prefetch();
        } else if (!send(guarded(**request))) {
            return 0;
        }
    }
}

Result<FileServer::Answer> FileServer::guarded(const Channel::Delivery& request) {
    refusedLinks_.clear();
    const std::string file =
        request.message.texts.empty() ? std::string() : request.message.texts.front();
    try {
        return answer(request);
    } catch (const std::bad_alloc&) {
        return tl::unexpected(Error{file, 0, 0, "needs more memory than is allowed here", {}});
    } catch (const std::exception& problem) {
        return tl::unexpected(Error{file, 0, 0, std::string("is damaged: ") + problem.what(), {}});
    } catch (...) {
        return tl::unexpected(Error{file, 0, 0, "is damaged", {}});
    }
}

Result<FileServer::Answer> FileServer::answer(const Channel::Delivery& request) {
    if (request.message.texts.empty()) {
        return failure("the request names no file");
    }
    switch (request.message.kind) {
    case MessageKind::readMesh:
        return readMesh(request.message);
    case MessageKind::readImage:
        return readImage(request.message);
    case MessageKind::writeImage:
        return writeImage(request);
    case MessageKind::encodeImage:
        return encodeImage(request);
    default:
        return failure("the request is not one");
    }
}

Result<FileServer::Answer> FileServer::readMesh(const Message& request) {
    MeshOptions options;
    LinkRights rights;
    if (request.numbers.size() == 5 && request.texts.size() == 2) {
        options = {request.numbers[0], request.numbers[1] != 0.0, request.numbers[2] != 0.0,
                   request.numbers[3] != 0.0};
        rights = {request.numbers[4] != 0.0, splitPaths(request.texts[1])};
    }
    std::optional<SharedBlock> block;
    const MeshStorage storage = [&](std::span<const MeshPart> parts) -> Result<MeshSpans> {
        const std::size_t size = MeshBlock::sizeFor(parts);
        auto fresh = size != 0 ? SharedBlock::create(size) : failure("is too large");
        if (!fresh) {
            return tl::unexpected(fresh.error());
        }
        block.emplace(std::move(*fresh));
        const MeshBlock mesh = MeshBlock::format(block->bytes(), parts);
        return MeshSpans{mesh.vertices, mesh.indices, mesh.colors};
    };
    const auto folder = std::make_shared<MeshFolder>(request.texts[0], std::move(rights));
    auto reading = patina::readMesh(folder, options, storage, Reporter(channel_));
    refusedLinks_ = missedPlaces(*folder);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    auto handle = SharedBlock::seal(std::move(*block));
    if (!handle) {
        return tl::unexpected(handle.error());
    }
    return Answer{std::move(reading->remarks), std::move(*handle), std::move(reading->leftovers)};
}

Result<FileServer::Answer> FileServer::readImage(const Message& request) {
    const auto codec = images_.codec();
    if (!codec) {
        return tl::unexpected(codec.error());
    }
    int bits = 0;
    const bool asItIs = !request.numbers.empty() && request.numbers[0] != 0.0;
    const auto image =
        asItIs ? (*codec)->readNumbers(request.texts[0], bits) : (*codec)->read(request.texts[0]);
    if (!image) {
        return tl::unexpected(image.error());
    }
    auto block =
        SharedBlock::create(ImageBlock::sizeFor(image->width, image->height, image->channels));
    if (!block) {
        return tl::unexpected(named(block.error(), request.texts[0]));
    }
    ImageBlock::write(block->bytes(), *image, bits);
    return SharedBlock::seal(std::move(*block)).map([](FileHandle handle) {
        return Answer{{}, std::move(handle), {}};
    });
}

Result<std::string> FileServer::encoded(const Channel::Delivery& request,
                                        const std::string& extension) {
    const auto block = SharedBlock::open(duplicate(request.attachment));
    if (!block) {
        return tl::unexpected(block.error());
    }
    const auto image = ImageBlock::checked(block->bytes());
    if (!image) {
        return tl::unexpected(image.error());
    }
    if (extension == ".png") {
        return encodedPng(*image);
    }
    return images_.codec().and_then(
        [&](const ImageCodec* codec) { return codec->encode(extension, *image); });
}

Result<FileServer::Answer> FileServer::writeImage(const Channel::Delivery& request) {
    const fs::path file = request.message.texts[0];
    const auto bytes = encoded(request, file.extension().string());
    if (!bytes) {
        return tl::unexpected(named(bytes.error(), file));
    }
    return writeFileAtomically(file, *bytes).map([] { return Answer{}; });
}

Result<FileServer::Answer> FileServer::encodeImage(const Channel::Delivery& request) {
    const auto bytes = encoded(request, request.message.texts[0]);
    if (!bytes) {
        return tl::unexpected(bytes.error());
    }
    auto block = SharedBlock::create(TextBlock::sizeFor(bytes->size()));
    if (!block) {
        return tl::unexpected(block.error());
    }
    TextBlock::write(block->bytes(), *bytes);
    return SharedBlock::seal(std::move(*block)).map([](FileHandle handle) {
        return Answer{{}, std::move(handle), {}};
    });
}

bool FileServer::send(const Result<Answer>& answer) {
    const std::string refused = joinedPaths(refusedLinks_);
    if (answer) {
        return channel_.send({MessageKind::done, {}, {answer->remarks, refused}},
                             answer->block.get());
    }
    const Error& error = answer.error();
    return channel_.send({MessageKind::failed,
                          {static_cast<double>(error.line), static_cast<double>(error.column)},
                          {error.problem, error.expected, refused}});
}

} // namespace patina
