// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "session/compare_look.h"
#include "session/mesh_import.h"
#include "session/mouse_scheme.h"

namespace patina {

/// Tells which look the user asked for.
enum class Look { System, Light, Dark };

/// Keeps what is remembered from one start to the next, in $XDG_CONFIG_HOME/patina/patina.ini.
class Session {
  public:
    Session();

    QByteArray windowGeometry() const;
    QByteArray windowLayout() const;
    QStringList openedDocks() const; ///< returns the names of docks that were open once
    void setWindow(const QByteArray& geometry, const QByteArray& layout);
    void setOpenedDocks(const QStringList& names);

    QStringList recentFiles() const; ///< returns the newest first, only those that exist
    void addRecentFile(const QString& file);
    void clearRecentFiles();

    /// Returns the pictures that scenes were lit with, newest first, only those that exist.
    QStringList environments() const;
    void addEnvironment(const QString& file);

    /// Returns the files outside its folder that the user allowed, or refused, a file to read. Only
    /// the answers for the files that were asked about last are remembered.
    QStringList outside(const QString& file, bool allowed) const;
    void addOutside(const QString& file, bool allowed, const QStringList& others);

    Look look() const;
    void setLook(Look look);

    MouseHabits mouseHabits() const;
    void setMouseHabits(const MouseHabits& habits);

    /// Returns the keys that the user gave a command, by its name in the menus ("File/Save");
    /// nothing where it has its usual ones.
    std::optional<QString> keysOf(const QString& command) const;
    void setKeysOf(const QString& command, const std::optional<QString>& keys);

    /// Tells whether lights are drawn into the views.
    bool showsLights() const;
    void setShowsLights(bool shows);

    CompareLook compareLook() const;
    void setCompareLook(const CompareLook& look);

    /// Tells whether preset files keep what only other models use.
    bool keepsParked() const;
    void setKeepsParked(bool keeps);

    /// Returns how meshes were imported last.
    MeshImport meshImport() const;
    void setMeshImport(const MeshImport& import);

    /// Names the lists of preset files or folders that the preset library remembers.
    enum class Presets { Favourites, Recent, Folders };
    QStringList presets(Presets which) const;
    void setPresets(Presets which, const QStringList& paths);

    /// Holds how the preset library is looked at: the size of pictures, 0 where it was never
    /// chosen, as a list or not, and the name of an order.
    struct PresetsLook {
        int pictureSize = 0;
        bool asList = false;
        QString order;
    };
    PresetsLook presetsLook() const;
    void setPresetsLook(const PresetsLook& look);

    /// Returns the folder of the file that was chosen last for a purpose ("preset", "scene",
    /// "mesh"); the home folder where there is none.
    QString folder(const QString& purpose) const;
    void setFolderOf(const QString& purpose, const QString& file);

    void sync() { settings_.sync(); }

  private:
    QSettings settings_;
};

/// Return $XDG_CONFIG_HOME/patina, $XDG_CACHE_HOME/patina, $XDG_STATE_HOME/patina and
/// $XDG_DATA_HOME/patina.
std::filesystem::path configFolder();
std::filesystem::path cacheFolder();
std::filesystem::path stateFolder();
std::filesystem::path userDataFolder();

/// Returns where compiled programs are kept.
std::filesystem::path programFolder();

} // namespace patina
