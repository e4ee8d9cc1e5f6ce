// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina {

class CompareArea;
class Comparison;
class Document;
class DocumentFiles;
class EffectSwitches;
class EnvironmentLibrary;
class FileActions;
class MaterialActions;
class MeshLibrary;
class MessageLog;
class PresetLibrary;
class Session;
class TextureLibrary;
class ThumbnailMaker;
class TriedMaterial;

/// Holds what docks are made from. Everything in it outlives the docks.
struct DockContext {
    Document& document;
    Comparison& comparison;
    TriedMaterial& tried;
    DocumentFiles& documentFiles;
    FileActions& files;
    MaterialActions& material;
    MessageLog& messages;
    Session& session;
    PresetLibrary& presets;
    ThumbnailMaker& thumbnails;
    MeshLibrary& meshes;
    TextureLibrary& textures;
    EnvironmentLibrary& environments;
    EffectSwitches& switches;
    CompareArea& views;
};

} // namespace patina
