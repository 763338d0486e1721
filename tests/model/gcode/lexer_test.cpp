#include "model/gcode/text/lexer.h"

#include <charconv>
#include <random>

#include "model/text/number_text.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

namespace {

/// A program with parameters that its tests may set.
struct LexedLine {
  explicit LexedLine(std::string program) : text(std::move(program)) {}

  std::string text;
  Parameters parameters;
  Lexer lexer{text, "text.ngc", parameters};
  Block block;

  bool next() { return lexer.next(block); }
};

/// `X1.5 Y2` and so on for the words of a block.
std::string words_of(const Block& block) {
  std::string text;
  for (const Word& word : block.words) {
    if (!text.empty()) text += ' ';
    text += word.letter + shortest(word.value);
  }
  return text;
}

std::string words_of(const std::string& line) {
  LexedLine reading(line);
  return reading.next() ? words_of(reading.block) : "nothing";
}

std::string lexing_error_of(const std::string& text) {
  return message_of<InputError>([&] {
    LexedLine reading(text);
    while (reading.next()) continue;
  });
}

/// Label and keyword of the O line that `line` is.
std::string o_word_of(const std::string& line) {
  LexedLine reading(line);
  if (!reading.next() || !reading.block.o_word) return "none";
  const OWord& o_word = *reading.block.o_word;
  return (o_word.named ? "<" + o_word.label + ">" : o_word.label) + " " + o_word.keyword;
}

}  // namespace

TEST_CASE("words have letters in upper case, values and places", "[unit][program]") {
  LexedLine reading("n10 g1\tX-1.5 y 2 . 5(up)Z+.25\r\n");
  REQUIRE(reading.next());
  const Block& block = reading.block;
  CHECK(block.line == 1);
  CHECK(words_of(block) == "G1 X-1.5 Y2.5 Z0.25");
  REQUIRE(block.words.size() == 4);
  CHECK(block.words[0].column == 5);
  CHECK(block.words[0].text == "g1");
  CHECK(block.words[2].column == 14);
  CHECK(block.words[2].text == "y 2 . 5");
  CHECK(block.words[3].text == "Z+.25");
  REQUIRE(block.comments.size() == 1);
  CHECK(block.comments[0].text == "(up)");
  CHECK(block.comments[0].column == 21);
  CHECK_FALSE(reading.next());
}

TEST_CASE("comments stand anywhere between words, or end the line", "[unit][program]") {
  LexedLine reading("(a)X1(b)Y2 ; (c \t\r\n(MSG, hello) ;\n;\n");
  REQUIRE(reading.next());
  CHECK(words_of(reading.block) == "X1 Y2");
  REQUIRE(reading.block.comments.size() == 3);
  CHECK(reading.block.comments[1].text == "(b)");
  CHECK(reading.block.comments[2].text == "; (c");
  REQUIRE(reading.next());
  REQUIRE(reading.block.comments.size() == 2);
  CHECK(reading.block.comments[0].text == "(MSG, hello)");
  CHECK(reading.block.comments[1].text == ";");
  REQUIRE(reading.next());
  CHECK(reading.block.comments.size() == 1);
  CHECK_FALSE(reading.next());
}

TEST_CASE("values of words may be calculated", "[unit][program]") {
  LexedLine reading("X[1+2]Y#1Z-#<high>F sqrt[16] G#[2-1]\n");
  reading.parameters.set(1, 5);
  reading.parameters.set("high", 7);
  REQUIRE(reading.next());
  CHECK(words_of(reading.block) == "X3 Y5 Z-7 F4 G5");
  CHECK(reading.block.words[2].text == "Z-#<high>");
}

TEST_CASE("settings take their values before they take effect", "[unit][program]") {
  LexedLine reading("#1=2 #2 = #1 X#1 (c) #<a B>=[#1 * 2]#[1+2]=-3\n");
  reading.parameters.set(1, 5);
  REQUIRE(reading.next());
  const auto& settings = reading.block.settings;
  REQUIRE(settings.size() == 4);
  CHECK(settings[0].parameter.number == 1);
  CHECK(settings[0].value == 2);
  CHECK(settings[1].parameter.number == 2);
  CHECK(settings[1].value == 5);
  CHECK(settings[1].column == 6);
  CHECK(settings[2].parameter.name == "ab");
  CHECK(settings[2].value == 10);
  CHECK(settings[3].parameter.number == 3);
  CHECK(settings[3].value == -3);
  CHECK(words_of(reading.block) == "X5");
  CHECK(reading.parameters.numbered(1) == 5);
}

TEST_CASE("line numbers are dropped, with decimals too", "[unit][program]") {
  CHECK(words_of("N10 X1") == "X1");
  CHECK(words_of("n 1 0.5X1") == "X1");
  CHECK(words_of("/N10X1") == "X1");
  CHECK(words_of("N123456789012") == "");
}

TEST_CASE("O lines are cut into label and keyword", "[unit][program]") {
  CHECK(o_word_of("o100 sub") == "100 sub");
  CHECK(o_word_of("O0100SUB") == "100 sub");
  CHECK(o_word_of("o 1 0 0 end sub") == "100 endsub");
  CHECK(o_word_of("O000") == "0 ");
  CHECK(o_word_of("O1234 (a part)") == "1234 ");
  CHECK(o_word_of("O1234;") == "1234 ");
  CHECK(o_word_of("N10 o<Bore Hole>call [1]") == "<borehole> call");
  CHECK(o_word_of("o100 if[1]") == "100 if");
  CHECK(o_word_of("o[4 + 1] call") == "5 call");
  CHECK(o_word_of("o100 callX5") == "100 call");
  CHECK(o_word_of("o100 el se if [1]") == "100 elseif");
  CHECK(o_word_of("o100 elsewhere") == "100 else");
  CHECK(o_word_of("o100 perhaps [1]") == "100 perhaps");
  CHECK(o_word_of("o100 [1]") == "100 ");
  CHECK(o_word_of("X1") == "none");
}

TEST_CASE("an O line says where it and its parts stand", "[unit][program]") {
  LexedLine reading("/ N5 o100 while [#1 LT 5] (more)\n");
  REQUIRE(reading.next());
  REQUIRE(reading.block.o_word);
  CHECK(reading.block.block_delete);
  CHECK(reading.block.o_word->column == 6);
  CHECK(reading.block.o_word->keyword_column == 11);
  CHECK(reading.block.o_word->rest == 15);
  CHECK(reading.block.words.empty());
  CHECK(reading.block.settings.empty());
}

TEST_CASE("a call may calculate its number", "[unit][program]") {
  LexedLine reading("o[#1 + 2] call\no#1 call [4]\no[100] sub\n");
  reading.parameters.set(1, 100);
  REQUIRE(reading.next());
  CHECK(reading.block.o_word->label == "102");
  CHECK(reading.block.o_word->calculated);
  REQUIRE(reading.next());
  CHECK(reading.block.o_word->label == "100");
  CHECK_THROWS_WITH(reading.next(), ContainsSubstring("text.ngc:3:1: error: an O word with a "
                                                      "calculated number that is no call"));
}

TEST_CASE("arguments are calculated when they are asked for", "[unit][program]") {
  LexedLine reading("o100 call [1] [#1] (c) [2 + 3] ; end\no100 sub\no1 if [#1]\n");
  REQUIRE(reading.next());
  reading.parameters.set(1, 7);
  CHECK(reading.lexer.arguments(reading.block) == std::vector<double>{1, 7, 5});
  reading.parameters.set(1, 8);
  CHECK(reading.lexer.arguments(reading.block) == std::vector<double>{1, 8, 5});
  REQUIRE(reading.next());
  CHECK(reading.lexer.arguments(reading.block).empty());
  REQUIRE(reading.next());
  CHECK(reading.lexer.arguments(reading.block) == std::vector<double>{8});
}

TEST_CASE("arguments that cannot be read are errors at their place", "[unit][program]") {
  const auto error = [](const std::string& line) {
    return message_of<InputError>([&] {
      LexedLine reading(line);
      reading.next();
      reading.lexer.arguments(reading.block);
    });
  };
  CHECK_THAT(error("o100 call [1] X5"), ContainsSubstring("text.ngc:1:15: error: 'X' behind"));
  CHECK_THAT(error("o100 call [#5]"), ContainsSubstring("text.ngc:1:12: error: parameter #5"));
  CHECK_THAT(error("o100 call (c"), ContainsSubstring("text.ngc:1:11: error: the comment does"));
  std::string many = "o100 call";
  for (int i = 0; i < 101; ++i) many += "[1]";
  CHECK_THAT(error(many), ContainsSubstring("text.ngc:1:310: error: more than 100 values"));
  CHECK_THAT(error("o100 call 5"), ContainsSubstring("text.ngc:1:11: error: '5' behind"));
  CHECK_THAT(error("o100 if #1"), ContainsSubstring("text.ngc:1:9: error: '#' behind"));
  CHECK_THAT(error("o100 endifX2"), ContainsSubstring("text.ngc:1:11: error: 'X' behind"));
}

TEST_CASE("skipping goes to O words only and reads nothing between", "[unit][program]") {
  LexedLine reading(
      "X#1 [\n(o1 sub)\n;o2 sub\nX1 o3 sub\n#<o4 sub\no#1 call\n / n 5 o5 if [#9]\n O6\n");
  REQUIRE(reading.lexer.skip_to_o_word(reading.block));
  CHECK(reading.block.line == 7);
  CHECK(reading.block.block_delete);
  CHECK(reading.block.o_word->label == "5");
  CHECK(reading.block.o_word->keyword == "if");
  REQUIRE(reading.lexer.skip_to_o_word(reading.block));
  CHECK(reading.block.line == 8);
  CHECK(reading.block.o_word->label == "6");
  CHECK_FALSE(reading.lexer.skip_to_o_word(reading.block));
  CHECK_FALSE(reading.block.o_word);
}

TEST_CASE("skipping goes over what only looks like an O word", "[unit][program]") {
  LexedLine reading(
      "Operation 5\nO\nO<open\nO< >\nO<a(b)>\nO1234567890 sub\nO5 [\nO-5 sub\n% of all\no7\n");
  CHECK_FALSE(reading.lexer.skip_to_o_word(reading.block));
  reading.lexer.go_to({72, 10});
  REQUIRE(reading.lexer.skip_to_o_word(reading.block));
  CHECK(reading.block.o_word->label == "7");
}

TEST_CASE("a bookmark of the line that was read leads back to it", "[unit][program]") {
  LexedLine reading("X1\n\no7 sub\nX2\n");
  REQUIRE(reading.next());
  const Lexer::Bookmark first = reading.lexer.line_bookmark();
  REQUIRE(reading.lexer.skip_to_o_word(reading.block));
  const Lexer::Bookmark second = reading.lexer.line_bookmark();
  REQUIRE(reading.next());
  reading.lexer.go_to(second);
  REQUIRE(reading.next());
  CHECK(reading.block.line == 3);
  CHECK(reading.block.o_word);
  reading.lexer.go_to(first);
  REQUIRE(reading.next());
  CHECK(reading.block.line == 1);
  CHECK(words_of(reading.block) == "X1");
}

TEST_CASE("a percent sign that ends the program ends skipping", "[unit][program]") {
  LexedLine reading("%\nX1\n%\no1 sub\n");
  CHECK_FALSE(reading.lexer.skip_to_o_word(reading.block));
  CHECK_FALSE(reading.lexer.skip_to_o_word(reading.block));
}

TEST_CASE("a bookmark leads back to its line, from behind the end too", "[unit][program]") {
  LexedLine reading("\xEF\xBB\xBF\n %\nX1\nX2\n%\n");
  const Lexer::Bookmark start = reading.lexer.bookmark();
  const auto all = [&reading] {
    std::string text;
    while (reading.next()) text += std::to_string(reading.block.line) + words_of(reading.block);
    return text;
  };
  REQUIRE(reading.next());
  REQUIRE(reading.next());
  const Lexer::Bookmark first = reading.lexer.bookmark();
  CHECK(all() == "3X14X2");
  CHECK_FALSE(reading.next());
  reading.lexer.go_to(first);
  CHECK(all() == "3X14X2");
  reading.lexer.go_to(start);
  CHECK(all() == "123X14X2");
}

TEST_CASE("percent signs stand at both ends or at none", "[unit][program]") {
  CHECK(lexing_error_of("\n%\nX1\n%\nwhat stands here is not read") == "no error");
  CHECK(lexing_error_of("X1") == "no error");
  CHECK_THAT(lexing_error_of("X1\n%\n"),
             ContainsSubstring("text.ngc:2:1: error: '%' ends a program"));
  CHECK_THAT(lexing_error_of("%\nX1\n"),
             ContainsSubstring("text.ngc:3:1: error: the program that '%'"));
  CHECK_THAT(lexing_error_of("(c)\n%\n%\n"), ContainsSubstring("text.ngc:2:1: error: '%' ends"));
  CHECK_THAT(lexing_error_of("% 1"), ContainsSubstring("text.ngc:1:3: error: text after '%'"));
}

TEST_CASE("a line has at most 100 items", "[unit][program]") {
  std::string line;
  for (int i = 0; i < 101; ++i) line += "#1=2";
  CHECK(lexing_error_of(line) == "no error");
  CHECK_THAT(lexing_error_of(line + "X1"),
             ContainsSubstring("text.ngc:1:405: error: more than 100"));
}

TEST_CASE("a line has at most 10000 bytes, of a comment too", "[unit][program]") {
  const std::string most = ";" + std::string(9999, 'c');
  CHECK(
      lexing_error_of(most + "\nX1\n" + most + "\r") ==
      "text.ngc:3:10001: error: a line of more than 10000 bytes; expected a line that ends sooner");
  CHECK(lexing_error_of(most) == "no error");
  LexedLine reading("o1 sub " + most + "\no2 sub\n");
  REQUIRE(reading.lexer.skip_to_o_word(reading.block));
  CHECK(reading.block.line == 2);
}

TEST_CASE("plain numbers are rounded as from_chars rounds them", "[property][program]") {
  std::mt19937 random(13);
  for (int round = 0; round < 100000; ++round) {
    std::string digits;
    for (std::size_t count = random() % 20 + 1; count > 0; --count)
      digits += static_cast<char>('0' + random() % 10);
    if (const std::size_t point = random() % (digits.size() + 5); point <= digits.size())
      digits.insert(point, ".");
    double expected = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), expected);
    const bool negative = random() % 2 == 0;
    LexedLine reading((negative ? "X-" : "X") + digits);
    REQUIRE(reading.next());
    REQUIRE(reading.block.words.at(0).value == (negative ? -expected : expected));
  }
}

TEST_CASE("blanks and case change nothing but columns", "[property][program]") {
  const std::string plain = "n5.5g1x-12.75y[#1*2]z#<a_b>fsin[30]#3=[1lt2]";
  std::mt19937 random(14);
  for (int round = 0; round < 2000; ++round) {
    std::string text;
    for (const char c : plain) {
      if (random() % 4 == 0) text += random() % 2 == 0 ? ' ' : '\t';
      text += c >= 'a' && c <= 'z' && random() % 2 == 0 ? static_cast<char>(c - 'a' + 'A') : c;
    }
    CAPTURE(text);
    LexedLine reading(text);
    reading.parameters.set(1, 4);
    reading.parameters.set("a_b", 9);
    REQUIRE(reading.next());
    CHECK(words_of(reading.block) == "G1 X-12.75 Y8 Z9 F0.5");
    REQUIRE(reading.block.settings.size() == 1);
    CHECK(reading.block.settings[0].value == 1);
  }
}

TEST_CASE("random bytes give blocks or an InputError within their line", "[property][program]") {
  std::mt19937 random(15);
  const std::string alphabet = "oO<>xXnNgG##[]()=;/%.-+01259 \t\r\nsubcalsin\x01\xff";
  std::size_t blocks = 0, o_words = 0;
  for (int round = 0; round < 20000; ++round) {
    std::string text = round % 3 == 0 ? "o1" : "";
    for (std::size_t length = random() % 14; length > 0; --length)
      text += alphabet[random() % alphabet.size()];
    LexedLine reading(text);
    const bool skips = round % 4 == 0;
    try {
      while (skips ? reading.lexer.skip_to_o_word(reading.block) : reading.next()) {
        ++blocks;
        if (!reading.block.o_word) continue;
        ++o_words;
        reading.lexer.arguments(reading.block);
      }
    } catch (const InputError& error) {
      CHECK(error.place().line >= 1);
      CHECK(error.place().column >= 1);
      CHECK(error.place().column <= static_cast<int>(text.size()) + 1);
    }
  }
  CHECK(blocks > 1000);
  CHECK(o_words > 100);
}
