// SPDX-License-Identifier: MIT
// What earlier runs found out about headers, on disk: one file per header content, so that a run reads again only what
// changed. The cache is never needed: whatever is wrong with it (damaged, unreadable, full), the run goes on without.
#pragma once

#include "ast.h"
#include "emit.h"
#include "facts.h"
#include "hash.h"
#include "report.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace spear::header_tool {

// All that a run needs of a header that did not change.
struct CacheEntry {
    HeaderFacts facts;
    std::vector<ReportEntry> scan_report; // found while reading its text
    // The rest depends on other headers too: it holds as long as these questions have these answers.
    bool has_result = false;
    std::vector<std::pair<std::string, Hash>> questions;
    AstStatistics statistics;
    std::vector<ReportEntry> check_report;
    std::vector<Fragment> fragments;
};

class Cache {
public:
    // An empty folder name switches it off. `size_limit` in bytes.
    Cache(std::string folder, std::uint64_t size_limit);

    bool enabled() const { return !folder_.empty(); }
    // nullopt: unknown or damaged (then the file is removed).
    std::optional<CacheEntry> load(const Hash& key);
    void store(const Hash& key, const CacheEntry& entry);
    // Removes what was used least recently until the size is inside its bound; only after something was stored.
    void evict();

    // Why nothing could be stored; "" if all is well.
    std::string trouble() const;

private:
    std::string file_of(const Hash& key) const;
    void note_trouble(std::string text);

    std::string folder_;
    std::uint64_t size_limit_;
    std::atomic<std::size_t> stored_{0};
    mutable std::mutex mutex_;
    std::string trouble_;
};

// $XDG_CACHE_HOME/spear/headers, else ~/.cache/spear/headers, else "".
std::string default_cache_folder();

// Of this program's own bytes: another build of the tool never believes an older one's results. nullopt when it cannot
// be told.
std::optional<Hash> tool_fingerprint();

// For tests of the format, and for Cache: bytes of an entry, and back (nullopt if they are none).
std::string to_bytes(const CacheEntry& entry);
std::optional<CacheEntry> from_bytes(std::string_view bytes);

} // namespace spear::header_tool
