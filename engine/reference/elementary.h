// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The exact twins of shaders/lib/elementary.glsl over the C++ library: same names, same
/// arguments, same meaning outside the domain, good to a few units in the last place.
namespace patina::reference {

double atanhOverZ(double w);
double powSC(double s2, double c2, double e);
double pow1m(double d, double c, double e);
double minusLnCos(double s2, double c2);
double acos2(double x);
double asinS(double z);
double versineOf(double a);
double ierfc(double a);
double gaussianShare(double w);
double atanhExcess(double w);
double erfcOf(double a);
double lambertW(double x);
double stirlingError(double m);
void angXY(double c, double s2, double& x, double& y);

} // namespace patina::reference
