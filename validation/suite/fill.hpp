#pragma once

#include "sim/scene/text/document.hpp"

#include <functional>
#include <string>
#include <vector>

namespace sandglass {

/// The names in braces of a text, in their order.
std::vector<std::string> names_in_braces(const std::string& text);

/// The value that a name stands for; `user` is the text that holds it. Null leaves it out.
using ValueOf = std::function<const Node*(const std::string& name, const Node& user)>;

/// The node with every name in braces replaced: a text that is one of them becomes the value itself.
Node filled(const Node& node, const ValueOf& value_of);

}  // namespace sandglass
