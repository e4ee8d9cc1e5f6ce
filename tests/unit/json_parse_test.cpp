// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/json_text.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "support/program.h"

namespace patina::json_parse_test {
namespace {

/// "line:column" of the value at a pointer.
std::string placeOf(const std::string& json, const std::string& pointer) {
    const auto document = parseJson(json, "f.json");
    if (!document) {
        return document.error().text();
    }
    const Error error = document->error(pointer, "x");
    return std::to_string(error.line) + ":" + std::to_string(error.column);
}

std::string errorOf(std::string_view json, const JsonLimits& limits = {}) {
    const auto document = parseJson(json, "f.json", limits);
    return document ? "" : document.error().text();
}

std::string start(const std::string& text) {
    return text.substr(0, text.find(": "));
}

TEST(ParseJson, Value_IsPlacedWhereItStarts) {
    EXPECT_EQ(placeOf("{\n  \"a\": 1,\n  \"b\": [true, \"x\"]\n}", "/b/1"), "3:15");
}

TEST(ParseJson, NumberBeforeABracket_DoesNotShiftTheNextValue) {
    EXPECT_EQ(placeOf("[[1],[22]  ,\n 3]", "/2"), "2:2");
}

TEST(ParseJson, NumberBeforeANewline_DoesNotShiftTheNextLine) {
    EXPECT_EQ(placeOf("{\"a\": 1\n,\"b\": 2\n, \"c\" :\n null}", "/c"), "4:2");
}

TEST(ParseJson, WholeDocument_IsPlacedAfterBlanks) {
    EXPECT_EQ(placeOf("\n\n  {}", ""), "3:3");
}

TEST(ParseJson, ByteOrderMark_IsSkipped) {
    EXPECT_EQ(placeOf("\xEF\xBB\xBF{\"a\": 1}", "/a"), "1:7");
}

TEST(ParseJson, KeyWithASlash_IsEscapedInThePointer) {
    EXPECT_EQ(placeOf("{\"a/b~c\": 1}", "/a~1b~0c"), "1:11");
}

TEST(ParseJson, UnknownPointer_IsPlacedAtTheNearestParent) {
    EXPECT_EQ(placeOf("{\n \"a\": {}}", "/a/missing/deeper"), "2:7");
}

TEST(ParseJson, ElementFarIntoAnArray_IsPlacedAtTheArray) {
    std::string json = "[\n[0";
    for (int i = 0; i < 5000; ++i) {
        json += ",\n0";
    }
    EXPECT_EQ(placeOf(json + "]]", "/0/4999"), "2:1");
}

TEST(ParseJson, RepeatedKey_IsAnErrorAtTheSecond) {
    EXPECT_EQ(errorOf("{\"a\": 1,\n \"a\": 2}"),
              "f.json:2:2: the key \"a\" occurs twice; expected each key once in an object");
}

TEST(ParseJson, SameKeyInAnotherObject_IsFine) {
    EXPECT_EQ(errorOf("{\"a\": {\"a\": 1}, \"b\": {\"a\": 2}}"), "");
}

TEST(ParseJson, NotANumber_IsAnErrorAtItsPlace) {
    EXPECT_EQ(errorOf("{\"a\": NaN}"),
              "f.json:1:7: 'NaN' is not a JSON value; expected an object, an array, a number, "
              "text, true, false or null");
}

TEST(ParseJson, Infinity_IsRefused) {
    EXPECT_EQ(start(errorOf("[1, -Infinity]")), "f.json:1:5");
}

TEST(ParseJson, NumberBeyondDouble_IsAnErrorAtItsPlace) {
    EXPECT_EQ(errorOf("[0,\n  1e999]"),
              "f.json:2:3: the number 1e999 is not finite; expected a finite number");
}

TEST(ParseJson, NegativeNumberBeyondDouble_IsRefused) {
    EXPECT_EQ(start(errorOf("[-1e999]")), "f.json:1:2");
}

TEST(ParseJson, NumberBelowTheSmallestDouble_IsZero) {
    EXPECT_EQ(parseJson("1e-999", "f").value().value.get<double>(), 0.0);
}

TEST(ParseJson, Empty_IsAnErrorAtTheStart) {
    EXPECT_EQ(start(errorOf("")), "f.json:1:1");
}

TEST(ParseJson, Truncated_IsAnErrorAtTheEnd) {
    EXPECT_EQ(start(errorOf("{\"a\": [1, 2")), "f.json:1:12");
}

TEST(ParseJson, TruncatedInText_IsAnError) {
    EXPECT_EQ(start(errorOf("{\"a\": \"b")), "f.json:1:9");
}

TEST(ParseJson, SomethingAfterTheEnd_IsAnErrorThere) {
    EXPECT_EQ(start(errorOf("{}\n{}")), "f.json:2:1");
}

TEST(ParseJson, TrailingComma_IsAnError) {
    EXPECT_EQ(start(errorOf("[1,]")), "f.json:1:4");
}

TEST(ParseJson, Comment_IsAnError) {
    EXPECT_EQ(start(errorOf("{ // no\n}")), "f.json:1:3");
}

TEST(ParseJson, IllFormedUtf8_IsAnError) {
    EXPECT_EQ(start(errorOf("{\"a\": \"\xFF\"}")), "f.json:1:8");
}

TEST(ParseJson, OverlongUtf8_IsAnError) {
    EXPECT_NE(errorOf("[\"\xC0\x80\"]"), "");
}

TEST(ParseJson, Binary_IsAnError) {
    EXPECT_EQ(start(errorOf(std::string_view("\0\1\2\xFE", 4))), "f.json:1:1");
}

TEST(ParseJson, ZeroByteAfterTheEnd_IsAnErrorThere) {
    EXPECT_EQ(errorOf(std::string_view("{}\0{", 4)),
              "f.json:1:3: a zero byte stands here; expected a text file");
}

TEST(ErrorText, ControlCharacters_CannotReachTheTerminal) {
    EXPECT_EQ((Error{"a\nb", 1, 2, "x\x1b[31m", ""}).text(), "a?b:1:2: x?[31m");
}

TEST(ParseJson, DepthAtTheLimit_IsRead) {
    EXPECT_EQ(errorOf(std::string(64, '[') + std::string(64, ']')), "");
}

TEST(ParseJson, DepthBeyondTheLimit_IsAnErrorAtItsPlace) {
    EXPECT_EQ(errorOf(std::string(65, '[') + std::string(65, ']')),
              "f.json:1:65: nested too deeply; expected at most 64 levels");
}

TEST(ParseJson, MillionBrackets_AreRefused) {
    EXPECT_NE(errorOf(std::string(1'000'000, '[')), "");
}

TEST(ParseJson, TooManyBytes_AreRefused) {
    EXPECT_EQ(errorOf("[1, 2]", {5, 64}),
              "f.json: the file is too large; expected at most 5 bytes");
}

TEST(ReadJson, MissingFile_IsAnErrorWithItsName) {
    const tests::TemporaryFolder folder;
    const auto document = readJson(folder / "none.json");
    ASSERT_FALSE(document);
    EXPECT_EQ(document.error().file, (folder / "none.json").string());
}

TEST(ReadJson, Folder_IsAnError) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(readJson(folder.path()).error().problem, "this is a folder");
}

TEST(ReadJson, Pipe_IsRefusedWithoutWaitingForItsOtherEnd) {
    const tests::TemporaryFolder folder;
    const auto pipe = folder / "pipe.json";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(readJson(pipe).error().problem, "this is a pipe");
}

TEST(ReadJson, Device_IsRefused) {
    EXPECT_EQ(readJson("/dev/zero").error().problem, "this is a device");
}

/// To read one waits for whoever has its other end: nobody.
TEST(ReadJson, LinkToATerminalsMaster_IsRefusedWithoutWaiting) {
    const tests::TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/ptmx", folder / "a.json");
    EXPECT_EQ(readJson(folder / "a.json").error().problem, "this is a device");
}

TEST(ReadJson, SparseFileOfTenGigabytes_IsRefusedBySize) {
    const tests::TemporaryFolder folder;
    tests::writeFile(folder / "a.json", "{}");
    std::filesystem::resize_file(folder / "a.json", std::uintmax_t(10) << 30);
    EXPECT_EQ(readJson(folder / "a.json").error().problem, "the file is too large");
}

TEST(ReadJson, HundredMegabytes_AreRefusedWithoutReadingThem) {
    const tests::TemporaryFolder folder;
    tests::writeFile(folder / "big.json", "");
    std::filesystem::resize_file(folder / "big.json", 100'000'000);
    EXPECT_EQ(readJson(folder / "big.json").error().problem, "the file is too large");
}

} // namespace
} // namespace patina::json_parse_test
