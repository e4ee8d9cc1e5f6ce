// SPDX-License-Identifier: MIT-0
// Beside the sum: what the surface keeps of the light from behind it.

layout(location = 1) out float storedShare;
