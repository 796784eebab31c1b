// SPDX-License-Identifier: MIT
#pragma once

// Dictionaries and lists of the schema, as encoded values.

#include "CoreMinimal.h"

#include "SpearText.h"

#include "spear/codec.hpp"
#include "spear/encode.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace SpearServer {

/// A list whose elements are encoded already.
class FSchemaList {
public:
    spear::Encoder& Add() {
        ++Count;
        return Elements;
    }
    void AddText(std::string_view Text) { spear::Codec<std::string>::encode(Add(), Text); }
    void WriteTo(spear::Encoder& Out) const {
        Out.put(spear::types::list);
        Out.put(Count);
        Out.put_raw(Elements.buffer.data(), Elements.buffer.size());
    }

private:
    spear::Encoder Elements;
    uint32 Count = 0;
};

/// A dictionary; its keys are written in bytewise order, as the schema asks.
class FSchemaDict {
public:
    /// Where the value of a key is written; each key once.
    spear::Encoder& Set(const char* Key) { return Values[Key]; }
    void SetText(const char* Key, std::string_view Text) { spear::Codec<std::string>::encode(Set(Key), Text); }
    void SetText(const char* Key, const char* Text) { SetText(Key, std::string_view(Text)); }
    void SetText(const char* Key, const FString& Text) { SetText(Key, ToUtf8(Text)); }
    void SetNumber(const char* Key, int64 Number) { spear::Codec<int64_t>::encode(Set(Key), Number); }
    void SetTrue(const char* Key) { spear::Codec<bool>::encode(Set(Key), true); }
    void SetNull(const char* Key) { Set(Key).put(spear::types::null); }
    void SetList(const char* Key, const FSchemaList& List) { List.WriteTo(Set(Key)); }
    void SetDict(const char* Key, const FSchemaDict& Dict) { Dict.WriteTo(Set(Key)); }
    void WriteTo(spear::Encoder& Out) const {
        Out.put(spear::types::dict);
        Out.put(static_cast<uint32>(Values.size()));
        for (const auto& [Key, Value] : Values) {
            Out.put_text(Key);
            Out.put_raw(Value.buffer.data(), Value.buffer.size());
        }
    }

private:
    std::map<std::string, spear::Encoder, std::less<>> Values;
};

/// Entities under the names by which the schema sorts them.
class FSchemaEntities {
public:
    spear::Encoder& Add(std::string Name, std::string Second = {}) {
        return Entities[{std::move(Name), std::move(Second)}];
    }
    void WriteTo(spear::Encoder& Out) const {
        Out.put(spear::types::list);
        Out.put(static_cast<uint32>(Entities.size()));
        for (const auto& [Name, Entity] : Entities) {
            Out.put_raw(Entity.buffer.data(), Entity.buffer.size());
        }
    }

private:
    std::map<std::pair<std::string, std::string>, spear::Encoder> Entities;
};

} // namespace SpearServer
