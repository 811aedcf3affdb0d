// SPDX-License-Identifier: MIT
#include "io/text/expression.h"

#include "io/text/number.h"

#include <QString>

#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

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

// A number on the way through an expression.
struct Quantity {
    double value = 0;   // as everywhere: angles in radians
    double reading = 0; // without units: 90 for 90°, π/2 for pi/2
    double degrees = 0; // how often ° is a factor, minus how often a divisor
    double radians = 0; // the same of π and of inverse functions
};

Quantity plainNumber(double value) {
    return {value, value};
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

Quantity product(const Quantity& a, const Quantity& b) {
    return {a.value * b.value, a.reading * b.reading, a.degrees + b.degrees, a.radians + b.radians};
}

Quantity quotient(const Quantity& a, const Quantity& b) {
    return {a.value / b.value, a.reading / b.reading, a.degrees - b.degrees, a.radians - b.radians};
}

Quantity power(const Quantity& base, const Quantity& exponent) {
    return {std::pow(base.value, exponent.value), std::pow(base.reading, exponent.value),
            base.degrees * exponent.value, base.radians * exponent.value};
}

// The parser knows doubles only: those that it is given, and that it gives its operators, are places in here.
thread_local std::vector<Quantity> quantities;
const std::array constants{inRadians(std::numbers::pi), plainNumber(std::numbers::e),
                           plainNumber(std::numbers::phi)};

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
        DefineFun("sin", number<sine>);
        DefineFun("cos", number<cosine>);
        DefineFun("tan", number<tangent>);
        DefineFun("asin", angle<std::asin>);
        DefineFun("acos", angle<std::acos>);
        DefineFun("atan", angle<std::atan>);
        DefineFun(
            "atan2",
            +[](double y, double x) { return placeOf(inRadians(std::atan2(at(y).value, at(x).value))); });
        DefineFun("sinh", number<std::sinh>);
        DefineFun("cosh", number<std::cosh>);
        DefineFun("tanh", number<std::tanh>);
        DefineFun("sqrt", number<std::sqrt>);
        DefineFun("cbrt", number<std::cbrt>);
        DefineFun("exp", number<std::exp>);
        DefineFun("ln", number<std::log>);
        DefineFun("log", number<std::log10>);
        DefineFun("log2", number<std::log2>);
        DefineFun(
            "abs", +[](double x) {
                const Quantity q = at(x);
                return placeOf({std::abs(q.value), std::abs(q.reading), q.degrees, q.radians});
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
    void InitConst() override { // places in `constants`
        DefineConst("pi", 0);
        DefineConst("e", 1);
        DefineConst("phi", 2);
    }
    void InitOprt() override {
        DefineOprt(
            "+", +[](double x, double y) { return placeOf(together(at(x), at(y), std::plus())); },
            mu::prADD_SUB);
        DefineOprt(
            "-", +[](double x, double y) { return placeOf(together(at(x), at(y), std::minus())); },
            mu::prADD_SUB);
        DefineOprt(
            "*", +[](double x, double y) { return placeOf(product(at(x), at(y))); }, mu::prMUL_DIV);
        DefineOprt(
            "/", +[](double x, double y) { return placeOf(quotient(at(x), at(y))); }, mu::prMUL_DIV);
        DefineOprt(
            "^", +[](double x, double y) { return placeOf(power(at(x), at(y))); }, mu::prPOW, mu::oaRIGHT);
        DefineInfixOprt(
            "-", +[](double x) {
                const Quantity q = at(x);
                return placeOf({-q.value, -q.reading, q.degrees, q.radians});
            });
        DefineInfixOprt(
            "+", +[](double x) { return x; });
        DefinePostfixOprt(
            "deg", +[](double x) {
                const Quantity q = at(x);
                return placeOf({q.value * degree, q.reading, isInRadians(q) ? 0.0 : 1.0, q.radians});
            });
    }
    void Init() {
        EnableBuiltInOprt(false); // before those of the same names are defined
        InitCharSets();
        InitFun();
        InitConst();
        InitOprt();
        AddValIdent(isNumber);
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
        *value = placeOf(plainNumber(*value));
        return 1;
    }
};

// In the letters and signs of the parser; empty where there is any other.
std::string plain(QStringView text) {
    static const std::array<std::pair<QChar, const char*>, 14> signs{
        {{u'−', "-"},
         {u'·', "*"},
         {u'×', "*"},
         {u'÷', "/"},
         {u'⁄', "/"},
         {u'π', " pi "},
         {u'φ', " phi "},
         {u'√', "sqrt"},
         {u'°', " deg "},
         {u'º', " deg "}, // of ordinals, on Spanish keyboards
         {u'˚', " deg "}, // a ring
         {u'²', "^2"},
         {u'³', "^3"},
         {u'½', "(1/2)"}}};
    std::string result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        const auto sign = std::ranges::find(signs, c, &std::pair<QChar, const char*>::first);
        if (sign != signs.end()) {
            const char last = result.empty() ? ' ' : result.back();
            const bool isFactor = c == u'π' || c == u'φ' || c == u'√';
            if (isFactor && ((last >= '0' && last <= '9') || last == ')')) result += '*'; // as in 2π
            result += sign->second;
            if (c != u'√') continue;
            qsizetype end = i + 1; // of the number under it, as in √3/2
            while (end < text.size() && ((text[end] >= u'0' && text[end] <= u'9') || text[end] == u'.'))
                ++end;
            if (end == i + 1) continue;
            result += '(' + text.sliced(i + 1, end - i - 1).toLatin1().toStdString() + ')';
            i = end - 1;
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
std::optional<Quantity> quantityOf(QStringView text) {
    if (text.size() > maxExpression) return std::nullopt;
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

std::optional<double> evaluate(QStringView text) {
    return evaluate(text, NumberUnit::None);
}

std::optional<double> evaluate(QStringView text, NumberUnit unit) {
    if (const auto number = parseNumber(text)) return number;
    const std::optional<Quantity> quantity = quantityOf(text);
    if (!quantity) return std::nullopt;
    const double value = unit == NumberUnit::Degrees ? inDegrees(*quantity) : quantity->value;
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool isAngle(QStringView text) {
    const std::optional<Quantity> quantity = quantityOf(text);
    return quantity && (quantity->degrees > 0 || isInRadians(*quantity));
}

bool isWithoutValue(QStringView text) {
    const std::optional<Quantity> quantity = quantityOf(text);
    return quantity && !std::isfinite(quantity->value);
}

} // namespace io
