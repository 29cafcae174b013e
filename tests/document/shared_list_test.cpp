// SPDX-License-Identifier: Apache-2.0
#include "document/shared_list.h"

#include <gtest/gtest.h>

#include <memory>

#include "base/rng.h"

namespace inkflate {
namespace {

using List = SharedList<std::shared_ptr<int const>>;

std::shared_ptr<int const> item(int value) { return std::make_shared<int const>(value); }

std::vector<int> values(List const& list) {
  std::vector<int> result;
  list.for_each([&](auto const& each) { result.push_back(*each); });
  return result;
}

TEST(SharedList, EmptyListHasNothing) {
  List const list;
  EXPECT_TRUE(list.is_empty());
  EXPECT_TRUE(values(list).empty());
  EXPECT_TRUE(List::of({}).is_empty());
  EXPECT_TRUE(List::of({}).is_same(list));
}

TEST(SharedList, ListOfAnyLengthGivesBackItsElements) {
  for (int const count : {1, 7, 8, 9, 63, 64, 65, 513, 1000}) {
    std::vector<std::shared_ptr<int const>> items;
    for (int i = 0; i < count; ++i) items.push_back(item(i));
    auto const list = List::of(items);
    ASSERT_EQ(list.size(), count);
    EXPECT_EQ(list.to_vector(), items);
    for (int i = 0; i < count; ++i) ASSERT_EQ(*list[i], i);
  }
}

TEST(SharedList, EveryVersionOfAGrowingListStaysAsItWas) {
  std::vector<List> versions = {List()};
  for (int i = 0; i < 600; ++i) versions.push_back(versions.back().with_pushed(item(i)));
  for (int size = 0; size <= 600; ++size) {
    auto const& version = versions[static_cast<std::size_t>(size)];
    ASSERT_EQ(version.size(), size);
    int next = 0;
    version.for_each([&](auto const& each) { ASSERT_EQ(*each, next++); });
    ASSERT_EQ(next, size);
  }
}

TEST(SharedList, RandomChangesAreThoseOfAVector) {
  Rng rng(7);
  List list;
  std::vector<int> model;
  for (int step = 0; step < 3000; ++step) {
    // It grows and shrinks by turns.
    int const growth = step / 500 % 2 == 0 ? 4 : 2;
    if (model.empty() || rng.below(3) == 0) {
      list = list.with_pushed(item(step));
      model.push_back(step);
    } else {
      int const index = rng.below(static_cast<int>(model.size()));
      std::vector<std::shared_ptr<int const>> items;
      for (int i = rng.below(growth); i > 0; --i) items.push_back(item(step * 10 + i));
      list = list.with_replaced(index, items);
      model.erase(model.begin() + index);
      for (std::size_t i = items.size(); i > 0; --i) {
        model.insert(model.begin() + index, *items[i - 1]);
      }
    }
    ASSERT_EQ(list.size(), static_cast<int>(model.size()));
    if (step % 50 == 0) {
      ASSERT_EQ(values(list), model);
    }
  }
  EXPECT_EQ(values(list), model);
}

TEST(SharedList, MoreThanANodeHoldsMayTakeThePlaceOfOne) {
  std::vector<std::shared_ptr<int const>> many;
  for (int i = 0; i < 100; ++i) many.push_back(item(i));
  auto const list = List::of({many.data(), 3}).with_replaced(1, many);
  EXPECT_EQ(list.size(), 102);
  EXPECT_EQ(*list[0], 0);
  EXPECT_EQ(*list[100], 99);
  EXPECT_EQ(*list[101], 2);
}

TEST(SharedList, RemovingAllLeavesTheEmptyList) {
  std::vector<std::shared_ptr<int const>> items(200, item(1));
  auto list = List::of(items);
  while (!list.is_empty()) list = list.with_replaced(list.size() / 2, {});
  EXPECT_TRUE(list.is_same(List()));
}

TEST(SharedList, ElementsGoWithTheLastListThatHoldsThem) {
  auto const element = item(5);
  {
    List list;
    std::vector<List> versions;
    for (int i = 0; i < 100; ++i) {
      list = list.with_pushed(element);
      versions.push_back(list);
    }
    auto const copy = versions.back();
    EXPECT_TRUE(copy.is_same(list));
    EXPECT_FALSE(copy.is_same(versions.front()));
  }
  EXPECT_EQ(element.use_count(), 1);
}

TEST(SharedList, ListOfAMillionElementsGoesWithoutDeepCalls) {
  std::vector<std::shared_ptr<int const>> const items(1'000'000, item(1));
  auto const list = List::of(items);
  EXPECT_EQ(*list[999'999], 1);
}

}  // namespace
}  // namespace inkflate
