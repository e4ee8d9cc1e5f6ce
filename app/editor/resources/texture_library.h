// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <QImage>
#include <QObject>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Every image on a surface that the editor has, each once however many materials show it. Files
/// are read by the files process, asked from a worker thread; the views draw without them until
/// then.
class TextureLibrary : public QObject {
    Q_OBJECT

  public:
    using Client = std::function<AssetClient&()>;

    /// `client` gives the files process; it outlives the library.
    explicit TextureLibrary(Client client, QObject* parent = nullptr);

    /// Returns what there is of an image. A file that was not asked for yet starts loading.
    TextureLookup find(const TextureUse& use, TextureDecoding decoding);

    /// Returns what there is now, for another thread: nothing more is loaded for it.
    TextureSource snapshot() const;

    /// A small picture of a file, as far as it is known; null while it is not.
    QImage preview(const std::string& file) const;

    /// Tells whether some of the file is not opaque, as far as it is known.
    bool hasAlpha(const std::string& file) const;

    /// Why a file is missing; empty while it is not.
    QString problem(const TextureUse& use) const;

    bool isLoading() const { return !loading_.empty(); }

    /// Forgets failures, so that the next frame tries again.
    void forgetFailures();

  Q_SIGNALS:
    void loadingStarted(QString file);
    void failed(QString file, patina::Error why); ///< also when it was cancelled
    void arrived(); ///< an image that was asked for is there, or will not come

  private:
    using Key = std::pair<std::string, TextureDecoding>;
    struct Less {
        using is_transparent = void;
        template <class A, class B>
        bool operator()(const A& a, const B& b) const {
            const int order = a.first.compare(b.first);
            return order < 0 || (order == 0 && a.second < b.second);
        }
    };
    using Picture = std::shared_ptr<const TexturePicture>;
    using Pictures = std::map<Key, Picture, Less>;
    using Failures = std::map<Key, Error, Less>;
    using Answer = Result<Picture>;
    struct Known {
        QImage preview;
        bool hasAlpha = false;
    };

    void load(const Key& key);
    void finish(const Key& key, const Answer& answer);
    void dropUnused();

    Client client_;
    /// Returns what is known; nothing where nobody asked or nobody answered yet.
    static std::optional<TextureLookup> among(const Pictures& pictures, const Failures& failures,
                                              const TextureUse& use, TextureDecoding decoding);
    Pictures pictures_;
    std::set<Key, Less> loading_;
    Failures failures_;
    std::map<std::string, Known, std::less<>> known_;
    Worker worker_;
};

} // namespace patina
