// SPDX-License-Identifier: MIT
// TArray, TSparseArray, TSet, TMap, TQueue, and the type-erased containers over the same bytes.
#include "core_test.h"

#include "Containers/IndirectArray.h"
#include "Containers/Queue.h"
#include "Containers/StaticArray.h"

using namespace core_test;

namespace {
// Counts its living copies, so that tests see leaks and double destruction.
struct Counted {
    static int alive;
    int value = 0;
    Counted() { ++alive; }
    explicit Counted(int v) : value(v) { ++alive; }
    Counted(const Counted& other) : value(other.value) { ++alive; }
    Counted(Counted&& other) : value(other.value) { ++alive; }
    Counted& operator=(const Counted&) = default;
    ~Counted() { --alive; }
    bool operator==(const Counted& other) const { return value == other.value; }
    friend uint32 GetTypeHash(const Counted& c) { return static_cast<uint32>(c.value); }
};
int Counted::alive = 0;

template <typename T>
std::string join(const T& range) {
    std::string result;
    for (const auto& element : range) {
        result += (result.empty() ? "" : ",") + std::to_string(element);
    }
    return result;
}
} // namespace

TEST_CASE("Core: layouts that type-erased access relies on") {
    CHECK(sizeof(TArray<int32>) == 16);
    CHECK(sizeof(FScriptArray) == 16);
    CHECK(sizeof(FString) == 16);
    CHECK(sizeof(TSet<int32>) == 80);
    CHECK(sizeof(TMap<int32, int32>) == 80);
    CHECK(sizeof(TSparseArray<int32>) == 56);
    CHECK(sizeof(FVector) == 24);
    CHECK(sizeof(FQuat) == 32);
    CHECK(sizeof(FColor) == 4);
}

TEST_CASE("Core: TArray adds, inserts, removes") {
    TArray<int32> a = {3, 1, 2};
    CHECK(a.Add(7) == 3);
    a.Insert(9, 1);
    CHECK(join(a) == "3,9,1,2,7");
    a.RemoveAt(0);
    a.RemoveAtSwap(0);
    CHECK(join(a) == "7,1,2");
    CHECK(a.AddUnique(1) == 1);
    CHECK(a.Num() == 3);
    a.Append({1, 1});
    CHECK(a.Remove(1) == 3);
    CHECK(join(a) == "7,2");
    CHECK(a.Find(2) == 1);
    CHECK(a.Find(5) == INDEX_NONE);
    CHECK(a.Pop() == 2);
    CHECK(a.Last() == 7);
    a.SetNum(3);
    CHECK(join(a) == "7,0,0");
    CHECK(a.RemoveAll([](int32 x) { return x == 0; }) == 2);
    CHECK(a.RemoveSingle(8) == 0);
    a.Empty();
    CHECK(a.IsEmpty());
    CHECK(a.Max() == 0);
}

TEST_CASE("Core: TArray keeps an element that is added from itself") {
    TArray<FString> a;
    a.Add(TEXT("first"));
    for (int i = 0; i < 100; ++i) {
        a.Add(a[0]);
    }
    CHECK(text(a[100]) == "first");
    a.Insert(a[0], 0);
    CHECK(text(a[0]) == "first");
    a.Remove(a[0]);
    CHECK(a.Num() == 0);
}

TEST_CASE("Core: references to added elements are into the new memory") {
    TArray<int32> a;
    for (int32 i = 0; i < 200; i += 4) {
        a.Add_GetRef(-1) = i;
        a.AddDefaulted_GetRef() = i + 1;
        a.AddZeroed_GetRef() = i + 2;
        a.Emplace_GetRef(-1) = i + 3;
    }
    bool all = true;
    for (int32 i = 0; i < 200; ++i) {
        all = all && a[i] == i;
    }
    CHECK(all);
}

TEST_CASE("Core: TArray destroys exactly what it made") {
    {
        TArray<Counted> a;
        for (int i = 0; i < 50; ++i) {
            a.Emplace(i);
        }
        CHECK(Counted::alive == 50);
        a.RemoveAt(10, 5);
        a.RemoveAtSwap(0);
        CHECK(Counted::alive == 44);
        TArray<Counted> b = a;
        CHECK(Counted::alive == 88);
        a = MoveTemp(b);
        CHECK(Counted::alive == 44);
        a.Append(TArray<Counted>{Counted(1), Counted(2)});
        CHECK(Counted::alive == 46);
        a.SetNum(3);
        CHECK(Counted::alive == 3);
        TArray<Counted, TInlineAllocator<4>> inline_array;
        inline_array.Emplace(1);
        TArray<Counted, TInlineAllocator<4>> moved = MoveTemp(inline_array);
        CHECK(moved.Num() == 1);
        CHECK(inline_array.Num() == 0);
        CHECK(Counted::alive == 4);
    }
    CHECK(Counted::alive == 0);
}

TEST_CASE("Core: TArray sorts, and sorts pointers by what they point to") {
    TArray<int32> a = {3, 1, 2};
    a.Sort();
    CHECK(join(a) == "1,2,3");
    a.Sort([](int32 x, int32 y) { return x > y; });
    CHECK(join(a) == "3,2,1");
    int32 one = 1, two = 2;
    TArray<int32*> pointers = {&two, &one};
    pointers.Sort([](const int32& x, const int32& y) { return x < y; });
    CHECK(*pointers[0] == 1);
    TArray<int32> heap = {5, 1, 4, 2};
    heap.Heapify();
    heap.HeapPush(0);
    int32 top = -1;
    heap.HeapPop(top);
    CHECK(top == 0);
    heap.HeapPop(top);
    CHECK(top == 1);
}

TEST_CASE("Core: removal while iterating") {
    TArray<int32> a = {1, 2, 3, 4, 5, 6};
    for (auto it = a.CreateIterator(); it; ++it) {
        if (*it % 2 == 0) {
            it.RemoveCurrent();
        }
    }
    CHECK(join(a) == "1,3,5");
    TMap<int32, int32> m = {{1, 10}, {2, 20}, {3, 30}};
    for (auto it = m.CreateIterator(); it; ++it) {
        if (it.Key() == 2) {
            it.RemoveCurrent();
        }
    }
    CHECK(m.Num() == 2);
    CHECK(!m.Contains(2));
}

TEST_CASE("Core: views") {
    TArray<int32> a = {1, 2, 3, 4};
    TArrayView<int32> view = a;
    view[0] = 9;
    CHECK(a[0] == 9);
    CHECK(join(view.Slice(1, 2)) == "2,3");
    CHECK(join(view.RightChop(3)) == "4");
    TConstArrayView<int32> constant = a;
    CHECK(constant.Contains(3));
    CHECK(MakeArrayView({1, 2}).Num() == 2);
    int32 c_array[3] = {1, 2, 3};
    CHECK(MakeArrayView(c_array).Num() == 3);
}

TEST_CASE("Core: TMap") {
    TMap<FString, int32> m;
    m.Add(TEXT("One"), 1);
    m.Add(TEXT("Two"), 2);
    m.Add(TEXT("one"), 11);
    CHECK_MESSAGE(m.Num() == 2, "FString keys are equal without case");
    CHECK(m[TEXT("ONE")] == 11);
    CHECK(m.FindRef(TEXT("three")) == 0);
    CHECK(m.Find(TEXT("three")) == nullptr);
    m.FindOrAdd(TEXT("Three")) = 3;
    TArray<FString> keys;
    m.GetKeys(keys);
    CHECK(keys.Num() == 3);
    CHECK_MESSAGE(text(keys[2]) == "Three", "iteration is in order of insertion");
    m.ValueSort([](int32 a, int32 b) { return a < b; });
    TArray<int32> values;
    m.GenerateValueArray(values);
    CHECK(join(values) == "2,3,11");
    CHECK(m.FindChecked(TEXT("two")) == 2);
    int32 removed = 0;
    CHECK(m.RemoveAndCopyValue(TEXT("two"), removed));
    CHECK(removed == 2);
    CHECK(m.Remove(TEXT("two")) == 0);
    const int32* found = m.FindKey(3) ? m.Find(*m.FindKey(3)) : nullptr;
    REQUIRE(found);
    CHECK(*found == 3);
}

TEST_CASE("Core: maps and sets of many elements") {
    TMap<int32, int32> m;
    for (int32 i = 0; i < 10000; ++i) {
        m.Add(i * 7, i);
    }
    for (int32 i = 0; i < 10000; i += 2) {
        CHECK(m.Remove(i * 7) == 1);
    }
    CHECK(m.Num() == 5000);
    bool all = true;
    for (int32 i = 0; i < 10000; ++i) {
        all = all && (m.Contains(i * 7) == (i % 2 == 1));
    }
    CHECK(all);
    m.Compact();
    CHECK(m.GetMaxIndex() == 5000);
    CHECK(m[7] == 1);
    {
        TSet<Counted> s;
        for (int i = 0; i < 1000; ++i) {
            s.Add(Counted(i % 100));
        }
        CHECK(s.Num() == 100);
        CHECK(Counted::alive == 100);
        TSet<Counted> copy = s;
        CHECK(copy.Num() == 100);
        CHECK(copy.Includes(s));
    }
    CHECK(Counted::alive == 0);
}

TEST_CASE("Core: TSet algebra and TMultiMap") {
    TSet<int32> a = {1, 2, 3}, b = {2, 3, 4};
    CHECK(a.Union(b).Num() == 4);
    CHECK(a.Intersect(b).Num() == 2);
    CHECK(join(a.Difference(b)) == "1");
    bool already = false;
    a.Add(2, &already);
    CHECK(already);
    TMultiMap<FName, int32> multi;
    multi.Add("x", 1);
    multi.Add("x", 2);
    multi.Add("y", 3);
    TArray<int32> values;
    multi.MultiFind("X", values, true);
    CHECK(join(values) == "1,2");
    CHECK(multi.Num(FName("x")) == 2);
    CHECK(multi.Remove("x", 1) == 1);
    CHECK(multi.Num() == 2);
}

TEST_CASE("Core: FScriptArray sees a TArray") {
    TArray<FString> a = {TEXT("a"), TEXT("b")};
    FScriptArray& script = reinterpret_cast<FScriptArray&>(a);
    CHECK(script.Num() == 2);
    const int32 index = script.AddZeroed(1, sizeof(FString), alignof(FString));
    CHECK(index == 2);
    static_cast<FString*>(script.GetData())[index] = TEXT("c");
    CHECK(text(a[2]) == "c");
    static_cast<FString*>(script.GetData())[0].~FString();
    script.Remove(0, 1, sizeof(FString), alignof(FString));
    CHECK(text(a[0]) == "b");
}

TEST_CASE("Core: FScriptMap and FScriptSet see TMap and TSet") {
    const auto hash_int = [](const void* key) { return GetTypeHash(*static_cast<const int32*>(key)); };
    const auto same_int = [](const void* a, const void* b) {
        return *static_cast<const int32*>(a) == *static_cast<const int32*>(b);
    };

    TMap<int32, double> m;
    m.Add(1, 1.5);
    FScriptMap& script = reinterpret_cast<FScriptMap&>(m);
    const FScriptMapLayout layout =
        FScriptMap::GetScriptLayout(sizeof(int32), alignof(int32), sizeof(double), alignof(double));
    using Pair = TPair<int32, double>;
    CHECK(layout.ValueOffset == static_cast<int32>(offsetof(Pair, Value)));
    CHECK(layout.SetLayout.Size == static_cast<int32>(sizeof(TSetElement<TPair<int32, double>>)));
    for (int32 key = 2; key <= 40; ++key) {
        const int32 index = script.AddUninitialized(layout);
        auto* pair = static_cast<TPair<int32, double>*>(script.GetData(index, layout));
        new (pair) TPair<int32, double>(key, key + 0.5);
    }
    script.Rehash(layout, hash_int);
    CHECK(m.Num() == 40);
    CHECK(m[40] == 40.5);
    CHECK(m[1] == 1.5);
    int32 key = 17;
    CHECK(script.FindPairIndex(&key, layout, hash_int, same_int) != INDEX_NONE);
    CHECK(*reinterpret_cast<double*>(script.FindValue(&key, layout, hash_int, same_int)) == 17.5);
    script.RemoveAt(script.FindPairIndex(&key, layout, hash_int, same_int), layout);
    CHECK(!m.Contains(17));
    CHECK(m.Num() == 39);
    m.Add(17, 3.0);
    CHECK(script.Num() == 40);

    TSet<int32> s = {5};
    FScriptSet& script_set = reinterpret_cast<FScriptSet&>(s);
    const FScriptSetLayout set_layout = FScriptSet::GetScriptLayout(sizeof(int32), alignof(int32));
    for (int32 value = 0; value < 20; ++value) {
        script_set.Add(
            &value, set_layout, hash_int, same_int, [&](void* slot) { *static_cast<int32*>(slot) = value; },
            [](void*) {});
    }
    CHECK(s.Num() == 20);
    CHECK(s.Contains(19));
    CHECK(script_set.FindIndex(&key, set_layout, hash_int, same_int) != INDEX_NONE);
}

TEST_CASE("Core: sparse arrays keep indices") {
    TSparseArray<FString> a;
    const int32 x = a.Add(TEXT("x"));
    const int32 y = a.Add(TEXT("y"));
    const int32 z = a.Add(TEXT("z"));
    a.RemoveAt(y);
    CHECK(a.Num() == 2);
    CHECK(!a.IsValidIndex(y));
    CHECK(text(a[z]) == "z");
    CHECK(a.Add(TEXT("w")) == y);
    CHECK(text(a[x]) == "x");
}

TEST_CASE("Core: queue, tuple, optional, static and indirect arrays") {
    TQueue<int32, EQueueMode::Mpsc> queue;
    queue.Enqueue(1);
    queue.Enqueue(2);
    int32 out = 0;
    CHECK(queue.Dequeue(out));
    CHECK(out == 1);
    CHECK(*queue.Peek() == 2);
    CHECK(queue.Pop());
    CHECK(!queue.Dequeue(out));

    auto [a, b, c] = MakeTuple(1, 2.5, FString(TEXT("three")));
    CHECK(a == 1);
    CHECK(b == 2.5);
    CHECK(text(c) == "three");

    TOptional<FString> optional;
    CHECK(!optional.IsSet());
    optional = FString(TEXT("set"));
    CHECK(text(optional.GetValue()) == "set");
    CHECK(text(TOptional<FString>().Get(TEXT("default"))) == "default");

    TStaticArray<int32, 3> fixed(4);
    CHECK(join(fixed) == "4,4,4");
    {
        TIndirectArray<Counted> indirect;
        indirect.Add(new Counted(3));
        TIndirectArray<Counted> copy = indirect;
        CHECK(copy[0].value == 3);
        CHECK(Counted::alive == 2);
    }
    CHECK(Counted::alive == 0);
}

TEST_CASE("Core: shared, weak and unique pointers, functions") {
    {
        TWeakPtr<Counted> weak;
        {
            TSharedRef<Counted> strong = MakeShared<Counted>(4);
            weak = strong;
            TSharedPtr<Counted> other = strong;
            CHECK(strong.GetSharedReferenceCount() == 2);
            CHECK(weak.Pin()->value == 4);
        }
        CHECK(!weak.IsValid());
        CHECK(weak.Pin() == nullptr);
        CHECK(Counted::alive == 0);
        TUniquePtr<Counted> unique = MakeUnique<Counted>(1);
        TFunction<int(int)> function = [&unique, big = TArray<int32>{1, 2, 3}](
                                           int x) { return x + unique->value + big.Num(); };
        TFunction<int(int)> copy = function;
        TFunctionRef<int(int)> reference = copy;
        CHECK(copy(10) == 14);
        CHECK(reference(1) == 5);
        TUniqueFunction<int()> moved = [p = MoveTemp(unique)] { return p->value; };
        CHECK(moved() == 1);
    }
    CHECK(Counted::alive == 0);
    struct Self : TSharedFromThis<Self> {};
    TSharedRef<Self> self = MakeShared<Self>();
    CHECK(self->AsShared() == self);
    int deleted = 0;
    {
        TSharedPtr<int> custom = MakeShareable(new int(3), [&deleted](int* p) {
            ++deleted;
            delete p;
        });
        TSharedPtr<int> copy = custom;
    }
    CHECK(deleted == 1);
}
