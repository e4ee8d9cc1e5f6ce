// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "measure/eval/eval_gpu.h"
#include "measure/lobe/albedo_curve.h"

namespace patina {

/// Returns the reflectance f in 1/sr of a case's model for light from `l` to each viewer, as the
/// device computes it in single precision. Directions are unit; what is not finite counts as 0.
Result<std::vector<glm::dvec3>> deviceReflectances(EvalGpu& device, const Catalog& catalog,
                                                   const EvalCase& request, const glm::dvec3& l,
                                                   std::span<const glm::dvec3> viewers);

/// Returns the polar curve by the device, with points closer about the mirror direction.
Result<std::vector<LobePoint>> devicePolarCurve(EvalGpu& device, const Catalog& catalog,
                                                const EvalCase& request, const Incoming& incoming);

/// Returns the albedo by the device at ten angles, by a rule that fits lobes of ordinary widths.
Result<std::vector<AlbedoPoint>> deviceAlbedoCurve(EvalGpu& device, const Catalog& catalog,
                                                   const EvalCase& request, double azimuth);

/// Holds cases in the plane of incidence, at every degree and about the mirror direction, with
/// directions that are floats.
struct PlaneCases {
    std::vector<double> angles; ///< are radians from the normal, positive on the mirror's side
    std::vector<EvalCase> cases;
};

PlaneCases planeCases(const EvalCase& request, const Incoming& incoming);

/// Is how far the device's value is from the exact one at an angle.
struct FloatError {
    double angle = 0.0;   ///< radians from the normal, positive on the mirror's side
    glm::dvec3 ulps{0.0}; ///< units in the last place of a float, per channel
};

/// Returns the errors of single precision in the plane of incidence, at every degree and about the
/// mirror direction. Both are asked at the same directions, which are floats. It is an error for a
/// block that cannot be evaluated in double precision, and without a graphics driver.
Result<std::vector<FloatError>> floatErrors(EvalGpu& device, const Catalog& catalog,
                                            const EvalCase& request, const Incoming& incoming);

} // namespace patina
