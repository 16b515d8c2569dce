#include "sim/base/columns.hpp"

#include "sim/base/error.hpp"
#include "sim/base/particle_columns.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace sandglass::columns_test {
namespace {

TEST(Columns, ValuesComeBackByTheirDeclaration) {
  Columns columns;
  EXPECT_FALSE(columns.has(column::id));
  EXPECT_TRUE(columns.get(column::id).empty());
  const std::vector<std::uint64_t> ids{7, std::uint64_t{1} << 63, 0};
  columns.set(column::id, ids);
  for (double turn : {0.25, -3.0, 1e-300}) columns.append(column::spin<3>, Spin<3>(turn, 2 * turn, 0));
  EXPECT_TRUE(std::ranges::equal(columns.get(column::id), ids));
  EXPECT_EQ(columns.get(column::spin<3>)[1], Spin<3>(-3, -6, 0));
  columns.edit(column::spin<3>)[1][2] = 5;
  EXPECT_EQ(columns.get(column::spin<3>)[1], Spin<3>(-3, -6, 5));
  columns.set(column::id, std::vector<std::uint64_t>{1});
  EXPECT_EQ(columns.get(column::id).size(), 1u);
  columns.remove("id");
  EXPECT_FALSE(columns.has(column::id));
  EXPECT_EQ(columns.all().size(), 1u);
}

TEST(Columns, AnotherTypeUnderTheSameNameIsRefused) {
  Columns columns;
  columns.append(column::spin<3>, Spin<3>(1, 2, 3));
  EXPECT_THROW(columns.get(column::spin<2>), InputError);
  EXPECT_THROW(columns.append(column::spin<2>, Spin<2>(1)), InputError);
}

TEST(Columns, ArePickedByPlace) {
  Columns columns;
  for (double turn : {1.0, 2.0, 3.0}) columns.append(column::spin<3>, Spin<3>(turn, 10 * turn, 0));
  const std::vector<std::uint32_t> places{2, 0, 2};
  Columns picked;
  picked.set(pick(columns.all()[0].view(), places));
  const auto spins = picked.get(column::spin<3>);
  ASSERT_EQ(spins.size(), 3u);
  EXPECT_EQ(spins[0], Spin<3>(3, 30, 0));
  EXPECT_EQ(spins[1], Spin<3>(1, 10, 0));
  EXPECT_EQ(spins[2], spins[0]);
}

TEST(ColumnViews, AnEmptyColumnIsAbsent) {
  ColumnViews views;
  const std::vector<double> weights{1, 2};
  views.add(column::weight, weights);
  views.add(column::id, {});
  EXPECT_EQ(views.get(column::weight)[1], 2);
  EXPECT_TRUE(views.get(column::id).empty());
  EXPECT_EQ(std::distance(views.begin(), views.end()), 1);
}

}  // namespace
}  // namespace sandglass::columns_test
