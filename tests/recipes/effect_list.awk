# SPDX-License-Identifier: GPL-3.0-or-later
# awk -f effect_list.awk CONTRIBUTING.md effect_set.h: the list of effects with the guide's row.
NR == FNR && /^```/ { inside = $0 == "```cpp AllEffects"; next }
NR == FNR && inside && /^#include/ { header = $0; next }
NR == FNR { row = inside ? $0 : row; next }
header != "" && /^namespace/ { print header "\n" }
{ sub(/FogEffect,/, row); print }
