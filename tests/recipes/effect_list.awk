# SPDX-License-Identifier: GPL-3.0-or-later
# awk -f effect_list.awk CONTRIBUTING.md effect_set.h: the list of effects with the rows of the guide,
# each in place of the effect that it begins with.
NR == FNR && /^```/ { inside = $0 == "```cpp AllEffects"; next }
NR == FNR && inside && /^#include/ { headers = headers $0 "\n"; next }
NR == FNR && inside { rows[$1] = $0 }
NR == FNR { next }
headers != "" && /^namespace/ { print headers }
{ for (before in rows) sub(before, rows[before]); print }
