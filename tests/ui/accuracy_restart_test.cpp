// SPDX-License-Identifier: GPL-3.0-or-later
// Charts that are there again after the editor was started anew.
#include "accuracy/chart_store.h"
#include "scene/scene_file.h"
#include "ui/accuracy_fixture.h"

namespace patina::tests::accuracy_restart_test {
namespace {

class RestartedAccuracy : public AccuracyPanel {
  protected:
    /// Measures a saved scene.
    void measureSaved() {
        ASSERT_TRUE(window().documentFiles().saveScene(scene()));
        ASSERT_TRUE(measure()) << state().toStdString();
    }

    std::filesystem::path scene() const { return home("kept.patina-scene.json"); }

    /// Another window, and in it the scene.
    void startAgain() {
        close();
        open();
        ASSERT_TRUE(window().documentFiles().openScene(scene()));
        window().dock("accuracy")->show();
        settle();
    }

    std::vector<std::filesystem::path> files(const std::string& ending) const {
        std::vector<std::filesystem::path> found;
        for (const auto& each : std::filesystem::directory_iterator(folder())) {
            if (each.path().string().ends_with(ending)) {
                found.push_back(each.path());
            }
        }
        return found;
    }

    std::filesystem::path folder() const { return home("XDG_STATE_HOME") / "patina/measurements"; }
};

TEST_F(RestartedAccuracy, SameScene_HasItsChartAgain) {
    measureSaved();
    const CostChart measured = dock().chart();
    startAgain();
    ASSERT_NE(dock().shown(), nullptr);
    EXPECT_FALSE(dock().isStale()) << state().toStdString();
    EXPECT_TRUE(dock().shown()->complete);
    EXPECT_EQ(list().topLevelItemCount(), 3);
    EXPECT_EQ(dock().chart().choices, measured.choices);
    EXPECT_FALSE(state().startsWith("Measured from another view")) << state().toStdString();
    list().select(pointOf("near"));
    QTest::keyClick(&list(), Qt::Key_Return);
    EXPECT_EQ(level(), "near");
}

TEST_F(RestartedAccuracy, ChartOfAnUnsavedScene_GoesWithTheFileItIsSavedTo) {
    ASSERT_TRUE(measure()) << state().toStdString();
    ASSERT_TRUE(window().documentFiles().saveScene(scene()));
    settle();
    startAgain();
    ASSERT_NE(dock().shown(), nullptr);
    EXPECT_FALSE(dock().isStale());
}

TEST_F(RestartedAccuracy, ChangedScene_HasItOutOfDate) {
    measureSaved();
    Scene changed = document().scene();
    changed.objects.front().material.opacity = 0.5;
    ASSERT_TRUE(writeScene(scene(), changed));
    startAgain();
    ASSERT_NE(dock().shown(), nullptr);
    EXPECT_TRUE(dock().isStale());
    EXPECT_TRUE(state().startsWith("Out of date")) << state().toStdString();
    document().setValue(document().selection().currentPath(settings::material), "opacity", 1.0);
    settle();
    EXPECT_FALSE(dock().isStale()) << state().toStdString();
}

TEST_F(RestartedAccuracy, ChangedBlock_HasItOutOfDate) {
    measureSaved();
    const std::filesystem::path models = home("XDG_DATA_HOME") / "patina/shaders/models";
    writeFile(models / "burning.glsl", std::string(burningShader) + "// another\n");
    startAgain();
    ASSERT_NE(dock().shown(), nullptr);
    EXPECT_TRUE(dock().isStale());
}

TEST(ChartStore, AnotherDevice_IsAnotherHash) {
    MeasuredSubject subject;
    subject.object = 0;
    EXPECT_EQ(hashOf(subject, "llvmpipe"), hashOf(subject, "llvmpipe"));
    EXPECT_NE(hashOf(subject, "llvmpipe"), hashOf(subject, "another"));
}

TEST_F(RestartedAccuracy, DamagedFile_IsToldAndPutAside) {
    measureSaved();
    ASSERT_EQ(files(".json").size(), 1u);
    const std::string half = readFile(files(".json").front()).substr(0, 1000);
    writeFile(files(".json").front(), half);
    startAgain();
    EXPECT_EQ(dock().shown(), nullptr);
    ASSERT_EQ(files(".damaged").size(), 1u);
    EXPECT_EQ(readFile(files(".damaged").front()), half);
    ASSERT_GT(window().messages().count(), 0);
    const std::string told = window().messages().messages().back().text();
    EXPECT_NE(told.find("put aside"), std::string::npos) << told;
    ASSERT_TRUE(measure()) << state().toStdString(); // and is written anew
    startAgain();
    EXPECT_FALSE(dock().isStale());
    EXPECT_NE(dock().shown(), nullptr);
}

TEST_F(RestartedAccuracy, FolderThatMayNotBeWritten_IsToldAndLosesNothing) {
    std::filesystem::create_directories(folder().parent_path());
    writeFile(folder(), "a file in the way");
    ASSERT_TRUE(measure()) << state().toStdString();
    EXPECT_NE(dock().shown(), nullptr);
    ASSERT_GT(window().messages().count(), 0);
    EXPECT_NE(window().messages().messages().back().text().find("measurements"), std::string::npos);
}

} // namespace
} // namespace patina::tests::accuracy_restart_test
