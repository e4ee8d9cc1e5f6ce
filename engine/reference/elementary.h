// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// These functions have the names and arguments of shaders/lib/elementary.glsl and return the same
// values also outside the domain, but use the C++ library: they are exact to a few units in the
// last place.
namespace patina::reference {

double atanhOverZ(double w);
double powSC(double s2, double c2, double e);
double pow1m(double d, double c, double e);
double minusLnCosBySin2(double s2, double c2);
double powNear1(double d, double c, double e);
double acos2(double x);
double asinS(double z);
double versineOf(double a);
double angleOf(double s, double c);
double ierfc(double a);
double gaussianShare(double w);
double atanhExcess(double w);
double erfcOf(double a);
double meanOfExp(double u);
double lambertW(double x);
double stirlingError(double m);
double ridgeLobe(const glm::dvec2& arc, const glm::dvec3& h, double e, const glm::dvec2& view,
                 const glm::dvec2& light);
void angXY(double c, double s2, double& x, double& y);

} // namespace patina::reference
