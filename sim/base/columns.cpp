#include "sim/base/columns.hpp"

#include "sim/base/error.hpp"

#include <algorithm>

namespace sandglass {

Numbers make_numbers(Number number, std::size_t count, double value) {
  if (number == Number::byte) return std::vector<std::uint8_t>(count, static_cast<std::uint8_t>(value));
  if (number == Number::whole) return std::vector<std::uint64_t>(count, static_cast<std::uint64_t>(value));
  return std::vector<double>(count, value);
}

std::size_t NamedColumn::particles() const {
  return std::visit([](const auto& values) { return values.size(); }, numbers) / info.components;
}

const void* NamedColumn::data() const {
  return std::visit([](const auto& values) -> const void* { return values.data(); }, numbers);
}

NamedColumn pick(const ColumnView& column, std::span<const std::uint32_t> places) {
  const std::size_t components = column.info.components;
  NamedColumn picked{column.info, make_numbers(column.info.number, places.size() * components, 0)};
  std::visit(
      [&]<class T>(std::vector<T>& values) {
        const T* numbers = static_cast<const T*>(column.numbers);
        for (std::size_t i = 0; i < places.size(); ++i)
          std::copy_n(numbers + places[i] * components, components,
                      values.begin() + static_cast<std::ptrdiff_t>(i * components));
      },
      picked.numbers);
  return picked;
}

const NamedColumn* Columns::find(const ColumnInfo& info) const {
  const auto found = std::ranges::find(list_, info.name, [](const auto& entry) { return entry.info.name; });
  if (found == list_.end()) return nullptr;
  if (!found->info.fits(info))
    throw InputError("the particle column '" + info.name +
                     "' holds another type or number of components than its declaration says");
  return &*found;
}

void Columns::set(NamedColumn column) {
  remove(column.info.name);
  list_.push_back(std::move(column));
}

void Columns::set(const ColumnView& view) {
  remove(view.info.name);
  append(view);
}

void Columns::append(const ColumnView& view) {
  if (find(view.info) == nullptr) list_.push_back({view.info, make_numbers(view.info.number, 0, 0)});
  const auto place =
      std::ranges::find(list_, view.info.name, [](const auto& entry) { return entry.info.name; });
  std::visit(
      [&view]<class T>(std::vector<T>& values) {
        const T* begin = static_cast<const T*>(view.numbers);
        values.insert(values.end(), begin, begin + view.particles * view.info.components);
      },
      place->numbers);
}

void Columns::remove(const std::string& name) {
  std::erase_if(list_, [&name](const NamedColumn& entry) { return entry.info.name == name; });
}

}  // namespace sandglass
