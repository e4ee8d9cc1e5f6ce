// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/color.h"
#include "core/number_text.h"
#include "exchange/format_writers.h"
#include "exchange/image_settings.h"
#include "material/texture_place.h"

namespace patina {
namespace {

/// Writes one material of an MTL file: colours as a screen shows them, as readers take them.
class MtlMaterial {
  public:
    MtlMaterial(ExportedLook& look, ExportImages& images) : look_(look), images_(images) {}

    std::string write() {
        text_ = fmt::format("newmtl {}\n", look_.material.name);
        if (look_.material.isMetal()) {
            writeMetal();
        } else {
            writeClassical();
        }
        if (imageFactor(look_, "emissive") != glm::dvec3(0.0)) {
            writeColor("Ke", "emissive");
        }
        if (look_.material.values.contains("opacity")) {
            writeNumber("d", "opacity", look_.value("opacity").x);
        }
        writeImage("map_d", "opacity");
        writeImage("norm", "normal");
        writeHeight();
        return text_;
    }

  private:
    void writeClassical() {
        const bool isShiny = look_.material.values.contains("specular");
        text_ += isShiny ? "illum 2\n" : "illum 1\n";
        writeColor("Kd", "diffuse");
        if (isShiny) {
            writeColor("Ks", "specular");
            writeNumber("Ns", "shininess", look_.value("shininess").x);
        }
    }

    /// Writes the addition for metals that many programs read.
    void writeMetal() {
        text_ += "illum 2\n";
        writeColor("Kd", "f0");
        text_ += "Pm 1\n";
        writeNumber("Pr", "alpha", std::sqrt(look_.value("alpha").x));
    }

    void writeNumber(const char* key, const std::string& word, double value) {
        text_ += fmt::format("{} {}\n", key, fullText(value));
        look_.tellOf(word, Kept::Exact, fmt::format("{} {}", key, shortestFloatText(value)));
        dropImage(word);
    }

    void writeColor(const char* key, const std::string& word) {
        const glm::dvec3 shown = srgbEncoded(imageFactor(look_, word));
        text_ += fmt::format("{} {} {} {}\n", key, fullText(shown.x), fullText(shown.y),
                             fullText(shown.z));
        look_.tellOf(word, Kept::Exact, fmt::format("{}, as a screen shows it", key));
        writeImage(fmt::format("map_{}", key).c_str(), word);
    }

    /// Tells of an image on a number: MTL has none for it.
    void dropImage(const std::string& word) {
        const TextureUse* image = look_.image(word);
        if (image != nullptr && word != "opacity") {
            look_.tell(Kept::Dropped, imageTitle(*image),
                       fmt::format("drives {}, for which there is no map", look_.labels[word]));
        }
    }

    void writeHeight() {
        if (TextureUse* image = look_.image("height")) {
            const double strength = std::exchange(image->strength, 1.0);
            writeImage(fmt::format("map_Bump -bm {}", shortestFloatText(strength)).c_str(),
                       "height");
        }
    }

    void writeImage(const char* key, const std::string& word) {
        const TextureUse* image = look_.image(word);
        if (image == nullptr) {
            return;
        }
        const TextureUse& use = *image;
        const auto path = images_.add(use.file, {});
        if (!path || isAdded(use)) {
            look_.tell(Kept::Dropped, imageTitle(use),
                       path ? "is added to the colour" : path.error().text());
            return;
        }
        text_ += fmt::format("{} {}{}\n", key, placed(use), *path);
        std::string lost = lostSettings(use);
        if (use.rotation != 0.0) {
            lost += (lost.empty() ? "" : ", ") + std::string("its rotation");
        }
        look_.tell(lost.empty() ? Kept::Exact : Kept::Approximated, imageTitle(use),
                   lost.empty() ? std::string(key) : fmt::format("{}, without {}", key, lost));
    }

    /// Returns the options that place an image, which is not turned.
    static std::string placed(TextureUse use) {
        use.rotation = 0.0;
        const TexturePlace place = texturePlace(use);
        return isUnplaced(use)
                   ? std::string()
                   : fmt::format("-s {} {} 1 -o {} {} 0 ", shortestFloatText(place.across.x),
                                 shortestFloatText(place.up.y), shortestFloatText(place.across.z),
                                 shortestFloatText(place.up.z));
    }

    ExportedLook& look_;
    ExportImages& images_;
    std::string text_;
};

} // namespace

std::string writeMtl(std::vector<ExportedLook>& materials, ExportImages& images) {
    std::string text = "# Made by Patina\n";
    for (ExportedLook& look : materials) {
        text += '\n' + MtlMaterial(look, images).write();
    }
    return text;
}

} // namespace patina
