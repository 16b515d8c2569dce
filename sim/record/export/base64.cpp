#include "sim/record/export/base64.hpp"

#include <cstdint>

namespace sandglass {

std::string base64(std::string_view bytes) {
  constexpr char alphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t begin = 0; begin < bytes.size(); begin += 3) {
    const std::string_view group = bytes.substr(begin, 3);
    std::uint32_t bits = 0;
    for (std::size_t index = 0; index < 3; ++index)
      bits = bits << 8 | (index < group.size() ? static_cast<unsigned char>(group[index]) : 0u);
    for (std::size_t index = 0; index < 4; ++index)
      text += index <= group.size() ? alphabet[bits >> (18 - 6 * index) & 63u] : '=';
  }
  return text;
}

}  // namespace sandglass
