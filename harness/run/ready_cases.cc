#include "run/ready_cases.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "base/check.h"
#include "base/progress.h"
#include "run/read_catalogue.h"

namespace etalon {
namespace {

Result<ReadyCase> MakeOneReady(const RunChoice& choice, const std::string& path,
                               const std::vector<CatalogueEntry>& catalogue) {
    const auto begin = std::chrono::steady_clock::now();
    ETALON_TRY(source, ReadCase(choice.root, path));
    if (choice.depth == Depth::kFull) {
        TakeFullCounts(source);
    }
    ETALON_TRY(prepared, choice.at.empty() ? Prepare(source) : PrepareAt(source, choice.at));
    CaseNote note;
    note.path = path;
    if (choice.catalogue) {
        ETALON_TRY_STEP(CheckCovers(source, catalogue));
        note = NoteOf(source);
    }
    note.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return ReadyCase{std::move(prepared), std::move(note)};
}

}  // namespace

Result<std::vector<ReadyCase>> MakeReady(const RunChoice& choice,
                                         const std::vector<std::string>& paths,
                                         const std::vector<CatalogueEntry>& catalogue) {
    std::vector<std::optional<Result<ReadyCase>>> made(paths.size());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    Progress progress(static_cast<std::int64_t>(paths.size()));
    // Paths are taken in their order, so that all before a failed one have been tried.
    const auto work = [&] {
        while (!failed) {
            const std::size_t i = next++;
            if (i >= paths.size()) {
                return;
            }
            made[i] = MakeOneReady(choice, paths[i], catalogue);
            if (!*made[i]) {
                failed = true;
            }
            progress.Step("made ready: " + paths[i]);
        }
    };
    std::vector<std::thread> threads;
    const std::size_t wanted = std::min<std::size_t>(std::max(1u, choice.jobs), paths.size());
    for (std::size_t i = 1; i < wanted; ++i) {
        threads.emplace_back(work);
    }
    work();
    for (std::thread& thread : threads) {
        thread.join();
    }
    progress.Clear();
    std::vector<ReadyCase> ready;
    for (std::optional<Result<ReadyCase>>& one : made) {
        ETALON_CHECK(one.has_value());
        if (!*one) {
            return one->error();
        }
        ready.push_back(std::move(**one));
    }
    return ready;
}

}  // namespace etalon
