// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace patina::benchmarks {

/// Each prints its rows and returns whether all targets were kept.
bool startup();
bool idle();
bool sliderTick();
bool dragging();
bool overlaidLobes();
bool modelSwap();
bool largeMesh();
bool meshLoading();
bool presetLibrary();
bool programMaking();
bool modelCost();
bool accuracyCost();
bool styleCost();
bool predictedCost();
bool removedEffects();
bool foundFronts();
bool sweepTime();
bool frontTwice();
bool fittedLight();
bool coherence();
bool contactSheet();
bool manyObjects();
bool views();
bool assembly();
bool switches();
bool everythingOn();
bool offEffects();

/// Counts with the driver's cache off and its log on, which stay so: nothing can be measured after
/// it.
bool assemblyCount();

} // namespace patina::benchmarks
