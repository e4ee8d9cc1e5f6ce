// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/lobe/albedo_curve.h"

namespace patina {

class EvalGpu;

/// Names the plots of a material that are lines over an angle, or over the wavelength.
enum class LobePlot {
    Polar,
    Albedo,
    Fresnel,
    Spectrum, ///< the index of refraction and what is mirrored facing the surface, by wavelength
    Float32,  ///< how far single precision on the device is from double, in the plane of incidence
    Float16   ///< the same of floats of 16 bits, as an evaluation on the processor rounds them
};

/// Returns the word of a plot: "polar", "albedo", "fresnel", "spectrum", "float32", "float16"; and
/// the plot of a word.
std::string_view wordOf(LobePlot plot);
std::optional<LobePlot> lobePlotOf(std::string_view word);

/// Tells which side of an interface a line is of, and what kind of light.
enum class LobeStroke {
    Main,      ///< is what the plot is about
    Exact,     ///< is the same with every accuracy choice at its exact level
    Across,    ///< is of light polarised across the plane of incidence (s)
    Along,     ///< is of light polarised in the plane of incidence (p)
    Extinction ///< is the extinction beside an index
};

/// Is a line of a plot, a value per channel over an angle or a wavelength.
struct LobeLine {
    std::string name; ///< "reflectance", "from outside R_s", ...
    LobeStroke stroke = LobeStroke::Main;
    bool isFromInside = false;
    std::vector<double> at;         ///< degrees from the normal, or nanometres; rising
    std::vector<glm::dvec3> values; ///< as many; 1/sr in a polar plot, units in the last place of
                                    ///< a float in that of single precision, else shares of light
    bool isShare = false;           ///< says that values are shares where the plot's others are not
    bool isSampled = false; ///< says that it is known at its points alone, and straight between
    int digits = 0;         ///< counts those that a reading shows; 0: as usual
};

/// Is a place of a plot with a name, such as Brewster's angle or the wavelength of red.
struct LobeMark {
    std::string name; ///< "Brewster", "critical from inside (red)"
    double at = 0.0;  ///< degrees or nanometres
};

/// Holds the lines of one material.
struct LobeLines {
    std::vector<LobeLine> lines;
    std::vector<LobeMark> marks;
    std::string note; ///< says what the lines leave out or assume; may be empty
};

/// Is a material in a plot.
struct LobeSubject {
    std::string name;
    LobeLines lines;
};

/// Says which lines are wanted.
struct LobeRequest {
    LobePlot plot = LobePlot::Polar;
    Incoming incoming; ///< of a polar plot; the others take its azimuth alone
    LobeTerm term = LobeTerm::Whole;
    bool isSketch =
        false; ///< is drawn while a slider moves: fewer angles, albedos to 0.02 up to 85 degrees

    friend bool operator==(const LobeRequest&, const LobeRequest&) = default;
};

/// Returns what lines are over: "degrees" or "nanometres".
std::string_view abscissaOf(LobePlot plot);

/// Returns the lines of a material. It is an error where the plot means nothing for it, and why.
/// Where `isWanted` becomes false, lines end early. A model without code in double precision is
/// evaluated on the device, and the note says so; without a device it is an error. So are floats of
/// 16 bits, whose lines halfLines() returns.
Result<LobeLines> lobeLines(
    const Catalog& catalog, const Material& material, const LobeRequest& request,
    const std::function<bool()>& isWanted = [] { return true; }, EvalGpu* device = nullptr);

/// Is the angle from the normal, in degrees, up to which a plot of shares has room for all values.
/// At flatter ones what some models reflect goes far above all light, and nothing else would be
/// seen.
inline constexpr double roomyDegrees = 85.0;

/// Returns a line's value at a place, between its points; the first or last one beyond its ends.
/// The line must have a point.
glm::dvec3 valueAt(const LobeLine& line, double at);

/// Returns what an interface lets pass, where a line is what it reflects: "from outside T_s".
std::optional<LobeLine> transmittedLine(const LobeLine& line);

/// Tells whether the three channels are the same.
bool isGrey(const LobeLine& line);

/// Returns the one number that a plot of several materials draws for three channels: the luminance,
/// or of errors the largest.
double overlaidValue(LobePlot plot, const glm::dvec3& channels);

/// Says what a plot draws for three channels that differ, "luminance" or "largest of the channels";
/// empty where it draws each, or none differ.
std::string_view overlaidWord(LobePlot plot, const std::vector<LobeSubject>& subjects);

/// Returns the albedo of a material with a grain for light from azimuths that the request's is not;
/// nothing of one without, nor of one that is evaluated on the device. Lines end early where
/// `isWanted` becomes false.
std::vector<LobeLine> turnedAlbedos(const Catalog& catalog, const Material& material,
                                    const LobeRequest& request,
                                    const std::function<bool()>& isWanted);

/// Returns the range of lines that are the albedo of one material from several azimuths, each of
/// two points or more: per channel, or of its luminance.
EnergyRange energyRange(std::span<const LobeLine> albedos);
EnergyRange luminanceRange(std::span<const LobeLine> albedos);

/// Is how far above 1 an albedo has to be to count: it is known no better.
inline constexpr double albedoNoise = 1e-4;

} // namespace patina
