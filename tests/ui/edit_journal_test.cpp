// SPDX-License-Identifier: GPL-3.0-or-later
// The copy of unsaved work and the edits beside it.
#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "files/edit_journal.h"
#include "scene/scene_file.h"
#include "support/program.h"

namespace patina::tests::edit_journal_test {
namespace {

class EditJournalTest : public testing::Test {
  protected:
    /// Writes the scene with these exposures, one after the other.
    void writeExposures(std::initializer_list<double> exposures) {
        EditJournal journal(copy_);
        Scene scene;
        for (const double exposure : exposures) {
            scene.exposure = exposure;
            ASSERT_TRUE(journal.write(scene));
        }
    }

    /// What a start after a kill finds.
    double recovered() {
        EXPECT_TRUE(EditJournal::join(copy_));
        return writtenExposure();
    }

    double writtenExposure() const {
        const auto reading = readScene(copy_, Catalog());
        EXPECT_TRUE(reading);
        return reading ? reading->scene.exposure : -1.0;
    }

    std::string journalText() const { return readFile(EditJournal::beside(copy_)); }
    void setJournal(const std::string& text) { writeFile(EditJournal::beside(copy_), text); }

    TemporaryFolder folder_;
    std::filesystem::path copy_ = folder_ / "a.patina-scene.json";
};

TEST_F(EditJournalTest, Edits_AreAppendedToACopyThatStays) {
    writeExposures({1.0, 2.0, 3.0});
    EXPECT_EQ(writtenExposure(), 1.0);
    EXPECT_EQ(recovered(), 3.0);
}

TEST_F(EditJournalTest, Joined_LeavesNoJournal) {
    writeExposures({1.0, 2.0});
    EXPECT_EQ(recovered(), 2.0);
    EXPECT_FALSE(std::filesystem::exists(EditJournal::beside(copy_)));
    EXPECT_EQ(recovered(), 2.0);
}

TEST_F(EditJournalTest, SceneThatDidNotChange_AddsNothing) {
    writeExposures({1.0, 2.0});
    const std::string before = journalText();
    writeExposures({1.0, 2.0, 2.0});
    EXPECT_EQ(journalText(), before);
}

TEST_F(EditJournalTest, LineThatWasCutOff_LosesThatEditAlone) {
    writeExposures({1.0, 2.0, 3.0});
    setJournal(journalText().substr(0, journalText().size() - 5));
    EXPECT_EQ(recovered(), 2.0);
}

TEST_F(EditJournalTest, DamagedLine_EndsTheReading) {
    writeExposures({1.0, 2.0});
    setJournal(journalText() + "[{\"op\":\"remove\",\"path\":\"/no/such\"}]\nnonsense\n");
    EXPECT_EQ(recovered(), 2.0);
}

TEST_F(EditJournalTest, JournalOfAnotherCopy_IsNotRead) {
    writeExposures({1.0, 2.0});
    const std::string other = journalText();
    writeExposures({5.0});
    setJournal(other);
    EXPECT_EQ(recovered(), 5.0);
}

TEST_F(EditJournalTest, LongJournal_BecomesACopy) {
    EditJournal journal(copy_);
    Scene scene;
    std::uintmax_t longest = 0;
    for (int i = 0; i < 40; ++i) {
        scene.name = std::string(100000, char('a' + i % 26));
        ASSERT_TRUE(journal.write(scene));
        longest = std::max(longest, std::filesystem::file_size(EditJournal::beside(copy_)));
    }
    EXPECT_LT(longest, 1u << 21);
    ASSERT_TRUE(EditJournal::join(copy_));
    EXPECT_EQ(readScene(copy_, Catalog())->scene.name, scene.name);
}

TEST_F(EditJournalTest, FolderThatIsGone_IsAnErrorAndTheNextWriteBeginsAnew) {
    EditJournal journal(copy_);
    Scene scene;
    ASSERT_TRUE(journal.write(scene));
    std::filesystem::remove(EditJournal::beside(copy_));
    std::filesystem::create_directory(EditJournal::beside(copy_)); // so that it cannot be written
    scene.exposure = 2.0;
    const Result<void> written = journal.write(scene);
    ASSERT_FALSE(written);
    EXPECT_NE(written.error().text().find(".journal"), std::string::npos);
    std::filesystem::remove(EditJournal::beside(copy_));
    ASSERT_TRUE(journal.write(scene));
    EXPECT_EQ(recovered(), 2.0);
}

} // namespace
} // namespace patina::tests::edit_journal_test
