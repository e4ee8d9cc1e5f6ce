// SPDX-License-Identifier: GPL-3.0-or-later
// What a descriptor may say of the tables that its levels read.
#include <gtest/gtest.h>

#include "catalog/table_source.h"
#include "catalog_fixture.h"

namespace patina::table_checks_test {
namespace {

using nlohmann::json;
using tests::BlockFolder;
using tests::plainDescriptor;

/// A model with one table, which its second level reads.
json withTable() {
    json descriptor = plainDescriptor("a");
    const std::string input = descriptor["parameters"][0]["id"];
    descriptor["accuracy"] = {{{"id", "way"},
                               {"label", "Way"},
                               {"values",
                                {{{"id", "one"}, {"label", "1"}, {"exact", true}},
                                 {{"id", "two"}, {"label", "2"}, {"table", "terms"}}}}}};
    descriptor["tables"] = {{{"id", "terms"}, {"size", {8, 4}}, {"of", {input}}}};
    return descriptor;
}

class TableChecks : public testing::Test {
  protected:
    std::string of(const json& descriptor, const std::string& kind = "models") {
        folder_.add(kind, descriptor);
        return text(folder_.load().errors);
    }

    void expectMistake(const json& descriptor, const std::string& problem) {
        const std::string found = of(descriptor);
        EXPECT_NE(found.find(problem), std::string::npos) << found;
    }

    BlockFolder folder_;
};

TEST_F(TableChecks, TableOfALevel_IsRead) {
    folder_.add("models", withTable());
    const Catalog catalog = folder_.load();
    ASSERT_TRUE(catalog.errors.empty()) << text(catalog.errors);
    const Block* block = catalog.find("models", "a");
    ASSERT_NE(block->table("terms"), nullptr);
    EXPECT_EQ(block->table("terms")->size, glm::ivec2(8, 4));
    EXPECT_EQ(block->accuracy[0].values[1].table, "terms");
    EXPECT_EQ(entryFunction(*block, block->tables[0]), "aTermsEntry");
}

TEST_F(TableChecks, SizeOfOneAxis_HasOneRow) {
    json descriptor = withTable();
    descriptor["tables"][0]["size"] = {16};
    folder_.add("models", descriptor);
    EXPECT_EQ(folder_.load().find("models", "a")->tables[0].size, glm::ivec2(16, 1));
}

TEST_F(TableChecks, TableThatIsNotThere_IsAMistake) {
    json descriptor = withTable();
    descriptor["accuracy"][0]["values"][1]["table"] = "term";
    expectMistake(descriptor, "there is no table \"term\"");
}

TEST_F(TableChecks, TableThatNoLevelReads_IsAMistake) {
    json descriptor = withTable();
    descriptor["accuracy"][0]["values"][1].erase("table");
    expectMistake(descriptor, "no level reads this table");
}

TEST_F(TableChecks, TableOfTheExactLevel_IsAMistake) {
    json descriptor = withTable();
    descriptor["accuracy"][0]["values"][0]["table"] = "terms";
    expectMistake(descriptor, "the exact level reads no table");
}

TEST_F(TableChecks, UnknownParameter_IsAMistake) {
    json descriptor = withTable();
    descriptor["tables"][0]["of"] = {"nothing"};
    expectMistake(descriptor, "'nothing' is no parameter of this block");
}

TEST_F(TableChecks, OneEntry_IsAMistake) {
    json descriptor = withTable();
    descriptor["tables"][0]["size"] = {1};
    expectMistake(descriptor, "a whole number from 2 to 1024");
}

TEST_F(TableChecks, TwoTablesOfOneName_AreAMistake) {
    json descriptor = withTable();
    descriptor["tables"].push_back(descriptor["tables"][0]);
    expectMistake(descriptor, "there are two functions aTerms");
}

TEST_F(TableChecks, OtherKind_HasNoTables) {
    EXPECT_NE(of(withTable(), "fog").find("a block of the kind fog has no tables"),
              std::string::npos);
}

} // namespace
} // namespace patina::table_checks_test
