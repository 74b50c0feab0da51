#include "run/csv.h"

#include <gmock/gmock.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;

class CsvTest : public testing::Test {
  protected:
    std::string ErrorOf(const std::string& content) {
        const std::string path = folder_.Write("t.csv", content);
        const auto table = ReadCsv(path);
        if (table) {
            return "";
        }
        // The path, whatever it is, comes first.
        EXPECT_TRUE(table.error().message.starts_with(path)) << table.error().message;
        return "t.csv" + table.error().message.substr(path.size());
    }
    InputTable Read(const std::string& content) {
        auto table = ReadCsv(folder_.Write("t.csv", content));
        EXPECT_TRUE(table) << table.error().message;
        return table ? *table : InputTable{};
    }

    Folder folder_;
};

std::string Arguments(const InputTable& table, const std::vector<Argument>& declared = {}) {
    const auto arguments = ArgumentsOf(table, declared, "t.csv:1");
    if (!arguments) {
        return arguments.error().message;
    }
    std::string text;
    for (const Argument& argument : *arguments) {
        text += argument.type + " " + argument.name + ";";
    }
    return text;
}

TEST_F(CsvTest, ReadsColumnsOfEveryType) {
    const InputTable table =
        Read("x:float,i:int,u:uint,b:bool\n1.5,-1,0xffffffff,true\n-0x1p-149,2,0,0\n");
    ASSERT_EQ(table.columns.size(), 4u);
    EXPECT_EQ(table.columns[3].name, "b");
    EXPECT_EQ(table.columns[3].scalar, Scalar::kBool);
    EXPECT_EQ(table.rows, 2u);
    EXPECT_THAT(table.words,
                ElementsAre(0x3fc00000u, 0x80000001u, 0xffffffffu, 2u, 0xffffffffu, 0u, 1u, 0u));
}

TEST_F(CsvTest, TakesSpecialValues) {
    EXPECT_THAT(Read("x:float\nnan\ninf\n-inf\n-0\n0x1.8p-3\n1e-45\n").words,
                ElementsAre(0x7fc00000u, 0x7f800000u, 0xff800000u, 0x80000000u, 0x3e400000u, 1u));
}

TEST_F(CsvTest, TakesBothEndsOfLineAMarkBlankLinesAndSpaces) {
    const std::string plain = "x:float,y:float\n1,2\n3,4\n";
    const InputTable expected = Read(plain);
    for (const char* other :
         {"x:float,y:float\r\n1,2\r\n3,4\r\n", "\xef\xbb\xbfx:float,y:float\n1,2\n3,4\n",
          "\n\nx:float,y:float\n\n1,2\n  \n3,4", "  x : float ,y: float\n 1 , 2 \n3,\t4\n\n\n",
          "\xef\xbb\xbf\r\nx:float,y:float\r\n1,2\r\n\r\n3,4"}) {
        const InputTable table = Read(other);
        EXPECT_EQ(table.rows, 2u) << other;
        EXPECT_EQ(table.words, expected.words) << other;
        EXPECT_EQ(table.columns.at(0).name, "x");
    }
}

TEST_F(CsvTest, SaysWhatIsWrongAndWhere) {
    const std::pair<const char*, const char*> rows[] = {
        {"", "t.csv:1: no header; it reads name:type, as in n1:float,n2:float"},
        {"\n \r\n", "t.csv:1: no header; it reads name:type, as in n1:float,n2:float"},
        {"x:float\n", "t.csv:1: no rows"},
        {"x:float\n\n\n", "t.csv:3: no rows"},
        {"x\n1\n", "t.csv:1: column 'x' has no type; a header reads name:type, as in n1:float"},
        {"1,2\n3,4\n", "t.csv:1: '1' is not a GLSL name"},
        {"x:float,:float\n1,2\n", "t.csv:1: '' is not a GLSL name"},
        {"x:float,\n1,2\n", "t.csv:1: '' is not a GLSL name"},
        {"a b:float\n1\n", "t.csv:1: 'a b' is not a GLSL name"},
        {"x:double\n1\n", "t.csv:1: column 'x': 'double' is not float, int, uint or bool"},
        {"v:vec3\n1\n", "t.csv:1: column 'v': 'vec3' is not float, int, uint or bool"},
        {"x:\n1\n", "t.csv:1: column 'x': '' is not float, int, uint or bool"},
        {"x:float,x:int\n1,2\n", "t.csv:1: column 'x' stands twice"},
        {"x:float,y:float\n1,2\n3\n", "t.csv:3: 1 values, the header has 2 columns"},
        {"x:float,y:float\n1,2,3\n", "t.csv:2: 3 values, the header has 2 columns"},
        {"x:float,y:float\n1,2,\n", "t.csv:2: 3 values, the header has 2 columns"},
        {"x:float\n1\n\nabc\n", "t.csv:4: column 'x': 'abc' is not a float"},
        {"x:float,y:float\n1,\n", "t.csv:2: column 'y': '' is not a float"},
        {"\nx:float\n1e99\n", "t.csv:3: column 'x': '1e99' does not fit a float"},
        {"i:int\n1.5\n", "t.csv:2: column 'i': '1.5' is not an int"},
        {"i:int\n2147483648\n", "t.csv:2: column 'i': '2147483648' does not fit an int"},
        {"u:uint\n-1\n", "t.csv:2: column 'u': '-1' does not fit a uint"},
        {"b:bool\n2\n", "t.csv:2: column 'b': '2' is not a bool"},
        {"x:float\n\"1\"\n", "t.csv:2: column 'x': '\"1\"' is not a float"},
        {"x:float\n1;2\n", "t.csv:2: column 'x': '1;2' is not a float"},
    };
    for (const auto& [content, expected] : rows) {
        EXPECT_EQ(ErrorOf(content), expected) << content;
    }
    EXPECT_EQ(ErrorOf(std::string("x:float\n\0", 9)), "t.csv: is not text (it holds a NUL byte)");
    EXPECT_EQ(ReadCsv("/no/such.csv").error().message, "/no/such.csv: No such file or directory");
    EXPECT_EQ(ReadCsv("/tmp").error().message, "/tmp: is a folder, not a file");
}

TEST_F(CsvTest, MakesVectorsOfComponents) {
    EXPECT_EQ(
        Arguments(Read("n1:float,v.x:float,v.y:float,v.z:float,i.x:int,i.y:int\n1,2,3,4,5,6\n")),
        "float n1;vec3 v;ivec2 i;");
    EXPECT_EQ(Arguments(Read("v.w:float,v.x:float,v.z:float,v.y:float\n1,2,3,4\n")), "vec4 v;");
    const std::string reason =
        " make no scalar and no vector (v.x, v.y, ...); --in v:TYPE declares "
        "another type";
    for (const char* header : {"v.x:float", "v.x:float,v.z:float", "v:float,v.x:float",
                               "v.x:float,v.q:float", "v[0]:float,v[1]:float"}) {
        std::string row = "1";
        for (const char* c = header; *c != '\0'; ++c) {
            row += *c == ',' ? ",1" : "";
        }
        EXPECT_EQ(Arguments(Read(std::string(header) + "\n" + row + "\n")),
                  "t.csv:1: the columns of 'v'" + reason)
            << header;
    }
    EXPECT_EQ(Arguments(Read("v.x:float,v.y:int\n1,2\n")),
              "t.csv:1: the components of 'v' have different types");
}

TEST_F(CsvTest, TakesDeclaredTypes) {
    const std::vector<Argument> declared = {{"m", "mat2", true, false}, {"h", "Hit", true, false}};
    const InputTable table = Read(
        "h.t:float,m[0].x:float,m[0].y:float,m[1].x:float,m[1].y:float\n"
        "9,1,2,3,4\n");
    EXPECT_EQ(Arguments(table, declared), "Hit h;mat2 m;");
    EXPECT_EQ(Arguments(Read("x:float\n1\n"), {{"m", "mat2", true, false}}),
              "t.csv:1: no column for input 'm'");
}

TEST_F(CsvTest, ArrangesByTheOrderOfTheType) {
    const InputTable table = Read("v.y:float,v.x:float,n:int\n1,2,3\n4,5,6\n");
    const std::vector<ProbeColumn> columns = {
        {"v.x", Scalar::kFloat}, {"v.y", Scalar::kFloat}, {"n", Scalar::kInt}};
    const auto words = Arrange(table, columns, "t.csv:1");
    ASSERT_TRUE(words);
    EXPECT_THAT(*words, ElementsAre(0x40000000u, 0x40a00000u, 0x3f800000u, 0x40800000u, 3u, 6u));

    EXPECT_EQ(Arrange(table, {columns[0]}, "t.csv:1").error().message,
              "t.csv:1: column 'v.y' is no part of its type");
    EXPECT_EQ(Arrange(table, {{"w", Scalar::kInt}}, "t.csv:1").error().message,
              "t.csv:1: no column 'w'");
    EXPECT_EQ(Arrange(table, {{"n", Scalar::kUint}}, "t.csv:1").error().message,
              "t.csv:1: column 'n' is int, the type wants uint");
}

TEST(ReadAt, ReadsOneRow) {
    const auto table = ReadAt("n1=0x1p-149, steps:int = -3,b:bool=true");
    ASSERT_TRUE(table) << table.error().message;
    EXPECT_EQ(table->rows, 1u);
    EXPECT_THAT(table->words, ElementsAre(1u, 0xfffffffdu, 1u));
    EXPECT_EQ(table->columns[1].name, "steps");
    EXPECT_EQ(table->columns[1].scalar, Scalar::kInt);
}

TEST(ReadAt, SaysWhatIsWrong) {
    const std::pair<const char*, const char*> rows[] = {
        {"n1", "--at: 'n1' is not NAME=VALUE or NAME:TYPE=VALUE"},
        {"n1=1,", "--at: '' is not NAME=VALUE or NAME:TYPE=VALUE"},
        {"=1", "--at: '' is not a GLSL name"},
        {"n1=x", "--at: n1: 'x' is not a float"},
        {"n1=", "--at: n1: '' is not a float"},
        {"n1:vec2=1", "--at: column 'n1': 'vec2' is not float, int, uint or bool"},
        {"n1=1,n1=2", "--at: 'n1' stands twice"},
    };
    for (const auto& [text, expected] : rows) {
        const auto table = ReadAt(text);
        ASSERT_FALSE(table) << text;
        EXPECT_EQ(table.error().message, expected);
    }
}

}  // namespace
}  // namespace etalon
