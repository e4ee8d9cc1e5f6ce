// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QImage>
#include <QObject>

#include "assets/asset_client.h"
#include "background/worker.h"
#include "measured/kept_tables.h"
#include "render/gpu/texture_source.h"

namespace patina {

/// Holds every image on a surface once, however many materials use it, and has the tables of
/// measured files read. A worker thread has images read by the files process and reads tables
/// itself; views draw without an image, and a matte grey for a table, until it is there.
class TextureLibrary : public QObject {
    Q_OBJECT

  public:
    using Client = std::function<AssetClient&()>;

    /// `client` returns the files process, which outlives the library.
    explicit TextureLibrary(Client client, QObject* parent = nullptr);

    /// Returns what is known of an image. Starts loading a file that was not asked for yet.
    TextureLookup find(const TextureUse& use, TextureDecoding decoding);

    /// Returns a table of a measured file by its number (tableNumber()): grey until it is read,
    /// which begins with the first call.
    SharedTable table(int number);

    /// Reads a measured file, again where it has changed, and then calls `done`, which may read it
    /// once more to know what is wrong with it; without it failed() says so.
    void readTable(const std::filesystem::path& file, std::function<void()> done = {});

    /// Returns the images that are loaded now, for another thread; it never loads more.
    TextureSource snapshot() const;

    /// Returns a small image of a file, at most 64 pixels wide and high; null if it was never
    /// loaded.
    QImage preview(const std::string& file) const;

    /// Returns whether a part of the file is not opaque; false if it was never loaded.
    bool hasAlpha(const std::string& file) const;

    /// Says why a file is missing; empty if it is not.
    QString problem(const TextureUse& use) const;

    bool isLoading() const { return !loading_.empty(); }

    /// Forgets failures, so that the next frame tries again.
    void forgetFailures();

    /// Reads all images in use again; views show what they have until then.
    void readAgain();

  Q_SIGNALS:
    void loadingStarted(QString file);
    void failed(QString file, patina::Error why); ///< is also emitted when it was cancelled
    void arrived(); ///< is emitted when an image or a table is loaded, or could not be

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

    /// Has tables read by `reading`, all of one file.
    void read(const std::filesystem::path& file, const std::vector<int>& tables,
              const std::function<Result<void>()>& reading, std::function<void()> done = {});
    void load(const Key& key);
    void finish(const Key& key, const Answer& answer);
    void dropUnused();

    Client client_;
    /// Returns what is known of an image; empty if it was neither loaded nor failed.
    static std::optional<TextureLookup> among(const Pictures& pictures, const Failures& failures,
                                              const TextureUse& use, TextureDecoding decoding);
    Pictures pictures_;
    std::set<Key, Less> loading_;
    std::set<int> loadingTables_; ///< has their numbers
    Failures failures_;
    std::map<std::string, Known, std::less<>> known_;
    Worker worker_;
};

} // namespace patina
