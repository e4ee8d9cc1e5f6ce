# SPDX-License-Identifier: GPL-3.0-or-later
# awk -f type_list.awk CONTRIBUTING.md parameter_type.h: the list of types with the guide's.
NR == FNR && /^```/ { inside = $0 == "```cpp PATINA_PARAMETER_TYPES"; next }
NR == FNR { names = inside ? $0 : names; next }
{ sub(/type\(Ramp\)/, names); print }
