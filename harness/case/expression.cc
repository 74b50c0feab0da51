#include "case/expression.h"

#include <algorithm>

#include "base/check.h"
#include "case/expression_node.h"
#include "case/suggestion.h"
#include "numeric/number_text.h"

namespace etalon {
namespace {

using Node = Expression::Node;
using Shape = Builtin::Shape;
using NodePointer = std::shared_ptr<Node>;

std::string Plural(unsigned count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

void CollectNames(const Node& node, std::vector<std::string>& names) {
    if (node.kind == Node::Kind::kSymbol && FindConstant(node.name) == nullptr &&
        std::find(names.begin(), names.end(), node.name) == names.end()) {
        names.push_back(node.name);
    }
    for (const NodePointer& child : node.children) {
        CollectNames(*child, names);
    }
}

// Resolves one node whose children are bound already.
class Binder {
  public:
    explicit Binder(std::span<const Symbol> symbols) : symbols_(symbols) {}

    Result<NodePointer> Bind(const Node& unbound) {
        auto node = std::make_shared<Node>(unbound);
        for (NodePointer& child : node->children) {
            ETALON_TRY(bound, Bind(*child));
            child = bound;
        }
        switch (node->kind) {
            case Node::Kind::kConstant:
                node->components = 1;
                break;
            case Node::Kind::kSymbol:
                ETALON_TRY_STEP(BindSymbol(*node));
                break;
            case Node::Kind::kSelect:
                ETALON_TRY_STEP(BindSelect(*node));
                break;
            case Node::Kind::kOracle:
                ETALON_TRY_STEP(BindOracle(*node));
                break;
            case Node::Kind::kBuiltin:
                ETALON_TRY_STEP(BindBuiltin(*node));
                break;
        }
        return node;
    }

  private:
    Status<> BindSymbol(Node& node) const {
        unsigned column = 0;
        std::vector<std::string_view> known;
        for (const Symbol& symbol : symbols_) {
            if (symbol.name == node.name) {
                node.first_column = column;
                node.components = symbol.components;
                return Ok();
            }
            column += symbol.components;
            known.push_back(symbol.name);
        }
        if (const Bounded* constant = FindConstant(node.name)) {
            node.kind = Node::Kind::kConstant;
            node.constant = *constant;
            node.components = 1;
            return Ok();
        }
        return At(node.place, "'" + node.name + "' is no input" + Suggestion(node.name, known));
    }

    static Status<> BindSelect(Node& node) {
        const unsigned size = node.children[0]->components;
        const std::string& selection = node.selection;
        if (selection[0] >= '0' && selection[0] <= '9') {
            node.selected = {static_cast<unsigned>(std::stoul(selection))};
        } else {
            node.selected.clear();
            for (const char letter : selection) {
                const std::size_t place = std::string_view("xyzwrgba").find(letter);
                if (place == std::string_view::npos || size > 4) {
                    return At(node.place, "'." + selection + "' names no components");
                }
                node.selected.push_back(static_cast<unsigned>(place % 4));
            }
        }
        for (const unsigned component : node.selected) {
            if (component >= size || node.selected.size() > 4) {
                return At(node.place, "'" + selection + "' does not fit a value of " +
                                          Plural(size, "component"));
            }
        }
        node.components = static_cast<unsigned>(node.selected.size());
        return Ok();
    }

    static Status<> BindOracle(Node& node) {
        node.oracle = oracle::FindFunction(node.name);
        if (node.oracle == nullptr) {
            std::vector<std::string_view> known;
            for (const oracle::Function& function : oracle::Functions()) {
                known.push_back(function.name);
            }
            return At(node.place,
                      "there is no oracle '" + node.name + "'" + Suggestion(node.name, known));
        }
        const auto& parameters = node.oracle->parameters;
        if (parameters.size() != node.children.size()) {
            return At(node.place, "'" + node.name + "' takes " +
                                      Plural(static_cast<unsigned>(parameters.size()), "argument") +
                                      ", not " + std::to_string(node.children.size()));
        }
        for (std::size_t k = 0; k < parameters.size(); ++k) {
            const Node& argument = *node.children[k];
            if (argument.components != parameters[k].components) {
                return At(argument.place, "'" + node.name + "' takes " +
                                              Plural(parameters[k].components, "component") +
                                              " for '" + std::string(parameters[k].name) +
                                              "', not " + std::to_string(argument.components));
            }
        }
        node.components = node.oracle->components;
        return Ok();
    }

    static Status<> BindBuiltin(Node& node) {
        node.builtin = FindBuiltin(node.name, node.children.size());
        if (node.builtin == nullptr) {
            const auto others = BuiltinsNamed(node.name);
            if (others.empty()) {
                return At(node.place, "there is no function '" + node.name + "'" +
                                          Suggestion(node.name, FunctionNames()));
            }
            return At(node.place, "'" + node.name + "' takes " +
                                      Plural(others.front()->arguments, "argument") + ", not " +
                                      std::to_string(node.children.size()));
        }
        if (node.builtin->shape == Shape::kJoin) {
            return BindConstructor(node);
        }
        unsigned size = 1;
        for (const NodePointer& child : node.children) {
            size = std::max(size, child->components);
        }
        for (const NodePointer& child : node.children) {
            const bool spreads = node.builtin->shape == Shape::kEach && child->components == 1;
            if (child->components != size && !spreads) {
                return At(node.place, "'" + node.name + "' cannot join values of " +
                                          std::to_string(child->components) + " and " +
                                          Plural(size, "component"));
            }
        }
        if (node.builtin->shape == Shape::kThree && size != 3) {
            return At(node.place, "'" + node.name + "' takes vectors of 3 components");
        }
        node.components = node.builtin->shape == Shape::kScalar ? 1 : size;
        return Ok();
    }

    static Status<> BindConstructor(Node& node) {
        unsigned given = 0;
        for (const NodePointer& child : node.children) {
            given += child->components;
        }
        node.components = node.builtin->joined;
        const bool spreads = node.children.size() == 1 && given == 1;
        if (given != node.components && !spreads) {
            return At(node.place, "'" + node.name + "' takes " +
                                      Plural(node.components, "component") + ", not " +
                                      std::to_string(given));
        }
        return Ok();
    }

    std::span<const Symbol> symbols_;
};

}  // namespace

Result<Expression> Expression::Parse(std::string_view text) {
    ETALON_TRY(root, ParseExpression(text));
    Expression expression;
    expression.root_ = root;
    expression.text_ = text;
    return expression;
}

Expression Expression::Constant(double value) {
    auto root = std::make_shared<Node>();
    root->constant.value = value;
    root->components = 1;
    Expression expression;
    expression.root_ = std::move(root);
    expression.text_ = Shortest(value);
    return expression;
}

const std::string& Expression::text() const {
    return text_;
}

std::vector<std::string> Expression::Names() const {
    std::vector<std::string> names;
    if (root_ != nullptr) {
        CollectNames(*root_, names);
    }
    return names;
}

Result<unsigned> Expression::Bind(std::span<const Symbol> symbols) {
    ETALON_CHECK(root_ != nullptr);
    ETALON_TRY(bound, Binder(symbols).Bind(*root_));
    root_ = bound;
    return root_->components;
}

}  // namespace etalon
