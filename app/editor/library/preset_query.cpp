// SPDX-License-Identifier: GPL-3.0-or-later
#include "library/preset_query.h"

#include <algorithm>

#include <QHash>

#include "library/preset_marks.h"

namespace patina {
namespace {

/// Finds "red" in "Dark red" and "reddish", but not in "scattered".
bool beginsAWord(const QString& text, const QString& searched) {
    for (qsizetype at = text.indexOf(searched); at >= 0; at = text.indexOf(searched, at + 1)) {
        if (at == 0 || !text[at - 1].isLetterOrNumber() || !searched[0].isLetterOrNumber()) {
            return true;
        }
    }
    return false;
}

bool haveAll(const PresetEntry& entry, const QStringList& words) {
    return std::ranges::all_of(
        words, [&entry](const QString& word) { return beginsAWord(entry.searched, word); });
}

QStringList wordsOf(const QString& search) {
    return search.toCaseFolded().split(' ', Qt::SkipEmptyParts);
}

bool isInFolder(const PresetEntry& entry, const std::string& folder) {
    const std::string file = entry.file.string();
    return folder.empty() || (file.starts_with(folder) && file[folder.size()] == '/');
}

/// Holds a filter in the forms that entries are compared with.
class Wanted {
  public:
    Wanted(const PresetFilter& filter, const PresetMarks& marks)
        : filter_(filter), marks_(marks), words_(wordsOf(filter.search)),
          model_(filter.model.toStdString()), tag_(filter.tag.toStdString()),
          folder_(filter.folder.toStdString()) {
        for (const QString& file : marks.recent()) {
            places_.insert(file, places_.size());
        }
    }

    bool has(const PresetEntry& entry) const {
        const std::vector<std::string>& tags = entry.material.tags;
        return (model_.empty() || entry.material.model.id == model_) &&
               (tag_.empty() || std::ranges::find(tags, tag_) != tags.end()) &&
               isInFolder(entry, folder_) &&
               (!filter_.favourites || marks_.isFavourite(entry.path)) &&
               (!filter_.recent || places_.contains(entry.path)) && haveAll(entry, words_);
    }

    qsizetype place(const PresetEntry& entry) const { return places_.value(entry.path); }

    /// Tells whether all words that are searched stand in its name.
    bool isNamed(const PresetEntry& entry) const {
        return std::ranges::all_of(words_, [name = entry.name.toCaseFolded()](const QString& word) {
            return beginsAWord(name, word);
        });
    }

  private:
    const PresetFilter& filter_;
    const PresetMarks& marks_;
    QStringList words_;
    std::string model_;
    std::string tag_;
    std::string folder_;
    QHash<QString, qsizetype> places_; ///< holds the ranks of those used lately, by file
};

std::int64_t dateOf(const PresetEntry& entry) {
    return entry.sources.empty() ? 0 : entry.sources.front().written;
}

} // namespace

bool matches(const PresetEntry& entry, const QString& search) {
    return haveAll(entry, wordsOf(search));
}

std::vector<PresetPtr> chosen(const std::vector<PresetPtr>& entries, const PresetFilter& filter,
                              PresetOrder order, const PresetMarks& marks) {
    const Wanted wanted(filter, marks);
    std::vector<PresetPtr> found;
    std::ranges::copy_if(entries, std::back_inserter(found),
                         [&wanted](const PresetPtr& entry) { return wanted.has(*entry); });
    if (filter.recent) {
        std::ranges::stable_sort(
            found, {}, [&wanted](const PresetPtr& entry) { return wanted.place(*entry); });
    } else if (order == PresetOrder::Date) {
        std::ranges::stable_sort(found, std::ranges::greater(),
                                 [](const PresetPtr& entry) { return dateOf(*entry); });
    } else if (order == PresetOrder::Model) {
        std::ranges::stable_sort(
            found, {}, [](const PresetPtr& entry) -> const QString& { return entry->modelLabel; });
    } else if (!filter.search.isEmpty()) {
        std::ranges::stable_partition(
            found, [&wanted](const PresetPtr& entry) { return wanted.isNamed(*entry); });
    }
    return found;
}

} // namespace patina
