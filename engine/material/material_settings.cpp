// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material_settings.h"

#include "material/member_access.h"

namespace patina {
namespace {

const MemberTable<Material>& materialMembers() {
    static const MemberTable<Material> members{{"opacity", member(&Material::opacity)}};
    return members;
}

} // namespace

std::optional<Value> settingOf(const Material& material, std::string_view id) {
    return readMember(materialMembers(), material, id);
}

void storeSetting(Material& material, std::string_view id, const Value& value) {
    writeMember(materialMembers(), material, id, value);
}

} // namespace patina
