// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include <gtest/gtest.h>

#include "catalog/xdg_folders.h"
#include "catalog_fixture.h"

namespace patina::catalog_test {
namespace {

using tests::BlockFolder;
using tests::plainDescriptor;

TEST(Catalog, BlockInAFolder_HasItsKind) {
    BlockFolder folder;
    folder.add("lights", plainDescriptor("lamp"));
    EXPECT_NE(folder.load().find("lights", "lamp"), nullptr);
}

TEST(Catalog, BlockOfAnotherKind_IsNotFound) {
    BlockFolder folder;
    folder.add("lights", plainDescriptor("lamp"));
    EXPECT_EQ(folder.load().find("models", "lamp"), nullptr);
}

TEST(Catalog, FormerId_GivesWayToABlockThatHasItNow) {
    BlockFolder folder;
    auto renamed = plainDescriptor("mist");
    renamed["formerIds"] = {"haze", "smoke"};
    folder.add("fog", renamed);
    folder.add("fog", plainDescriptor("smoke"));
    const Catalog catalog = folder.load();
    EXPECT_EQ(catalog.find("fog", "haze")->id, "mist");
    EXPECT_EQ(catalog.find("fog", "smoke")->id, "smoke");
    EXPECT_EQ(catalog.find("models", "haze"), nullptr);
}

TEST(Catalog, FormerIdThatABlockHas_IsAMistakeAtItsPlace) {
    BlockFolder folder;
    folder.add("fog", plainDescriptor("haze"));
    auto renamed = plainDescriptor("mist");
    renamed["formerIds"] = {"haze"};
    folder.add("fog", renamed);
    const Catalog catalog = folder.load();
    ASSERT_EQ(catalog.errors.size(), 1u);
    EXPECT_NE(catalog.errors[0].problem.find("\"haze\""), std::string::npos);
    EXPECT_GT(catalog.errors[0].line, 1);
    EXPECT_EQ(catalog.find("fog", "mist"), nullptr);
}

TEST(Catalog, Blocks_AreSortedByLabelWithinAKind) {
    BlockFolder folder;
    auto first = plainDescriptor("zz");
    first["label"] = "Aa";
    folder.add("models", first);
    folder.add("models", plainDescriptor("b"));
    const Catalog catalog = folder.load();
    EXPECT_EQ(catalog.ofKind("models").front()->id, "zz");
}

TEST(Catalog, BlockWithAMistake_LeavesTheOthers) {
    BlockFolder folder;
    folder.add("models", plainDescriptor("good"));
    folder.addText("models", "bad", "{");
    const Catalog catalog = folder.load();
    EXPECT_EQ(catalog.blocks.size(), 1u);
    EXPECT_EQ(catalog.errors.size(), 1u);
}

TEST(Catalog, ShaderWithoutADescriptor_IsAMistake) {
    BlockFolder folder;
    tests::writeFile(folder.root() / "models/alone.glsl", "");
    EXPECT_NE(text(folder.load().errors).find("the shader has no descriptor"), std::string::npos);
}

/// Emacs leaves a lock that leads nowhere, and many editors a copy.
TEST(Catalog, FilesThatEditorsLeave_AreNoBlocks) {
    BlockFolder folder;
    folder.add("models", plainDescriptor("good"));
    std::filesystem::create_symlink("me@here.1:2", folder.root() / "models/.#good.json");
    for (const char* name : {".good.json", "#good.json#", "good.json~", "#x.glsl", ".x.glsl"}) {
        tests::writeFile(folder.root() / "models" / name, "{");
    }
    EXPECT_EQ(text(folder.load().errors), "");
}

TEST(Catalog, SharedAndPassesFolders_HoldNoBlocks) {
    BlockFolder folder;
    tests::writeFile(folder.root() / "lib/math.glsl", "");
    tests::writeFile(folder.root() / "passes/main.glsl", "");
    EXPECT_EQ(text(folder.load().errors), "");
}

/// The messages about a user's model of this id, beside the shaders that ship.
std::string complaintsAbout(const std::string& id) {
    BlockFolder user;
    user.add("models", plainDescriptor(id));
    const std::filesystem::path shipped = std::filesystem::path(PATINA_SOURCE_DIR) / "shaders";
    return text(loadCatalog(std::vector<BlockRoot>{{shipped, true}, {user.root(), false}}).errors);
}

class TakenName : public testing::TestWithParam<const char*> {};

TEST_P(TakenName, AsAUsersId_IsAMistake) {
    const std::string id = GetParam();
    EXPECT_NE(complaintsAbout(id).find("/models/" + id + ".json:2:8: the id \"" + id + '"'),
              std::string::npos)
        << complaintsAbout(id);
}

INSTANTIATE_TEST_SUITE_P(Names, TakenName,
                         testing::Values("directions", "incidence", "illumination", "fog-ray",
                                         "layer", "surface", "light", "safe-normalize", "mix",
                                         "texture", "reflect"));

TEST(Catalog, FreeNameAsAUsersId_IsNone) {
    EXPECT_EQ(complaintsAbout("velvet"), "");
}

TEST(Catalog, UsersFolderOfNoKind_IsAMistakeThatNamesTheKinds) {
    BlockFolder shipped;
    BlockFolder users;
    shipped.add("models", plainDescriptor("a"));
    users.add("model", plainDescriptor("mine"));
    const Catalog catalog =
        loadCatalog(std::vector<BlockRoot>{{shipped.root(), true}, {users.root(), false}});
    EXPECT_NE(text(catalog.errors).find("\"model\" is no kind of block; expected 'models'"),
              std::string::npos)
        << text(catalog.errors);
}

TEST(Catalog, UsersBlock_IsNotShipped) {
    BlockFolder folder;
    folder.add("models", plainDescriptor("mine"));
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{folder.root(), false}});
    EXPECT_FALSE(catalog.find("models", "mine")->shipped);
}

TEST(Catalog, UsersBlockWithAShippedId_IsAMistakeAndTheShippedOneStays) {
    BlockFolder shipped;
    BlockFolder users;
    shipped.add("models", plainDescriptor("a"));
    users.add("models", plainDescriptor("a"));
    const Catalog catalog =
        loadCatalog(std::vector<BlockRoot>{{shipped.root(), true}, {users.root(), false}});
    EXPECT_NE(text(catalog.errors).find("the models block \"a\" is already there"),
              std::string::npos);
    EXPECT_TRUE(catalog.find("models", "a")->shipped);
}

TEST(Catalog, BlocksThatMakeOneStruct_AreAMistake) {
    BlockFolder folder;
    folder.add("fog", plainDescriptor("thin"));
    folder.add("models", plainDescriptor("thin-fog"));
    EXPECT_EQ(folder.load().errors.size(), 1u);
}

TEST(Catalog, MissingShippedFolder_IsAnError) {
    const tests::TemporaryFolder folder;
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{folder / "none", true}});
    EXPECT_NE(text(catalog.errors).find((folder / "none").string()), std::string::npos);
}

TEST(Catalog, ShippedFolderThatIsAFile_IsAnError) {
    const tests::TemporaryFolder folder;
    tests::writeFile(folder / "file", "");
    EXPECT_EQ(loadCatalog(std::vector<BlockRoot>{{folder / "file", true}}).errors.size(), 1u);
}

TEST(Catalog, UsersFolderThatCannotBeRead_IsAnErrorThatNamesIt) {
    tests::TemporaryFolder folder;
    tests::writeFile(folder / "file", "");
    const Catalog catalog = loadCatalog(std::vector<BlockRoot>{{folder / "file", false}});
    ASSERT_EQ(catalog.errors.size(), 1u);
    EXPECT_EQ(catalog.errors[0].file, (folder / "file").string());
}

TEST(Catalog, MissingUserFolder_IsNoError) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(text(loadCatalog(std::vector<BlockRoot>{{folder / "none", false}}).errors), "");
}

TEST(Catalog, NameOfABlock_ComesFromIdAndKind) {
    Block block;
    block.id = "thin-film-2";
    block.kind = "models";
    EXPECT_EQ(structName(block), "ThinFilm2");
    block.kind = "lights";
    EXPECT_EQ(structName(block), "ThinFilm2Light");
    EXPECT_EQ(functionName(block), "thinFilm2Light");
}

/// Sets an environment variable for one test.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        const char* before = std::getenv(name);
        before_ = before == nullptr ? "" : before;
        setenv(name, value.c_str(), 1);
    }
    ~Variable() { before_.empty() ? unsetenv(name_) : setenv(name_, before_.c_str(), 1); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    const char* name_;
    std::string before_;
};

TEST(DataFolder, Variable_Wins) {
    const Variable variable("PATINA_DATA_DIR", "/somewhere");
    EXPECT_EQ(dataFolder(), "/somewhere");
}

TEST(DataFolder, BuildTree_UsesTheSources) {
    const Variable variable("PATINA_DATA_DIR", "");
    EXPECT_EQ(dataFolder(), PATINA_SOURCE_DIR);
}

TEST(StandardBlockRoots, UsersFolder_FollowsTheXdgVariable) {
    const Variable variable("XDG_DATA_HOME", "/data");
    EXPECT_EQ(standardBlockRoots().back(), (BlockRoot{"/data/patina/shaders", false}));
}

TEST(StandardBlockRoots, RelativeXdgVariable_IsIgnored) {
    const Variable xdg("XDG_DATA_HOME", "data");
    const Variable home("HOME", "/home/me");
    EXPECT_EQ(standardBlockRoots().back().folder, "/home/me/.local/share/patina/shaders");
}

TEST(XdgCacheFolder, WithoutVariables_IsBelowHome) {
    const Variable xdg("XDG_CACHE_HOME", "");
    const Variable home("HOME", "/home/me");
    EXPECT_EQ(xdgCacheFolder(), "/home/me/.cache/patina");
}

TEST(XdgCacheFolder, WithoutAHome_IsNone) {
    const Variable xdg("XDG_CACHE_HOME", "");
    const Variable home("HOME", "");
    EXPECT_EQ(xdgCacheFolder(), std::nullopt);
}

TEST(XdgCacheFolder, RelativePaths_AreIgnored) {
    const Variable xdg("XDG_CACHE_HOME", "cache");
    const Variable home("HOME", "me");
    EXPECT_EQ(xdgCacheFolder(), std::nullopt);
}

TEST(Catalog, MissingSchema_IsAnErrorThatNamesIt) {
    const tests::TemporaryFolder empty;
    BlockFolder folder;
    const Variable variable("PATINA_DATA_DIR", empty.path());
    EXPECT_NE(text(folder.load().errors).find("descriptor.schema.json"), std::string::npos);
}

} // namespace
} // namespace patina::catalog_test
