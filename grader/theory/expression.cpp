#include "theory/expression.h"

#include "text.h"
#include "theory/functions.h"
#include "theory/tokens.h"

#include <fmt/format.h>

namespace testat::theory {
namespace {
constexpr double pi = 3.14159265358979323846;

/// A recursive descent that appends steps, operands before operators.
class Parser {
public:
    Parser(std::string_view text, Angles angles) : tokens_(tokens_of(text)), angles_(angles) {}

    std::vector<Expression::Step> parse()
    {
        sum();
        if (token().kind != Token::Kind::end)
            throw refused_at(token().place, {fmt::format("vor „{}“ fehlt ein Rechenzeichen", shown()),
                                             fmt::format("an operator is missing before '{}'", shown())});
        return std::move(steps_);
    }

private:
    Token const& token() const { return tokens_[position_]; }
    std::string shown() const
    {
        return token().kind == Token::Kind::number ? fmt::format("{}", token().number) : one_line(token().text, 40);
    }
    bool is(char const* sign) const { return token().kind == Token::Kind::sign && token().text == sign; }

    bool take(char const* sign)
    {
        if (!is(sign))
            return false;
        ++position_;
        return true;
    }

    void expect(char const* sign)
    {
        if (!take(sign))
            throw refused_at(token().place,
                             {fmt::format("hier fehlt „{}“", sign), fmt::format("'{}' is missing here", sign)});
    }

    void append(Expression::Operation operation, int arity) { steps_.push_back({operation, arity, {}, {}}); }
    void append(double constant) { steps_.push_back({nullptr, 0, Value::number(constant), {}}); }

    void sum()
    {
        product();
        for (;;) {
            if (take("+"))
                product(), append(add, 2);
            else if (take("-"))
                product(), append(subtract, 2);
            else
                return;
        }
    }

    void product()
    {
        constexpr std::pair<char const*, Expression::Operation> operators[] = {
            {"*", multiply}, {"/", divide}, {"·", centre_dot}, {"×", cross_sign}};
        factor();
        for (bool again = true; again;) {
            again = false;
            for (auto const& [sign, operation] : operators)
                if (take(sign)) {
                    factor();
                    append(operation, 2);
                    again = true;
                }
        }
    }

    /// Signs and powers; all that is within something else passes here.
    void factor()
    {
        if (++depth_ > deepest_expression)
            throw refused_at(token().place, {"so tief darf eine Formel nicht verschachtelt sein",
                                             "a formula may not be nested as deeply as that"});
        if (take("-")) {
            factor();
            append(negate, 1);
        } else if (take("+")) {
            factor();
        } else {
            power_of_primary();
        }
        --depth_;
    }

    void power_of_primary()
    {
        primary();
        for (;;) {
            if (take("°")) {
                if (angles_ == Angles::radians)
                    append(degrees, 1);
            } else if (take(".")) {
                component();
            } else {
                break;
            }
        }
        if (take("^")) {
            factor();
            append(power, 2);
        }
    }

    void component()
    {
        auto const operation = find_component(token().text);
        if (token().kind != Token::Kind::name || operation == nullptr)
            throw refused_at(token().place,
                             {"nach dem Punkt steht x, y, z, u oder v", "behind the dot there is x, y, z, u or v"});
        ++position_;
        append(operation, 1);
    }

    void primary()
    {
        if (token().kind == Token::Kind::number) {
            append(token().number);
            ++position_;
        } else if (token().kind == Token::Kind::name) {
            name();
        } else if (take("(")) {
            sum();
            expect(")");
        } else if (take("|")) {
            sum();
            expect("|");
            append(length, 1);
        } else {
            throw refused_at(token().place, {"hier fehlt eine Zahl, ein Name oder eine Klammer",
                                             "a number, a name or a parenthesis is missing here"});
        }
    }

    void name()
    {
        Token const name = token();
        ++position_;
        if (is("("))
            call(name);
        else if (name.text == "pi")
            append(angles_ == Angles::radians ? pi : 180);
        else
            steps_.push_back({nullptr, 0, {}, name.text});
    }

    void call(Token const& name)
    {
        Function const function = find_function(name.text, angles_);
        std::string const shown = one_line(name.text, 40);
        if (function.apply == nullptr)
            throw refused_at(name.place, {fmt::format("eine Funktion „{}“ gibt es hier nicht", shown),
                                          fmt::format("there is no function '{}' here", shown)});
        expect("(");
        for (int i = 0; i < function.arity; ++i) {
            if (i > 0)
                expect(",");
            sum();
        }
        expect(")");
        append(function.apply, function.arity);
    }

    std::vector<Token> tokens_;
    Angles angles_;
    std::size_t position_ = 0;
    int depth_ = 0;
    std::vector<Expression::Step> steps_;
};

Value value_of(std::string const& name, Variables const& variables)
{
    auto const found = variables.find(name);
    if (found != variables.end())
        return found->second;
    std::string known;
    for (auto const& [other, value] : variables)
        known += (known.empty() ? "" : ", ") + other;
    std::string const shown = one_line(name, 40);
    if (known.empty())
        throw Refused{{fmt::format("Hier stehen nur Zahlen, keine Namen wie „{}“.", shown),
                       fmt::format("Only numbers stand here, no names such as '{}'.", shown)}};
    throw Refused{{fmt::format("Den Namen „{}“ gibt es hier nicht; es gibt {}.", shown, known),
                   fmt::format("There is no name '{}' here; there are {}.", shown, known)}};
}
}  // namespace

Expression::Expression(std::string_view text, Angles angles)
{
    if (text.size() > longest_expression)
        throw Refused{{fmt::format("Eine Formel darf höchstens {} Zeichen lang sein.", longest_expression),
                       fmt::format("A formula may have at most {} characters.", longest_expression)}};
    steps_ = Parser(text, angles).parse();
}

Value Expression::evaluate(Variables const& variables) const
{
    std::vector<Value> stack;
    for (Step const& step : steps_) {
        Value result = step.constant;
        if (step.apply != nullptr)
            result = step.apply(stack.data() + stack.size() - step.arity);
        else if (!step.variable.empty())
            result = value_of(step.variable, variables);
        stack.resize(stack.size() - std::size_t(step.arity));
        stack.push_back(result);
    }
    return stack.back();
}

std::vector<std::string> Expression::names() const
{
    std::vector<std::string> names;
    for (Step const& step : steps_)
        if (!step.variable.empty())
            names.push_back(step.variable);
    return names;
}
}  // namespace testat::theory
