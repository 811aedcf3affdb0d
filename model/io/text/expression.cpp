// SPDX-License-Identifier: MIT
#include "io/text/expression.h"

#include "io/text/number.h"

#include <QString>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

namespace io {

namespace {

constexpr double degree = std::numbers::pi / 180;

// Of what is a whole number of degrees but for rounding: as many degrees.
double wholeDegrees(double radians) {
    const double degrees = radians / degree;
    const double whole = std::nearbyint(degrees);
    return std::abs(degrees - whole) <= 1e-13 * std::max(1.0, std::abs(degrees)) ? whole : NAN;
}

double sine(double x) {
    const double degrees = std::abs(std::remainder(wholeDegrees(x), 180)); // up to 90
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
        DefineFun("sin", sine);
        DefineFun("cos", cosine);
        DefineFun("tan", tangent);
        DefineFun(
            "asin", +[](double x) { return std::asin(x); });
        DefineFun(
            "acos", +[](double x) { return std::acos(x); });
        DefineFun(
            "atan", +[](double x) { return std::atan(x); });
        DefineFun(
            "atan2", +[](double y, double x) { return std::atan2(y, x); });
        DefineFun(
            "sinh", +[](double x) { return std::sinh(x); });
        DefineFun(
            "cosh", +[](double x) { return std::cosh(x); });
        DefineFun(
            "tanh", +[](double x) { return std::tanh(x); });
        DefineFun(
            "sqrt", +[](double x) { return std::sqrt(x); });
        DefineFun(
            "cbrt", +[](double x) { return std::cbrt(x); });
        DefineFun(
            "exp", +[](double x) { return std::exp(x); });
        DefineFun(
            "ln", +[](double x) { return std::log(x); });
        DefineFun(
            "log", +[](double x) { return std::log10(x); });
        DefineFun(
            "log2", +[](double x) { return std::log2(x); });
        DefineFun(
            "abs", +[](double x) { return std::abs(x); });
        DefineFun(
            "min", +[](double x, double y) { return std::min(x, y); });
        DefineFun(
            "max", +[](double x, double y) { return std::max(x, y); });
    }
    void InitConst() override {
        DefineConst("pi", std::numbers::pi);
        DefineConst("e", std::numbers::e);
        DefineConst("phi", std::numbers::phi);
    }
    void InitOprt() override {
        DefineInfixOprt(
            "-", +[](double x) { return -x; });
        DefineInfixOprt(
            "+", +[](double x) { return x; });
        DefinePostfixOprt(
            "deg", +[](double x) { return x * degree; });
    }
    void Init() {
        InitCharSets();
        InitFun();
        InitConst();
        InitOprt();
        AddValIdent(isNumber);
        EnableBuiltInOprt(true);
        EnableOptimizer(false);
    }

private:
    // A decimal number without a sign, as in files.
    static int isNumber(const char* text, int* position, double* value) {
        const std::string_view rest(text);
        if (rest.empty() || !(rest[0] == '.' || (rest[0] >= '0' && rest[0] <= '9'))) return 0;
        const auto result = fromChars(rest.data(), rest.data() + rest.size(), *value);
        if (result.ec != std::errc()) return 0;
        *position += int(result.ptr - rest.data());
        return 1;
    }
};

// In the letters and signs of the parser; empty where there is any other.
std::string plain(QStringView text) {
    static const std::array<std::pair<QChar, const char*>, 12> signs{{{u'−', "-"},
                                                                      {u'·', "*"},
                                                                      {u'×', "*"},
                                                                      {u'÷', "/"},
                                                                      {u'⁄', "/"},
                                                                      {u'π', " pi "},
                                                                      {u'φ', " phi "},
                                                                      {u'√', "sqrt"},
                                                                      {u'°', " deg "},
                                                                      {u'²', "^2"},
                                                                      {u'³', "^3"},
                                                                      {u'½', "(1/2)"}}};
    std::string result;
    for (const QChar c : text) {
        const auto sign = std::ranges::find(signs, c, &std::pair<QChar, const char*>::first);
        if (sign != signs.end()) {
            const char last = result.empty() ? ' ' : result.back();
            const bool isFactor = c == u'π' || c == u'φ' || c == u'√';
            if (isFactor && ((last >= '0' && last <= '9') || last == ')')) result += '*'; // as in 2π
            result += sign->second;
        } else if (c.unicode() < 128 && (c.isLetterOrNumber() || QStringView(u"+-*/^()., ").contains(c))) {
            result += c.toLower().toLatin1();
        } else {
            return {};
        }
    }
    return result;
}

// Whether all its words are known and there is something to work out: anything else is no matter for the
// parser.
bool isPossible(std::string_view text) {
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
std::optional<double> valueOf(QStringView text) {
    if (text.size() > maxExpression) return std::nullopt;
    const std::string expression = plain(text);
    if (!isPossible(expression)) return std::nullopt;
    try {
        thread_local Parser parser;
        parser.SetExpr(expression);
        int results = 0;
        const double* values = parser.Eval(results);
        return results == 1 ? std::optional(values[0]) : std::nullopt;
    } catch (const mu::ParserError&) {
        return std::nullopt;
    }
}

} // namespace

std::optional<double> evaluate(QStringView text) {
    if (const auto number = parseNumber(text)) return number;
    const std::optional<double> value = valueOf(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

bool isWithoutValue(QStringView text) {
    const std::optional<double> value = valueOf(text);
    return value && !std::isfinite(*value);
}

} // namespace io
