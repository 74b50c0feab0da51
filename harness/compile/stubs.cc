#include "compile/stubs.h"

#include <map>
#include <set>

#include "compile/types.h"

namespace etalon {
namespace {

// The GLSL name of a type that a function may have; empty where there is none.
std::string Spelled(const glslang::TType& type) {
    if (type.getBasicType() == glslang::EbtSampler && !type.isArray()) {
        return type.getSampler().getString().c_str();
    }
    const Result<Type> known = FromGlslang(type);
    return known ? TypeText(*known) : "";
}

class Functions : public glslang::TIntermTraverser {
  public:
    bool visitAggregate(glslang::TVisit, glslang::TIntermAggregate* node) override {
        const std::string name = node->getName().c_str();
        if (node->getOp() == glslang::EOpFunction) {
            defined_.insert(name);
        } else if (node->getOp() == glslang::EOpFunctionCall && node->isUserDefined()) {
            called_[name] = node;
        }
        return true;
    }

    std::string Stubs() const {
        std::string text;
        for (const auto& [mangled, call] : called_) {
            if (!defined_.contains(mangled)) {
                text += Stub(mangled.substr(0, mangled.find('(')), *call);
            }
        }
        return text;
    }

  private:
    static std::string Stub(const std::string& name, glslang::TIntermAggregate& call) {
        const std::string type = Spelled(call.getType());
        std::string parameters;
        for (std::size_t i = 0; i < call.getSequence().size(); ++i) {
            const glslang::TIntermTyped* argument = call.getSequence()[i]->getAsTyped();
            const std::string spelled = Spelled(argument->getType());
            if (spelled.empty()) {
                return "";
            }
            const auto direction = call.getQualifierList()[i];
            parameters += (i == 0 ? "" : ", ") +
                          std::string(direction == glslang::EvqOut     ? "out "
                                      : direction == glslang::EvqInOut ? "inout "
                                                                       : "") +
                          spelled + " etalon_p" + std::to_string(i);
        }
        const std::string body = type == "void" ? "" : type + " etalon_stub; return etalon_stub; ";
        return type.empty() ? "" : type + " " + name + "(" + parameters + ") { " + body + "}\n";
    }

    std::set<std::string> defined_;
    std::map<std::string, glslang::TIntermAggregate*> called_;
};

}  // namespace

std::string StubsFor(const glslang::TIntermediate& tree) {
    Functions functions;
    if (tree.getTreeRoot() != nullptr) {
        tree.getTreeRoot()->traverse(&functions);
    }
    return functions.Stubs();
}

}  // namespace etalon
