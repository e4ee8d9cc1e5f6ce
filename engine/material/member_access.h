// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/value.h"

namespace patina {

/// Says how one member of `Owner` is read and written as the value of a setting.
template <class Owner>
struct MemberAccess {
    std::function<Value(const Owner&)> read;
    std::function<void(Owner&, const Value&)> write;
};

/// Maps the ids of settings to the members that hold them.
template <class Owner>
using MemberTable = std::map<std::string, MemberAccess<Owner>, std::less<>>;

/// Reaches a member whose type is one of the alternatives of Value. A value of another type is not
/// written.
template <class Owner, class Member>
MemberAccess<Owner> member(Member Owner::*field) {
    return {[field](const Owner& owner) { return Value(owner.*field); },
            [field](Owner& owner, const Value& value) {
                if (const Member* held = std::get_if<Member>(&value)) {
                    owner.*field = *held;
                }
            }};
}

/// Reaches a member of a member in the same manner.
template <class Owner, class Inner, class Member>
MemberAccess<Owner> member(Inner Owner::*inner, Member Inner::*field) {
    return {[=](const Owner& owner) { return Value(owner.*inner.*field); },
            [=](Owner& owner, const Value& value) {
                if (const Member* held = std::get_if<Member>(&value)) {
                    owner.*inner.*field = *held;
                }
            }};
}

template <class Owner>
std::optional<Value> readMember(const MemberTable<Owner>& table, const Owner& owner,
                                std::string_view id) {
    const auto found = table.find(id);
    return found == table.end() ? std::nullopt : std::optional<Value>(found->second.read(owner));
}

template <class Owner>
void writeMember(const MemberTable<Owner>& table, Owner& owner, std::string_view id,
                 const Value& value) {
    if (const auto found = table.find(id); found != table.end()) {
        found->second.write(owner, value);
    }
}

} // namespace patina
