// SPDX-License-Identifier: MIT
// Delegates and the console.
#include "core_test.h"

#include "HAL/IConsoleManager.h"
#include "Misc/StringOutputDevice.h"

using namespace core_test;

namespace {
struct Listener {
    int calls = 0;
    int sum = 0;
    void on_value(int32 value) {
        ++calls;
        sum += value;
    }
    void on_value_with_payload(int32 value, int32 factor) { sum += value * factor; }
    int32 twice(int32 value) const { return value * 2; }
};
struct SharedListener : Listener, TSharedFromThis<SharedListener> {};
int32 static_calls = 0;
void on_static(int32 value) { static_calls += value; }

DECLARE_DELEGATE_RetVal_OneParam(int32, FIntDelegate, int32) DECLARE_MULTICAST_DELEGATE_OneParam(FIntEvent, int32)
    DECLARE_MULTICAST_DELEGATE_OneParam(FTextEvent, const FString&)
} // namespace

TEST_CASE("Core: single delegates") {
    Listener listener;
    FIntDelegate d;
    CHECK(!d.IsBound());
    d.BindRaw(&listener, &Listener::twice);
    CHECK(d.Execute(4) == 8);
    CHECK(d.IsBoundToObject(&listener));
    d.BindLambda([](int32 v) { return v + 1; });
    CHECK(d.Execute(4) == 5);
    FIntDelegate copy = d;
    d.Unbind();
    CHECK(!d.IsBound());
    CHECK(copy.Execute(1) == 2);
    FSimpleDelegate simple;
    CHECK(!simple.ExecuteIfBound());
    simple.BindLambda([&] { ++listener.calls; });
    CHECK(simple.ExecuteIfBound());
    CHECK(listener.calls == 1);
}

TEST_CASE("Core: multicast delegates, payloads, removal") {
    Listener listener;
    FIntEvent event;
    const FDelegateHandle handle = event.AddRaw(&listener, &Listener::on_value);
    event.AddRaw(&listener, &Listener::on_value_with_payload, 10);
    event.AddStatic(&on_static);
    const FDelegateHandle lambda = event.AddLambda([&](int32 v) { listener.sum += v * 100; });
    static_calls = 0;
    event.Broadcast(2);
    CHECK(listener.sum == 2 + 20 + 200);
    CHECK(static_calls == 2);
    CHECK(event.Remove(handle));
    CHECK(!event.Remove(handle));
    event.Broadcast(1);
    CHECK(listener.sum == 222 + 10 + 100);
    CHECK(event.RemoveAll(&listener) == 1);
    CHECK(event.Remove(lambda));
    CHECK(event.IsBound());
    event.Clear();
    CHECK(!event.IsBound());
}

TEST_CASE("Core: shared listeners are held weakly") {
    FIntEvent event;
    TSharedPtr<SharedListener> listener = MakeShared<SharedListener>();
    event.AddSP(listener.Get(), &SharedListener::on_value);
    event.Broadcast(3);
    CHECK(listener->sum == 3);
    listener.Reset();
    CHECK(!event.IsBound());
    event.Broadcast(3);
}

TEST_CASE("Core: a delegate may change while it is broadcast") {
    FIntEvent event;
    int first = 0, second = 0, late = 0;
    FDelegateHandle second_handle;
    FDelegateHandle self;
    event.AddLambda([&](int32) { ++first; });
    second_handle = event.AddLambda([&](int32) { ++second; });
    // Broadcast goes from the last to the first: this one runs first, removes itself and the next, and adds another.
    self = event.AddLambda([&, kept = FString(TEXT("still mine"))](int32) {
        event.Remove(self);
        event.Remove(second_handle);
        event.AddLambda([&](int32) { ++late; });
        CHECK(text(kept) == "still mine");
    });
    event.Broadcast(0);
    CHECK(first == 1);
    CHECK(second == 0);
    CHECK(late == 0);
    event.Broadcast(0);
    CHECK(first == 2);
    CHECK(late == 1);
    // A nested broadcast.
    FSimpleMulticastDelegate nested;
    int depth = 0;
    nested.AddLambda([&] {
        if (++depth < 3) {
            nested.Broadcast();
        }
    });
    nested.Broadcast();
    CHECK(depth == 3);
    // An argument by reference reaches everyone unchanged.
    FTextEvent texts;
    FString got;
    texts.AddLambda([&](const FString& t) { got += t; });
    texts.AddLambda([&](const FString& t) { got += t; });
    texts.Broadcast(TEXT("ab"));
    CHECK(text(got) == "abab");
}

TEST_CASE("Core: console variables and priorities") {
    IConsoleManager& console = IConsoleManager::Get();
    {
        TAutoConsoleVariable<int32> number(TEXT("coretest.Number"), 3, TEXT("A number."));
        TAutoConsoleVariable<float> fraction(TEXT("coretest.Fraction"), 0.5f, TEXT("A fraction."));
        TAutoConsoleVariable<FString> words(TEXT("coretest.Words"), TEXT("a b"), TEXT("Words."));
        CHECK(number.GetValueOnGameThread() == 3);
        IConsoleVariable* found = console.FindConsoleVariable(TEXT("CORETEST.number"));
        REQUIRE(found);
        CHECK(found->IsVariableInt());
        int changes = 0;
        found->OnChangedDelegate().AddLambda([&](IConsoleVariable* v) { changes += v->GetInt(); });
        found->Set(4, ECVF_SetByGameSetting);
        CHECK(found->GetInt() == 4);
        CHECK(changes == 4);
        found->Set(5, ECVF_SetByConsole);
        found->Set(6, ECVF_SetByCode);
        CHECK_MESSAGE(found->GetInt() == 5, "a set of lower priority is refused");
        found->SetWithCurrentPriority(7);
        CHECK(found->GetInt() == 7);
        CHECK(text(found->GetDefaultValue()) == "3");
        CHECK(text(FString(GetConsoleVariableSetByName(found->GetFlags()))) == "Console");
        fraction->Set(0.1f, ECVF_SetByCode);
        CHECK(fraction->GetFloat() == 0.1f);
        CHECK(text(words->GetString()) == "a b");

        FStringOutputDevice out;
        CHECK(console.ProcessUserConsoleInput(TEXT("coretest.words \"x y\""), out, nullptr));
        CHECK(text(words->GetString()) == "x y");
        CHECK(console.ProcessUserConsoleInput(TEXT("coretest.words"), out, nullptr));
        CHECK(out.Contains(TEXT("x y")));
        CHECK(console.ProcessUserConsoleInput(TEXT("coretest.words ?"), out, nullptr));
        CHECK(out.Contains(TEXT("Words.")));
        CHECK(!console.ProcessUserConsoleInput(TEXT("coretest.nothing 1"), out, nullptr));

        int seen = 0;
        console.ForEachConsoleObjectThatStartsWith(
            FConsoleObjectVisitor::CreateLambda([&](const TCHAR*, IConsoleObject*) { ++seen; }), TEXT("coretest."));
        CHECK(seen == 3);
    }
    CHECK(console.FindConsoleVariable(TEXT("coretest.Number")) == nullptr);
}

TEST_CASE("Core: console variables over variables, commands with arguments") {
    static int32 value = 1;
    static bool flag = false;
    FAutoConsoleVariableRef number(TEXT("coretest.Ref"), value, TEXT(""));
    FAutoConsoleVariableRef boolean(TEXT("coretest.Flag"), flag, TEXT(""), ECVF_ReadOnly);
    IConsoleManager& console = IConsoleManager::Get();
    FStringOutputDevice out;
    CHECK(console.ProcessUserConsoleInput(TEXT("coretest.Ref 12"), out, nullptr));
    CHECK(value == 12);
    CHECK(console.ProcessUserConsoleInput(TEXT("coretest.Flag true"), out, nullptr));
    CHECK_MESSAGE(!flag, "read-only variables refuse the console");
    console.FindConsoleVariable(TEXT("coretest.Flag"))->Set(true);
    CHECK(flag);

    TArray<FString> got;
    FAutoConsoleCommandWithWorldAndArgs command(TEXT("coretest.Command"), TEXT("help"),
        FConsoleCommandWithWorldAndArgsDelegate::CreateLambda(
            [&](const TArray<FString>& args, UWorld*) { got = args; }));
    CHECK(console.ProcessUserConsoleInput(TEXT("coretest.Command one \"two three\" 4"), out, nullptr));
    REQUIRE(got.Num() == 3);
    CHECK(text(got[1]) == "two three");
}
