// SPDX-License-Identifier: MIT
#include "notation/text/expression.h"

#include "notation/text/number.h"

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

namespace notation {

namespace {

constexpr double degree = std::numbers::pi / 180;

// As many degrees as the angle has, if that is a whole number but for rounding; else NaN.
double wholeDegrees(double radians) {
    const double degrees = radians / degree;
    const double whole = std::nearbyint(degrees);
    return std::abs(degrees - whole) <= 1e-13 * std::max(1.0, std::abs(degrees)) ? whole : NAN;
}

double sine(double x) {
    const double degrees = std::abs(std::remainder(wholeDegrees(x), 180)); // at most 90
    if (degrees == 0) return 0;
    if (degrees == 30) return std::copysign(0.5, std::sin(x));
    if (degrees == 90) return std::copysign(1, std::sin(x));
    return std::sin(x);
}

double cosine(double x) {
    const double degrees = std::abs(std::remainder(wholeDegrees(x), 180));
    if (degrees == 90) return 0;
    if (degrees == 60) return std::copysign(0.5, std::cos(x));
    if (degrees == 0) return std::copysign(1, std::cos(x));
    return std::cos(x);
}

double tangent(double x) {
    const double degrees = std::remainder(wholeDegrees(x), 180);
    if (degrees == 0) return 0;
    if (std::abs(degrees) == 45) return std::copysign(1, degrees);
    if (std::abs(degrees) == 90) return NAN;
    return std::tan(x);
}

constexpr std::array names{"pi",   "e",    "phi",   "deg",  "sin",  "cos",  "tan",  "asin",
                           "acos", "atan", "atan2", "sinh", "cosh", "tanh", "sqrt", "cbrt",
                           "exp",  "ln",   "log",   "log2", "abs",  "min",  "max"};

// A number on the way through an expression.
struct Quantity {
    double value = 0;   // value with angles in radians, as everywhere
    double reading = 0; // value without units: 90 for 90°, π/2 for pi/2
    double degrees = 0; // exponent of ° as a factor
    double radians = 0; // exponent of π and of inverse functions
    // Exact value without units: the value is exact · (π/180)^degrees · π^radians. Often missing.
    ifs::Surd exact = ifs::Surd::none();
};

Quantity plainNumber(double value, const ifs::Surd& exact = ifs::Surd::none()) {
    return {value, value, 0, 0, exact};
}

Quantity inRadians(double value) {
    return {value, value, 0, 1};
}

bool isInRadians(const Quantity& q) {
    return q.radians > 0 && q.degrees <= 0;
}

double inDegrees(const Quantity& q) {
    if (!isInRadians(q)) return q.reading;
    const double whole = wholeDegrees(q.reading);
    return std::isnan(whole) ? q.reading / degree : whole;
}

bool isSameUnit(const Quantity& a, const Quantity& b) {
    return a.degrees == b.degrees && a.radians == b.radians;
}

// What becomes of two numbers one unit of which must do for both.
template <class Function> Quantity together(const Quantity& a, const Quantity& b, const Function& function) {
    const double value = function(a.value, b.value);
    if (isSameUnit(a, b)) return {value, function(a.reading, b.reading), a.degrees, a.radians};
    return {value, function(inDegrees(a), inDegrees(b)), 1, 0};
}

Quantity sum(const Quantity& a, const Quantity& b) {
    Quantity result = together(a, b, std::plus());
    if (isSameUnit(a, b)) result.exact = a.exact + b.exact;
    return result;
}

Quantity difference(const Quantity& a, const Quantity& b) {
    Quantity result = together(a, b, std::minus());
    if (isSameUnit(a, b)) result.exact = a.exact - b.exact;
    return result;
}

Quantity product(const Quantity& a, const Quantity& b) {
    return {a.value * b.value, a.reading * b.reading, a.degrees + b.degrees, a.radians + b.radians,
            a.exact * b.exact};
}

Quantity quotient(const Quantity& a, const Quantity& b) {
    return {a.value / b.value, a.reading / b.reading, a.degrees - b.degrees, a.radians - b.radians,
            a.exact / b.exact};
}

ifs::Surd exactPower(const Quantity& base, const Quantity& exponent) {
    constexpr std::int64_t most = 64;
    if (base.degrees != 0 || base.radians != 0 || exponent.degrees != 0 || exponent.radians != 0)
        return ifs::Surd::none();
    if (exponent.exact == ifs::Surd(1) / ifs::Surd(2)) return ifs::Surd::root(base.exact);
    const auto times = exponent.exact.whole();
    if (!times || *times < -most || *times > most) return ifs::Surd::none();
    ifs::Surd result(1);
    for (std::int64_t k = 0; k < std::abs(*times); ++k)
        result = result * base.exact;
    return *times < 0 ? ifs::Surd(1) / result : result;
}

Quantity power(const Quantity& base, const Quantity& exponent) {
    return {std::pow(base.value, exponent.value), std::pow(base.reading, exponent.value),
            base.degrees * exponent.value, base.radians * exponent.value, exactPower(base, exponent)};
}

// The sine of as many degrees, where it is such a number.
ifs::Surd exactSine(const ifs::Surd& degrees) {
    using ifs::Surd;
    const auto whole = degrees.whole();
    if (!whole) return Surd::none();
    const auto turned = (*whole % 360 + 360) % 360;
    const auto inHalf = turned % 180, angle = std::min(inHalf, 180 - inHalf);
    const Surd half = Surd(1) / Surd(2), golden = (Surd(1) + Surd::root(5)) / Surd(4);
    const std::array<std::pair<std::int64_t, Surd>, 7> known{{{0, Surd(0)},
                                                              {18, golden - half},
                                                              {30, half},
                                                              {45, Surd::root(half)},
                                                              {54, golden},
                                                              {60, Surd::root(3) * half},
                                                              {90, Surd(1)}}};
    const auto found = std::ranges::find(known, angle, &std::pair<std::int64_t, Surd>::first);
    if (found == known.end()) return Surd::none();
    return turned > 180 ? -found->second : found->second;
}

// In degrees, of an angle that is written with ° or π; else without value.
ifs::Surd exactDegrees(const Quantity& angle) {
    if (angle.degrees == 1 && angle.radians == 0) return angle.exact;
    if (angle.degrees == 0 && angle.radians == 1) return angle.exact * ifs::Surd(180);
    return angle.exact.isZero() ? angle.exact : ifs::Surd::none();
}

// The parser knows doubles only: those that it is given, and that it gives its operators, are places in here.
thread_local std::vector<Quantity> quantities;
const std::array constants{
    Quantity{std::numbers::pi, std::numbers::pi, 0, 1, ifs::Surd(1)}, plainNumber(std::numbers::e),
    plainNumber(std::numbers::phi, (ifs::Surd(1) + ifs::Surd::root(5)) / ifs::Surd(2))};

double placeOf(const Quantity& quantity) {
    quantities.push_back(quantity);
    return double(quantities.size() - 1);
}

Quantity at(double place) {
    return quantities[std::size_t(place)];
}

template <double (*function)(double)> double number(double x) {
    return placeOf(plainNumber(function(at(x).value)));
}

template <double (*function)(double)> double angle(double x) {
    return placeOf(inRadians(function(at(x).value)));
}

class Parser : public mu::ParserBase {
public:
    Parser() { Init(); }

protected:
    void InitCharSets() override {
        DefineNameChars("0123456789abcdefghijklmnopqrstuvwxyz");
        DefineOprtChars("abcdefghijklmnopqrstuvwxyz+-*^/");
        DefineInfixOprtChars("+-");
    }
    void InitFun() override {
        DefineFun(
            "sin", +[](double x) {
                return placeOf(plainNumber(sine(at(x).value), exactSine(exactDegrees(at(x)))));
            });
        DefineFun(
            "cos", +[](double x) {
                const ifs::Surd complement = ifs::Surd(90) - exactDegrees(at(x));
                return placeOf(plainNumber(cosine(at(x).value), exactSine(complement)));
            });
        DefineFun(
            "tan", +[](double x) {
                const ifs::Surd angle = exactDegrees(at(x)), complement = ifs::Surd(90) - angle;
                return placeOf(plainNumber(tangent(at(x).value), exactSine(angle) / exactSine(complement)));
            });
        DefineFun("asin", angle<std::asin>);
        DefineFun("acos", angle<std::acos>);
        DefineFun("atan", angle<std::atan>);
        DefineFun(
            "atan2",
            +[](double y, double x) { return placeOf(inRadians(std::atan2(at(y).value, at(x).value))); });
        DefineFun("sinh", number<std::sinh>);
        DefineFun("cosh", number<std::cosh>);
        DefineFun("tanh", number<std::tanh>);
        DefineFun(
            "sqrt", +[](double x) {
                const Quantity q = at(x);
                const bool isPlain = q.degrees == 0 && q.radians == 0;
                return placeOf(
                    plainNumber(std::sqrt(q.value), isPlain ? ifs::Surd::root(q.exact) : ifs::Surd::none()));
            });
        DefineFun("cbrt", number<std::cbrt>);
        DefineFun("exp", number<std::exp>);
        DefineFun("ln", number<std::log>);
        DefineFun("log", number<std::log10>);
        DefineFun("log2", number<std::log2>);
        DefineFun(
            "abs", +[](double x) {
                const Quantity q = at(x);
                return placeOf({std::abs(q.value), std::abs(q.reading), q.degrees, q.radians,
                                q.exact.hasValue() && q.exact.sign() < 0 ? -q.exact : q.exact});
            });
        DefineFun(
            "min", +[](double x, double y) {
                return placeOf(together(at(x), at(y), [](double a, double b) { return std::min(a, b); }));
            });
        DefineFun(
            "max", +[](double x, double y) {
                return placeOf(together(at(x), at(y), [](double a, double b) { return std::max(a, b); }));
            });
    }
    void InitConst() override { // values are stored in `constants`
        DefineConst("pi", 0);
        DefineConst("e", 1);
        DefineConst("phi", 2);
    }
    void InitOprt() override {
        DefineOprt(
            "+", +[](double x, double y) { return placeOf(sum(at(x), at(y))); }, mu::prADD_SUB);
        DefineOprt(
            "-", +[](double x, double y) { return placeOf(difference(at(x), at(y))); }, mu::prADD_SUB);
        DefineOprt(
            "*", +[](double x, double y) { return placeOf(product(at(x), at(y))); }, mu::prMUL_DIV);
        DefineOprt(
            "/", +[](double x, double y) { return placeOf(quotient(at(x), at(y))); }, mu::prMUL_DIV);
        DefineOprt(
            "^", +[](double x, double y) { return placeOf(power(at(x), at(y))); }, mu::prPOW, mu::oaRIGHT);
        DefineInfixOprt(
            "-", +[](double x) {
                const Quantity q = at(x);
                return placeOf({-q.value, -q.reading, q.degrees, q.radians, -q.exact});
            });
        DefineInfixOprt(
            "+", +[](double x) { return x; });
        DefinePostfixOprt(
            "deg", +[](double x) {
                const Quantity q = at(x);
                if (isInRadians(q)) return placeOf({q.value * degree, q.reading, 0, q.radians});
                return placeOf({q.value * degree, q.reading, 1, q.radians,
                                q.degrees == 0 ? q.exact : ifs::Surd::none()});
            });
    }
    void Init() {
        EnableBuiltInOprt(false); // before functions of the same names are defined
        InitCharSets();
        InitFun();
        InitConst();
        InitOprt();
        AddValIdent(isNumber);
        EnableOptimizer(false);
    }

private:
    // Reads an unsigned decimal number, as in files.
    static int isNumber(const char* text, int* position, double* value) {
        const std::string_view rest(text);
        if (rest.empty() || !(rest[0] == '.' || (rest[0] >= '0' && rest[0] <= '9'))) return 0;
        const auto result = fromChars(rest.data(), rest.data() + rest.size(), *value);
        if (result.ec != std::errc()) return 0;
        *position += int(result.ptr - rest.data());
        const auto length = std::size_t(result.ptr - rest.data());
        *value = placeOf(plainNumber(*value, ifs::Surd::decimal(rest.substr(0, length))));
        return 1;
    }
};

// Signs that stand for words and operators of the parser.
struct Sign {
    std::string_view sign; // UTF-8
    std::string_view plain;
    bool isFactor = false; // true: multiplies a preceding number, as in 2π
};
constexpr std::array signs{Sign{"−", "-"},           Sign{"·", "*"},          Sign{"×", "*"},
                           Sign{"÷", "/"},           Sign{"⁄", "/"},          Sign{"π", " pi ", true},
                           Sign{"φ", " phi ", true}, Sign{"√", "sqrt", true}, Sign{"°", " deg "},
                           Sign{"º", " deg "}, // ordinal indicator, on Spanish keyboards
                           Sign{"˚", " deg "}, // ring above
                           Sign{"²", "^2"},          Sign{"³", "^3"},         Sign{"½", "(1/2)"}};

bool isLetterOrDigit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// In the letters and signs of the parser; empty where there is any other.
std::string plain(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto sign =
            std::ranges::find_if(signs, [&](const Sign& known) { return text.starts_with(known.sign); });
        if (sign != signs.end()) {
            const char last = result.empty() ? ' ' : result.back();
            if (sign->isFactor && ((last >= '0' && last <= '9') || last == ')')) result += '*';
            result += sign->plain;
            text.remove_prefix(sign->sign.size());
            if (sign->plain != "sqrt") continue;
            const std::string_view under = // denominator, as in √3/2
                text.substr(0, std::min(text.size(), text.find_first_not_of("0123456789.")));
            if (!under.empty()) result += '(' + std::string(under) + ')';
            text.remove_prefix(under.size());
            continue;
        }
        const char c = text.front();
        if (!isLetterOrDigit(c) && std::string_view("+-*/^()., ").find(c) == std::string_view::npos)
            return {};
        result += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
        text.remove_prefix(1);
    }
    return result;
}

// Characters, of which those beyond ASCII have more than one byte.
std::size_t countCharacters(std::string_view text) {
    return std::size_t(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

// Whether each bracket has its other half, and no operator is alone at the end. The parser would throw, which
// takes microseconds for each cell of a large file.
bool isWhole(std::string_view text) {
    std::ptrdiff_t open = 0;
    for (std::size_t i = 0; i < text.size() && open >= 0; ++i)
        open += (text[i] == '(') - (text[i] == ')');
    const auto last = text.find_last_not_of(" \t");
    return open == 0 && last != text.npos && std::string_view("+-*/^(,").find(text[last]) == text.npos;
}

// Whether all its words are known and there is something to work out: anything else is no matter for the
// parser.
bool isPossible(std::string_view text) {
    if (!isWhole(text)) return false;
    bool hasValue = false;
    for (std::size_t i = 0; i < text.size();) {
        const bool isDigit = text[i] >= '0' && text[i] <= '9';
        hasValue = hasValue || isDigit;
        if (text[i] < 'a' || text[i] > 'z') {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < text.size() &&
               ((text[end] >= 'a' && text[end] <= 'z') || (text[end] >= '0' && text[end] <= '9')))
            ++end;
        const std::string_view word = text.substr(i, end - i);
        const bool isExponent =
            word[0] == 'e' && i > 0 && ((text[i - 1] >= '0' && text[i - 1] <= '9') || text[i - 1] == '.');
        if (!isExponent && std::ranges::find(names, word) == names.end()) return false;
        hasValue = hasValue || word == "pi" || word == "phi";
        i = end;
    }
    return hasValue;
}

// nullopt where it is no whole expression; else its value, which may not be finite.
std::optional<Quantity> quantityOf(std::string_view text) {
    if (countCharacters(text) > maxExpression) return std::nullopt;
    const std::string expression = plain(text);
    if (!isPossible(expression)) return std::nullopt;
    quantities.assign(constants.begin(), constants.end());
    try {
        thread_local Parser parser;
        parser.SetExpr(expression);
        int results = 0;
        const double* places = parser.Eval(results);
        return results == 1 ? std::optional(at(places[0])) : std::nullopt;
    } catch (const mu::ParserError&) {
        return std::nullopt;
    }
}

} // namespace

std::optional<double> evaluate(std::string_view text) {
    return evaluate(text, NumberUnit::None);
}

std::optional<double> evaluate(std::string_view text, NumberUnit unit) {
    if (const auto number = parseNumber(text)) return number;
    const std::optional<Quantity> quantity = quantityOf(text);
    if (!quantity) return std::nullopt;
    const double value = unit == NumberUnit::Degrees ? inDegrees(*quantity) : quantity->value;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<ifs::Surd> evaluateExactly(std::string_view text) {
    if (parseNumber(text)) return std::nullopt;
    const std::optional<Quantity> quantity = quantityOf(text);
    const bool isPlain = quantity && quantity->degrees == 0 && quantity->radians == 0;
    return isPlain && quantity->exact.hasValue() ? std::optional(quantity->exact) : std::nullopt;
}

bool isAngle(std::string_view text) {
    const std::optional<Quantity> quantity = quantityOf(text);
    return quantity && (quantity->degrees > 0 || isInRadians(*quantity));
}

bool isWithoutValue(std::string_view text) {
    const std::optional<Quantity> quantity = quantityOf(text);
    return quantity && !std::isfinite(quantity->value);
}

} // namespace notation
