#include "sim/space/stored_column.hpp"

#include "sim/base/error.hpp"

#include <algorithm>
#include <array>

namespace sandglass {

namespace {

template <class T>
class StoredColumnOf final : public StoredColumn {
 public:
  StoredColumnOf(ColumnInfo info, const T& initial) : info_(std::move(info)), initial_(initial) {}

  ColumnView view() const override { return {info_, values_.data(), values_.size()}; }
  void resize(std::size_t particles) override {
    values_.resize(particles, initial_);
    next_.resize(particles);
  }
  void shrink(std::size_t room) override {
    sandglass::shrink(values_, room);
    sandglass::shrink(next_, room);
  }
  void rotate(std::size_t first, std::size_t middle, std::size_t last) override {
    sandglass::rotate(values_, first, middle, last);
  }
  void write(std::size_t first, const ColumnView& values) override {
    const T* source = static_cast<const T*>(values.numbers);
    std::copy(source, source + values.particles, values_.begin() + static_cast<std::ptrdiff_t>(first));
  }
  void sort(const Column<CellPlace>& places, const std::uint32_t* begin) override {
    scatter(values_, places, begin, next_);
    values_.swap(next_);
  }
  std::size_t bytes() const override { return (values_.capacity() + next_.capacity()) * sizeof(T); }

 private:
  ColumnInfo info_;
  T initial_;
  Column<T> values_, next_;
};

template <class Scalar, std::size_t K>
std::unique_ptr<StoredColumn> make_vectors(const ColumnInfo& info) {
  std::array<Scalar, K> initial;
  initial.fill(static_cast<Scalar>(info.initial));
  return std::make_unique<StoredColumnOf<std::array<Scalar, K>>>(info, initial);
}

template <class Scalar>
std::unique_ptr<StoredColumn> make(const ColumnInfo& info) {
  switch (info.components) {
    case 1:
      return std::make_unique<StoredColumnOf<Scalar>>(info, static_cast<Scalar>(info.initial));
    case 2:
      return make_vectors<Scalar, 2>(info);
    case 3:
      return make_vectors<Scalar, 3>(info);
  }
  throw InputError("the particle column '" + info.name + "' has " + std::to_string(info.components) +
                   " components; a store keeps 1, 2 or 3");
}

}  // namespace

std::unique_ptr<StoredColumn> make_stored_column(const ColumnInfo& info) {
  switch (info.number) {
    case Number::byte:
      return make<std::uint8_t>(info);
    case Number::whole:
      return make<std::uint64_t>(info);
    case Number::real:
      break;
  }
  return make<double>(info);
}

}  // namespace sandglass
