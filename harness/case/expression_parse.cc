#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>

#include "case/expression_node.h"
#include "case/suggestion.h"

namespace etalon {
namespace {

using Node = Expression::Node;
using NodePointer = std::shared_ptr<Node>;
using Parsed = Result<NodePointer>;

bool IsDigit(char c) {
    return c >= '0' && c <= '9';
}

bool IsLetter(char c) {
    return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// True where digits * 10^exponent is an integer of 64 bits times a power of two: then long double
// holds the number exactly.
bool IsExactDecimal(std::string_view digits, long exponent) {
    std::uint64_t number = 0;
    const auto [end, code] = std::from_chars(digits.begin(), digits.end(), number);
    if (code != std::errc{}) {
        return false;
    }
    for (; number != 0 && exponent > 0; --exponent) {
        if (number > std::numeric_limits<std::uint64_t>::max() / 5) {
            return false;
        }
        number *= 5;
    }
    for (; number != 0 && exponent < 0; ++exponent) {
        if (number % 5 != 0) {
            return false;
        }
        number /= 5;
    }
    return true;
}

class Parser {
  public:
    explicit Parser(std::string_view text) : text_(text) {}

    Parsed Whole() {
        SkipSpaces();
        if (AtEnd()) {
            return Fail("the expression is empty");
        }
        ETALON_TRY(tree, Or());
        if (!AtEnd()) {
            return Fail("'" + std::string(text_.substr(at_, 1)) + "' is not expected here");
        }
        return tree;
    }

  private:
    bool AtEnd() const { return at_ == text_.size(); }
    std::size_t Place() const { return at_ + 1; }
    Error Fail(const std::string& reason) const { return At(Place(), reason); }

    void SkipSpaces() {
        while (!AtEnd() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
            ++at_;
        }
    }

    // Takes the sign if it stands here. A sign that starts a longer operator does not match.
    bool Take(std::string_view sign) {
        if (!text_.substr(at_).starts_with(sign)) {
            return false;
        }
        const char next = at_ + sign.size() < text_.size() ? text_[at_ + sign.size()] : ' ';
        if ((sign == "<" || sign == ">" || sign == "!") && next == '=') {
            return false;
        }
        at_ += sign.size();
        SkipSpaces();
        return true;
    }

    static NodePointer Make(std::size_t place, std::string_view sign,
                            std::vector<NodePointer> operands) {
        auto node = std::make_shared<Node>();
        node->kind = Node::Kind::kBuiltin;
        node->place = place;
        node->name = sign;
        node->children = std::move(operands);
        return node;
    }

    Parsed LeftToRight(std::initializer_list<std::string_view> signs, Parsed (Parser::*operand)()) {
        ETALON_TRY(left, (this->*operand)());
        for (;;) {
            const std::size_t place = Place();
            std::string_view taken;
            for (const std::string_view sign : signs) {
                if (taken.empty() && Take(sign)) {
                    taken = sign;
                }
            }
            if (taken.empty()) {
                return left;
            }
            ETALON_TRY(right, (this->*operand)());
            left = Make(place, taken, {left, right});
        }
    }

    Parsed Or() { return LeftToRight({"||"}, &Parser::And); }
    Parsed And() { return LeftToRight({"&&"}, &Parser::Comparison); }
    Parsed Sum() { return LeftToRight({"+", "-"}, &Parser::Product); }
    Parsed Product() { return LeftToRight({"*", "/"}, &Parser::Unary); }

    Parsed Comparison() {
        constexpr std::string_view kSigns[] = {"==", "!=", "<=", ">=", "<", ">"};
        ETALON_TRY(left, Sum());
        bool compared = false;
        for (;;) {
            const std::size_t place = Place();
            std::string_view taken;
            for (const std::string_view sign : kSigns) {
                if (taken.empty() && Take(sign)) {
                    taken = sign;
                }
            }
            if (taken.empty()) {
                return left;
            }
            if (compared) {
                return At(place, "comparisons cannot be chained; join them with &&");
            }
            compared = true;
            ETALON_TRY(right, Sum());
            left = Make(place, taken, {left, right});
        }
    }

    Parsed Unary() {
        if (++depth_ > kDeepest) {
            return Fail("the expression is nested too deeply");
        }
        Parsed result = UnaryInside();
        --depth_;
        return result;
    }

    Parsed UnaryInside() {
        const std::size_t place = Place();
        if (Take("+")) {
            return Unary();
        }
        for (const std::string_view sign : {"-", "!"}) {
            if (Take(sign)) {
                ETALON_TRY(operand, Unary());
                if (sign == "-" && operand->kind == Node::Kind::kConstant) {
                    operand->constant = -operand->constant;
                    return operand;
                }
                return Make(place, sign, {operand});
            }
        }
        ETALON_TRY(base, Postfix());
        const std::size_t power = Place();
        if (!Take("^")) {
            return base;
        }
        ETALON_TRY(exponent, Unary());
        return Make(power, "^", {base, exponent});
    }

    Parsed Postfix() {
        ETALON_TRY(node, Primary());
        for (;;) {
            const std::size_t place = Place();
            std::string selection;
            if (Take(".")) {
                selection = Word();
                if (selection.empty() || IsDigit(selection[0])) {
                    return At(place, "components such as .x are missing after '.'");
                }
            } else if (Take("[")) {
                while (!AtEnd() && IsDigit(text_[at_])) {
                    selection += text_[at_++];
                }
                SkipSpaces();
                if (selection.empty() || selection.size() > 2 || !Take("]")) {
                    return At(place, "an index is a number in [ ]");
                }
            } else {
                return node;
            }
            auto select = std::make_shared<Node>();
            select->kind = Node::Kind::kSelect;
            select->place = place;
            select->selection = selection;
            select->children = {node};
            node = select;
        }
    }

    Parsed Primary() {
        if (AtEnd()) {
            return Fail("a value is missing at the end");
        }
        if (Take("(")) {
            ETALON_TRY(inside, Or());
            if (!Take(")")) {
                return Fail("')' is missing");
            }
            return inside;
        }
        const char here = text_[at_];
        const bool point = here == '.' && at_ + 1 < text_.size() && IsDigit(text_[at_ + 1]);
        if (IsDigit(here) || point) {
            return Number();
        }
        if (IsLetter(here)) {
            return Named();
        }
        return Fail("a value is missing before '" + std::string(1, here) + "'");
    }

    std::string Word() {
        std::string word;
        while (!AtEnd() && (IsLetter(text_[at_]) || IsDigit(text_[at_]))) {
            word += text_[at_++];
        }
        SkipSpaces();
        return word;
    }

    Parsed Number() {
        const std::size_t begin = at_;
        const bool hexadecimal =
            text_.substr(at_).starts_with("0x") || text_.substr(at_).starts_with("0X");
        std::size_t end = at_;
        while (end < text_.size()) {
            const char c = text_[end];
            const char before = end > begin ? text_[end - 1] : ' ';
            const bool exponent_sign =
                (c == '+' || c == '-') &&
                (hexadecimal ? before == 'p' || before == 'P' : before == 'e' || before == 'E');
            if (!IsDigit(c) && !IsLetter(c) && c != '.' && !exponent_sign) {
                break;
            }
            ++end;
        }
        const std::string_view whole = text_.substr(begin, end - begin);
        const std::string_view digits = hexadecimal ? whole.substr(2) : whole;
        auto node = std::make_shared<Node>();
        node->place = begin + 1;
        long double& value = node->constant.value;
        const auto [stop, code] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value,
                            hexadecimal ? std::chars_format::hex : std::chars_format::general);
        if (code != std::errc{} || stop != digits.data() + digits.size()) {
            return Fail("'" + std::string(whole) + "' is not a number");
        }
        if (!(hexadecimal ? digits.size() <= 16 : IsExactLiteral(digits))) {
            node->constant.error = std::fabs(value) * std::numeric_limits<long double>::epsilon();
        }
        at_ = end;
        SkipSpaces();
        return node;
    }

    static bool IsExactLiteral(std::string_view literal) {
        std::string digits;
        long exponent = 0;
        bool fraction = false;
        std::size_t at = 0;
        for (; at < literal.size() && literal[at] != 'e' && literal[at] != 'E'; ++at) {
            if (literal[at] == '.') {
                fraction = true;
            } else {
                digits += literal[at];
                exponent -= fraction ? 1 : 0;
            }
        }
        if (at < literal.size()) {
            long written = 0;
            const char* begin = literal.data() + at + 1 + (literal[at + 1] == '+' ? 1 : 0);
            std::from_chars(begin, literal.data() + literal.size(), written);
            exponent += written;
        }
        return IsExactDecimal(digits, exponent);
    }

    // A symbol, a function's call, or an oracle's, whose name holds a point.
    Parsed Named() {
        auto node = std::make_shared<Node>();
        node->place = Place();
        node->name = Word();
        const std::size_t after_word = at_;
        while (!AtEnd() && text_[at_] == '.') {
            ++at_;
            const std::string word = Word();
            if (word.empty()) {
                break;
            }
            node->name += "." + word;
        }
        if (!AtEnd() && text_[at_] == '(') {
            const bool oracle = node->name.find('.') != std::string::npos;
            node->kind = oracle ? Node::Kind::kOracle : Node::Kind::kBuiltin;
            ETALON_TRY_STEP(Arguments(*node));
            return node;
        }
        at_ = after_word;
        node->name = node->name.substr(0, node->name.find('.'));
        node->kind = Node::Kind::kSymbol;
        return node;
    }

    Status<> Arguments(Node& call) {
        Take("(");
        if (!Take(")")) {
            do {
                ETALON_TRY(argument, Or());
                call.children.push_back(argument);
            } while (Take(","));
            if (!Take(")")) {
                return Fail("')' is missing");
            }
        }
        return Ok();
    }

    static constexpr int kDeepest = 200;
    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

}  // namespace

Error At(std::size_t place, const std::string& reason) {
    return Error{"column " + std::to_string(place) + ": " + reason};
}

Result<std::shared_ptr<Expression::Node>> ParseExpression(std::string_view text) {
    return Parser(text).Whole();
}

}  // namespace etalon
